#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Extensions > Gradient Mesh > Merge Selected Patches: one patch of the selected blocks."""

from gradmesh_effect import GradmeshEffect, gradmesh, refusals_as_sentences
from gradmesh_inkex import AbortExtension
from gradmesh_report import report
from gradmesh_text import _


class Merge(GradmeshEffect):
    """Makes one patch of the selected blocks of a simplified mesh."""

    def effect(self):
        if not self.options.ids:
            raise AbortExtension(
                _("Select two or more blocks of a simplified mesh: double-click it, then Shift+click.")
            )
        self.chosen_elements()
        with refusals_as_sentences():
            report.meshes = [gradmesh.merge(self.meshes, self.options.ids)]
        self.take_over()


if __name__ == "__main__":
    Merge().run()
