#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""File > Open of .hemesh files: an SVG document with the mesh."""

import os

from gradmesh_effect import Gradmesh, gradmesh, refusals_as_sentences
from gradmesh_inkex import InputExtension
from gradmesh_text import _


class Open(Gradmesh, InputExtension):
    """Makes an SVG document of a .hemesh file."""

    def load(self, stream):
        with refusals_as_sentences():
            name = os.path.basename(self.options.input_file)
            mesh = gradmesh.loads(stream.read(), name, _)
            return gradmesh.convert(mesh, "svg").document.to_bytes()


if __name__ == "__main__":
    Open().run()
