#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""File > Open and Import of the meshes of a PDF: an SVG document that has them alone."""

import os

from gradmesh_effect import Gradmesh, gradmesh, refusals_as_sentences
from gradmesh_inkex import Boolean, InputExtension
from gradmesh_text import _, first_of
from gradmesh_toast import toast


class Pdf(Gradmesh, InputExtension):
    """Makes an SVG document of the meshes."""

    #: So that inkex takes this class for that of Illustrator's files, too.
    multi_inx = True

    def add_arguments(self, pars):
        super().add_arguments(pars)
        pars.add_argument("--page", type=int, default=0)
        pars.add_argument("--password", default="")
        pars.add_argument("--all_layers", type=Boolean, default=False)

    def load(self, stream):
        with refusals_as_sentences():
            name = os.path.basename(self.options.input_file)
            read = gradmesh.loads(
                stream.read(),
                name,
                _,
                page=self.options.page or None,
                password=self.options.password,
                all_layers=self.options.all_layers,
            )
        if read.left_out:
            toast(" ".join(first_of(read.left_out)))
        return read.to_bytes()


if __name__ == "__main__":
    Pdf().run()
