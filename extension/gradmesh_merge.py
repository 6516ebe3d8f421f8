#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Extensions > Gradient Mesh > Merge Selected Patches: one patch of the selected blocks, or of a part of one."""

from gradmesh_attended import ATTENDED
from gradmesh_effect import (
    MORE_THAN_STRONG,
    STRONG,
    GradmeshEffect,
    News,
    gradmesh,
    refusals_as_sentences,
)
from gradmesh_inkex import Boolean
from gradmesh_report import report
from gradmesh_text import _


class Merge(GradmeshEffect):
    """Makes one patch of the selected blocks of a simplified mesh, or of a part of the one that is selected."""

    def add_arguments(self, pars):
        super().add_arguments(pars)
        pars.add_argument("--tab")  # the page that was open, which Inkscape passes too
        pars.add_argument("--tell", type=Boolean, default=True)
        for name in ("first_row", "last_row", "first_column", "last_column"):
            pars.add_argument(f"--{name}", type=int, default=0)

    def effect(self):
        options = self.options
        if not options.ids:
            raise News(
                _(
                    "Select two or more blocks of a simplified mesh: double-click it, then Shift+click. Simplify by "
                    "Eye merges patches of any mesh, and shows before what that costs."
                )
            )
        self.chosen_elements()
        with refusals_as_sentences():
            edit = gradmesh.merge(self.meshes, options.ids, **self.part())
        report.meshes = [edit]
        self.take_over()
        if ATTENDED and options.tell:
            self.tell(" ".join(self.what_became(edit)))

    def part(self):
        """The rows and columns of the one block that is selected; all where there are several."""
        options = self.options
        if len(options.ids) > 1:
            return {}
        ends = {
            "rows": (options.first_row, options.last_row or options.first_row),
            "columns": (options.first_column, options.last_column or options.first_column),
        }
        return {lines: (first, last) for lines, (first, last) in ends.items() if first}

    def what_became(self, edit):
        yield _(
            "{id}: these patches are one now. The error is FLIP {error:.4f}, and {handles} handles and {patches} "
            "patches are left."
        ).format(id=self.called(edit.id), error=edit.error, handles=edit.handles_after, patches=edit.patches_after)
        if edit.error > STRONG["flip"]:
            yield MORE_THAN_STRONG


if __name__ == "__main__":
    Merge().run()
