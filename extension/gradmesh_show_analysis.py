#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Extensions > Gradient Mesh > Show Analysis: a layer with what the methods know of a mesh."""

from itertools import count

from gradmesh_effect import MARK, GradmeshEffect, gradmesh, refusals_as_sentences
from gradmesh_cache import analysis_cache
from gradmesh_inkex import etree, load_svg
from gradmesh_text import _
from gradmesh_window import LongWork

SVG = "{http://www.w3.org/2000/svg}"
INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"

LAYER_NAMES = {
    "edges": _("Edges of {id}"),
    "errors": _("Errors of {id}"),
    "faces": _("Patches of {id}"),
    "motorcycle": _("Motorcycle graph of {id}"),
    "regions": _("Regions of {id}"),
}


class ShowAnalysis(GradmeshEffect):
    """Draws a layer of ordinary paths above the selected meshes."""

    def add_arguments(self, pars):
        super().add_arguments(pars)
        pars.add_argument("--tab")  # the page that was open, which Inkscape passes too
        pars.add_argument("--show", default="errors")
        pars.add_argument("--epsilon", type=float)
        pars.add_argument("--metric")

    def effect(self):
        for name in self.selected_meshes():
            with refusals_as_sentences():
                drawing = LongWork(
                    [_("Analyzing {id}").format(id=self.called(name))], lambda tell: self.draw(name, tell)
                ).run()
            self.svg.append(self.layer(name, drawing))

    def draw(self, name, tell):
        with analysis_cache() as cache:
            return gradmesh.draw(
                self.meshes,
                self.options.show,
                name,
                picture=False,
                metric=self.options.metric,
                epsilon=self.options.epsilon,
                analysis_cache=cache,
                progress=tell,
            )

    def layer(self, name, drawing):
        """The layers of the drawing in one of their own; it is in the document's coordinates."""
        root = load_svg(drawing.encode("utf-8")).getroot()
        layer = etree.Element(
            SVG + "g",
            {
                INKSCAPE + "groupmode": "layer",
                INKSCAPE + "label": LAYER_NAMES[self.options.show].format(id=name),
                MARK: self.options.show,
                "id": self.free_id("analysis"),
                "style": f"font-family:{root.get('font-family')};fill:black",
            },
        )
        for group in root.findall(SVG + "g"):
            layer.append(group)
        etree.cleanup_namespaces(layer)
        return layer

    def free_id(self, stem):
        """The stem with the first number after it that makes an id which is not taken."""
        taken = self.elements_by_id()
        return next(name for name in map(f"{stem}{{}}".format, count(1)) if name not in taken)


if __name__ == "__main__":
    ShowAnalysis().run()
