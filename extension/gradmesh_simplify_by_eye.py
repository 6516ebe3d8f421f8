#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Extensions > Gradient Mesh > Simplify by Eye: a window where a person sees what simplifying costs."""

import io
import sys
from contextlib import contextmanager, redirect_stderr

from gradmesh_effect import GradmeshEffect, News, refusals_as_sentences
from gradmesh_attended import ATTENDED
from gradmesh_eye import NoWindow, simplify_by_eye
from gradmesh_inkex import AbortExtension
from gradmesh_lock import only_window
from gradmesh_report import report
from gradmesh_text import _
from gradmesh_toast import is_seen, toast


class SimplifyByEye(GradmeshEffect):
    """Opens the window over the selected gradient meshes, or all where nothing is selected."""

    def run(self, *args, **keywords):
        with said_by_the_line():
            super().run(*args, **keywords)

    def effect(self):
        ids = self.selected_or_all()
        with only_window() as is_alone, refusals_as_sentences():
            if not is_alone:
                raise News(_("Simplify by Eye is open on this document already."))
            applied = self.show(ids)
            if applied is None:
                report.outcome = "unchanged"
                return
            document, report.meshes = applied
            self.load_meshes(document)
        self.take_over()

    def show(self, ids):
        """What was applied, as of simplify_by_eye()."""
        if not ATTENDED:
            raise AbortExtension(by_numbers(_("Nobody is there who could see a window.")))
        try:
            return simplify_by_eye(self.meshes.to_bytes(), self.document_name, ids, self.folders)
        except NoWindow as reason:
            raise AbortExtension(by_numbers(reason)) from reason


@contextmanager
def said_by_the_line():
    """Shows what is written to stderr, so faults too, as the line at the lower end of the screen, where that can be
    seen: Inkscape 1.3 passes over it."""
    said = io.StringIO()
    try:
        with redirect_stderr(said):
            yield
    finally:
        text = said.getvalue().strip()
        if text and is_seen():
            toast(text)
        elif text:
            print(text, file=sys.stderr)


def by_numbers(reason):
    """A reason, and what helps."""
    return "{} {}".format(reason, _("Extensions > Gradient Mesh > Simplify does the same by numbers."))


if __name__ == "__main__":
    SimplifyByEye().run()
