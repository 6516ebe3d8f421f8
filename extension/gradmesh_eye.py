# SPDX-License-Identifier: GPL-2.0-or-later
"""The window of Simplify by Eye, which is that of the program: `gradmesh eye`."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from gradmesh.helper import find_program, make_executable, no_program
from gradmesh_log import log
from gradmesh_text import LANGUAGE, _, sentence, translated
from gradmesh_theme import inkscape_is_dark

#: What the program says before a sentence of its own.
PREFIX = "gradmesh: "


class NoWindow(Exception):
    """Raised with the sentence that says why there is none."""


def simplify_by_eye(document, name, ids, folders):
    """Shows the window until a person closes it. Returns the document as it is then, and what is told of the
    meshes that were changed, as of `gradmesh simplify --report`; None where nothing was applied.

    document: bytes, whose ending `name` has. ids: the meshes that are shown. folders: where linked pictures are
    looked for.
    """
    with tempfile.TemporaryDirectory(prefix="gradmesh-") as folder:
        # Sentences about the document call it by the name that the program is given, so that has no folder.
        before, after, report = (Path(folder) / each for each in ("before", "after", "report"))
        before.mkdir()
        (before / name).write_bytes(document)
        options = ["--output", str(after), "--report", str(report), *looks(), *(f"--id={each}" for each in ids)]
        options += [f"--folder={each}" for each in folders]
        # Inkscape waits for what it has started: its window would only cover this one.
        options += ["--above= - Inkscape"]
        run([program(), "eye", *options, "--", name], before)
        if not after.exists():
            return None
        return after.read_bytes(), json.loads(report.read_text(encoding="utf-8"))["meshes"]


def program():
    found = find_program() or shutil.which("gradmesh")
    if found is None:
        raise NoWindow(translated(no_program().message))
    make_executable(Path(found))
    return os.path.abspath(found)


def looks():
    """The options that let the window be as Inkscape is."""
    is_dark = inkscape_is_dark()
    theme = [] if is_dark is None else ["--theme", "dark" if is_dark else "light"]
    return [*theme, "--language", LANGUAGE]


def run(command, folder):
    """Runs a command in a folder. Raises NoWindow where the program says that it cannot do it."""
    how = {"creationflags": subprocess.CREATE_NO_WINDOW} if sys.platform == "win32" else {}
    try:
        done = subprocess.run(
            command,
            cwd=folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            check=False,
            **how,
        )
    except OSError as error:
        raise NoWindow(_("The program {program} cannot be started ({error}).").format(program=command[0], error=error))
    # What a desktop's libraries grumble would open a dialog in Inkscape.
    said = done.stderr.decode("utf-8", "replace").strip()
    if said:
        log(said)
    if done.returncode != 0:
        told = [line[len(PREFIX) :] for line in said.splitlines() if line.startswith(PREFIX)]
        raise NoWindow(
            sentence(told[-1][:1].upper() + told[-1][1:])
            if told
            else _("The window has ended by a fault ({code}); the document is as it was.").format(code=done.returncode)
        )
