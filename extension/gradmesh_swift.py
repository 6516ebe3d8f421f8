#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""File > Save a Copy as code of SwiftUI."""

from gradmesh_code import CodeOutput


class Swift(CodeOutput):
    """Writes Swift."""

    def __init__(self):
        super().__init__("swift")


if __name__ == "__main__":
    Swift().run()
