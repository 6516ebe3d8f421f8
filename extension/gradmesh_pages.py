#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Extensions > Gradient Mesh > Meshes of a PDF: puts the meshes of a PDF or of Illustrator's file into the document."""

import os
from pathlib import Path

from gradmesh_effect import GradmeshEffect, News, NothingToDo, gradmesh, refusals_as_sentences
from gradmesh_inkex import AbortExtension, Boolean
from gradmesh_report import report
from gradmesh_text import _, first_of
from gradmesh_window import LongWork

NOT_IN_THE_FILE = ("{0}: there is no gradient mesh on its pages.", "{0}: there is no page {1}; it has {2}.")
CURRENT_LAYER = "{http://www.inkscape.org/namespaces/inkscape}current-layer"
EXPORT_NAME = "{http://www.inkscape.org/namespaces/inkscape}export-filename"
DOCNAME = "{http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd}docname"
NAMED_VIEW = "{http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd}namedview"


class Pages(GradmeshEffect):
    """Adds the meshes where they are seen on their pages."""

    def add_arguments(self, pars):
        super().add_arguments(pars)
        pars.add_argument("--file", default="")
        pars.add_argument("--page", type=int, default=0)
        pars.add_argument("--password", default="")
        pars.add_argument("--all_layers", type=Boolean, default=False)
        pars.add_argument("--into", default="layers")
        pars.add_argument("--replace_tiles", type=Boolean, default=True)

    def effect(self):
        path = self.options.file.strip()
        # Of a field that nobody has filled Inkscape makes the folder of its copy of the document.
        is_chosen = path and not os.path.isdir(path)
        path = path if is_chosen else self.original()
        if not path:
            raise News(
                _(
                    "Choose a PDF or a file of Illustrator: no such file with the document’s name lies beside the "
                    "document."
                )
            )
        title = _("Reading {file}").format(file=os.path.basename(path))
        with refusals_as_sentences(AbortExtension, NOT_IN_THE_FILE):
            inserted = LongWork([title], lambda tell: self.insert(path, tell)).run()
        if inserted.stopped and not inserted.meshes:
            raise NothingToDo(_("It was stopped before a mesh was read; the document stays as it was."))
        report.meshes = inserted.meshes
        self.take_over()
        self.became = list(self.what_became(inserted))
        if not is_chosen:
            self.became.append(_("No file was chosen, so it was {file}.").format(file=os.path.basename(path)))

    def original(self):
        """The file from which the document was probably made: Inkscape tells the name of a PDF that it has opened,
        and what is saved of it mostly lies beside it."""
        document = Path(os.environ.get("DOCUMENT_PATH") or "")
        names = (document.name, self.svg.get(DOCNAME), self.svg.get(EXPORT_NAME))
        for file in [document.parent / name for name in names if name]:
            for each in (file, file.with_suffix(""), file.with_suffix(".pdf"), file.with_suffix(".ai")):
                if each.suffix.lower() in (".pdf", ".ai") and each.is_file():
                    return str(each)
        return None

    def insert(self, path, tell):
        return gradmesh.insert_pages(
            self.meshes,
            path,
            page=self.options.page or None,
            password=self.options.password,
            all_layers=self.options.all_layers,
            into=self.current_layer() if self.options.into == "layer" else "",
            replace_tiles=self.options.replace_tiles,
            progress=tell,
        )

    def current_layer(self):
        """The id of the layer that a person draws in; of the document where there is none."""
        elements = self.elements_by_id()
        for view in self.svg.iter(NAMED_VIEW):
            name = view.get(CURRENT_LAYER)
            if name in elements:
                return name
        return self.svg.get("id") or ""

    def what_became(self, inserted):
        """Sentences on what was read, and on what was not."""
        grids = [mesh for mesh in inserted.meshes if mesh.rows]
        count = len(inserted.meshes)
        if count == 1:
            yield _("One mesh was read.")
        else:
            yield _("{count} meshes were read.").format(count=count)
        if inserted.replaced == 1:
            yield _("It takes the place of the tiles that Inkscape made of it.") if count == 1 else _(
                "One of them takes the place of the tiles that Inkscape made of it."
            )
        elif inserted.replaced:
            yield _("{count} of them take the place of the tiles that Inkscape made of them.").format(
                count=inserted.replaced
            )
        if len(grids) < count:
            yield _("{count} of them are blocks, which Simplify joins.").format(count=count - len(grids))
        if inserted.stopped:
            yield _("It was stopped before the end; Ctrl+Z takes it back.")
        yield from first_of(inserted.left_out)


if __name__ == "__main__":
    Pages().run()
