#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""File > Open and Import of the meshes of Illustrator's file: of the PDF that it holds."""

from gradmesh_pdf import Pdf


class Ai(Pdf):
    """Makes an SVG document of the meshes. Inkscape has one ending for each type of file."""


if __name__ == "__main__":
    Ai().run()
