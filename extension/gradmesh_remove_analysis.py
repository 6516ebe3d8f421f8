#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Extensions > Gradient Mesh > Remove Analysis: takes away the layers of Show Analysis."""

from gradmesh_effect import MARK, Gradmesh, NothingToDo
from gradmesh_inkex import EffectExtension
from gradmesh_text import _


class RemoveAnalysis(Gradmesh, EffectExtension):
    """Removes the layers that Show Analysis has added."""

    def effect(self):
        layers = [element for element in self.svg.iter("{*}g") if element.get(MARK)]
        if not layers:
            raise NothingToDo(_("There is no analysis in this document."))
        for layer in layers:
            layer.getparent().remove(layer)


if __name__ == "__main__":
    RemoveAnalysis().run()
