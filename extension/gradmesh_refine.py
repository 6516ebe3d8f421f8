#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Extensions > Gradient Mesh > Refine Here: splits patches, to add detail in one place."""

from gradmesh_effect import GradmeshEffect, News, gradmesh, refusals_as_sentences
from gradmesh_inkex import Boolean
from gradmesh_report import report
from gradmesh_text import _


class Refine(GradmeshEffect):
    """Splits the patches of the selected block or mesh, here alone or across the whole mesh."""

    def add_arguments(self, pars):
        super().add_arguments(pars)
        pars.add_argument("--tab")  # the page that was open, which Inkscape passes too
        pars.add_argument("--direction", default="both")
        pars.add_argument("--place", type=float, default=50)
        pars.add_argument("--whole", type=Boolean, default=False)
        pars.add_argument("--row", type=int, default=0)
        pars.add_argument("--column", type=int, default=0)

    def effect(self):
        options = self.options
        if len(options.ids) != 1:
            raise News(
                _("Select one block of a simplified mesh, or one object painted by a gradient mesh.")
            )
        self.chosen_elements()
        with refusals_as_sentences():
            edit = gradmesh.refine(
                self.meshes,
                options.ids[0],
                direction=options.direction,
                place=options.place / 100,
                row=options.row or None,
                column=options.column or None,
                whole=options.whole,
            )
        report.meshes = [edit]
        self.take_over()
        self.became = [
            _("{id}: {more} more patches; now it has {handles} handles and {patches} patches.").format(
                id=self.called(edit.id),
                more=edit.patches_after - edit.patches_before,
                handles=edit.handles_after,
                patches=edit.patches_after,
            )
        ]


if __name__ == "__main__":
    Refine().run()
