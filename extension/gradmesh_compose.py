#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""File > Save a Copy as code of Jetpack Compose."""

from gradmesh_code import CodeOutput


class Compose(CodeOutput):
    """Writes Kotlin."""

    def __init__(self):
        super().__init__("compose")


if __name__ == "__main__":
    Compose().run()
