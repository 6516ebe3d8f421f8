#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""File > Save a Copy as code of SwiftUI."""

from gradmesh_effect import GradmeshOutput, gradmesh, refusals_as_sentences


class Swift(GradmeshOutput):
    """Writes the meshes of the document as code for apps."""

    def save(self, stream):
        self.readable(self.meshes.ids)
        with refusals_as_sentences():
            made = gradmesh.publish_code(self.meshes, "swift")
        stream.write(made.source.encode())


if __name__ == "__main__":
    Swift().run()
