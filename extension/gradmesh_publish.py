#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""File > Save a Copy as SVG with meshes as pictures."""

import os

from gradmesh_attended import ATTENDED
from gradmesh_effect import GradmeshOutput, gradmesh, refusals_as_sentences
from gradmesh_keep import keep


class Publish(GradmeshOutput):
    """Writes a copy for programs that cannot paint gradient meshes."""

    def add_arguments(self, pars):
        super().add_arguments(pars)
        pars.add_argument("--scale", type=float, default=2)

    def save(self, stream):
        self.readable(self.meshes.ids)
        with refusals_as_sentences():
            gradmesh.publish(self.meshes, scale=self.options.scale)
        copy = self.meshes.to_bytes()
        stream.write(copy)
        drawing = os.environ.get("DOCUMENT_PATH")
        if ATTENDED and drawing and os.path.isfile(drawing):
            keep(drawing, copy)


if __name__ == "__main__":
    Publish().run()
