#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""File > Save As of .hemesh files: the only gradient mesh of the document."""

from gradmesh_effect import GradmeshOutput, gradmesh, refusals_as_sentences
from gradmesh_inkex import AbortExtension
from gradmesh_text import _


class Save(GradmeshOutput):
    """Writes the only gradient mesh of the document, or the selected one, as a .hemesh file."""

    def save(self, stream):
        ids = self.meshes.ids
        if ids:
            ids = self.selected_meshes() if self.options.ids else self.readable(ids)
        if len(ids) != 1:
            raise AbortExtension(
                _("A .hemesh file holds one gradient mesh, but the document has {count}.").format(
                    count=len(ids)
                )
            )
        with refusals_as_sentences():
            made = gradmesh.convert(self.meshes, "hemesh", ids[0])
        if made.lost_opacity:
            raise AbortExtension(
                _("{id} is not opaque everywhere, which a .hemesh file cannot hold.").format(id=ids[0])
            )
        stream.write(made.document.to_bytes())


if __name__ == "__main__":
    Save().run()
