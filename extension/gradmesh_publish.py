#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""File > Save a Copy as SVG with meshes as pictures."""

from gradmesh_effect import GradmeshOutput, gradmesh, refusals_as_sentences


class Publish(GradmeshOutput):
    """Writes a copy for programs that cannot paint gradient meshes."""

    def add_arguments(self, pars):
        super().add_arguments(pars)
        pars.add_argument("--scale", type=float, default=2)

    def save(self, stream):
        self.readable(self.meshes.ids)
        with refusals_as_sentences():
            gradmesh.publish(self.meshes, scale=self.options.scale)
        stream.write(self.meshes.to_bytes())


if __name__ == "__main__":
    Publish().run()
