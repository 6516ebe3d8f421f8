#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Extensions > Gradient Mesh > Update after Editing: blocks that were edited fit together again."""

from gradmesh_effect import GradmeshEffect, NothingToDo, gradmesh, refusals_as_sentences
from gradmesh_report import report
from gradmesh_text import _


class Update(GradmeshEffect):
    """Makes the blocks of the selected simplified meshes fit together after they were edited."""

    def effect(self):
        ids = self.selected_meshes()
        with refusals_as_sentences():
            results = gradmesh.update(self.meshes, ids)
        report.meshes = results
        if not any(result.changed for result in results):
            raise NothingToDo(
                _("{meshes}: all blocks fit together, so there was nothing to do.").format(
                    meshes=", ".join(self.called(result.id) for result in results)
                )
            )
        self.take_over()
        text = _("{id}: its {objects} blocks fit together again; they have {handles} handles.")
        self.became = [
            text.format(id=self.called(result.id), objects=result.objects, handles=result.handles)
            for result in results
            if result.changed
        ]


if __name__ == "__main__":
    Update().run()
