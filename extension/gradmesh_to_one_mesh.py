#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Extensions > Gradient Mesh > To One Mesh: blocks become one ordinary mesh gradient again."""

from gradmesh_effect import GradmeshEffect, gradmesh, refusals_as_sentences
from gradmesh_report import report


class ToOneMesh(GradmeshEffect):
    """Makes one ordinary mesh gradient of each selected simplified mesh, refined as needed."""

    def effect(self):
        ids = self.selected_meshes()
        with refusals_as_sentences():
            report.meshes = gradmesh.to_one_mesh(self.meshes, ids)
        self.take_over()


if __name__ == "__main__":
    ToOneMesh().run()
