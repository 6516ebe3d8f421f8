# SPDX-License-Identifier: GPL-2.0-or-later
"""What File > Save a Copy as code for apps shares."""

from gradmesh_effect import GradmeshOutput, gradmesh, refusals_as_sentences
from gradmesh_text import first_of
from gradmesh_toast import toast


class CodeOutput(GradmeshOutput):
    """Writes the meshes of the document as code in a language of `publish_code()`."""

    def __init__(self, language):
        super().__init__()
        self.language = language

    def save(self, stream):
        self.readable(self.meshes.ids)
        with refusals_as_sentences():
            made = gradmesh.publish_code(self.meshes, self.language)
        stream.write(made.source.encode())
        lost = [why for mesh in made.meshes for why in mesh.lost]
        if lost:
            toast(" ".join(first_of(lost)))
