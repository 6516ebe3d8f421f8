#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Extensions > Gradient Mesh > To One Mesh: blocks become one ordinary mesh gradient again."""

from gradmesh_effect import GradmeshEffect, gradmesh, refusals_as_sentences
from gradmesh_report import report
from gradmesh_text import _


class ToOneMesh(GradmeshEffect):
    """Makes one ordinary mesh gradient of each selected simplified mesh, refined as needed."""

    def effect(self):
        ids = self.selected_meshes()
        with refusals_as_sentences():
            report.meshes = gradmesh.to_one_mesh(self.meshes, ids)
        self.take_over()
        text = _("{id}: one mesh of {handles} handles; Simplify takes out those that nobody needs.")
        self.became = [text.format(id=self.called(mesh.id), handles=mesh.handles_after) for mesh in report.meshes]


if __name__ == "__main__":
    ToOneMesh().run()
