#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Extensions > Gradient Mesh > Simplify by Eye: a window where a person sees what simplifying costs."""

from gradmesh_effect import GradmeshEffect, refusals_as_sentences
from gradmesh_attended import ATTENDED
from gradmesh_eye import Eye
from gradmesh_inkex import AbortExtension
from gradmesh_lock import only_window
from gradmesh_report import report
from gradmesh_text import _
from gradmesh_window import stderr_in_the_log, toolkit


class SimplifyByEye(GradmeshEffect):
    """Opens the window over the selected gradient meshes, or all where nothing is selected."""

    def effect(self):
        ids = self.selected_or_all()
        with stderr_in_the_log(), only_window() as is_alone, refusals_as_sentences():
            self.check(is_alone)
            eye = Eye(self.meshes, ids)
            applies = self.show(eye)
            if applies:
                report.meshes = eye.apply()
            else:
                eye.close()
        if applies:
            self.take_over()
        else:
            report.outcome = "unchanged"

    def check(self, is_alone):
        if not ATTENDED or toolkit()[0] is None:
            raise AbortExtension(
                _(
                    "There is no window here in which something could be seen (it needs GTK 3 for Python); "
                    "Extensions > Gradient Mesh > Simplify does the same by numbers."
                )
            )
        if not is_alone:
            raise AbortExtension(_("Simplify by Eye is open on this document already."))

    def show(self, eye):
        from gradmesh_eye_window import EyeWindow

        return EyeWindow(eye).run()


if __name__ == "__main__":
    SimplifyByEye().run()
