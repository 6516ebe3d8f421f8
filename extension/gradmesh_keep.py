#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Keeps a drawing that Inkscape replaces by a copy of it, in which meshes are pictures.

Inkscape proposes the drawing's own name for a copy, asks only whether to replace the file, and writes
it when the extension has ended, which is told no name. So a program waits beside: where the copy comes
to lie over the drawing, it gives the copy another name and the drawing its own.
"""

import hashlib
import os
import subprocess
import sys
import time
from pathlib import Path

from gradmesh_log import log, send_stderr_to_the_log
from gradmesh_text import _
from gradmesh_toast import start

PATIENCE = 20  # seconds in which Inkscape has written the copy
POLL = 0.1


def keep(drawing, copy):
    """Returns once the drawing is safe from becoming the bytes of its copy."""
    child = start([__file__, drawing, hashlib.sha256(copy).hexdigest()], stdout=subprocess.PIPE)
    child.stdout.readline()  # by then it has read the drawing
    child.stdout.close()


def watch(drawing, digest):
    """Gives the drawing back once the copy lies over it; the copy's name then, otherwise nothing."""
    written, original = version(drawing), drawing.read_bytes()
    print("ready", flush=True)
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        time.sleep(POLL)
        now = version(drawing)
        if now == written:
            continue
        written = now
        try:
            found = drawing.read_bytes()
        except OSError:  # between two writes
            continue
        if hashlib.sha256(found).hexdigest() == digest:
            return give_back(drawing, original)
    return None


def version(file):
    """What tells one writing of a file from another, or nothing where the file is not there."""
    try:
        now = file.stat()
    except OSError:
        return None
    return now.st_mtime_ns, now.st_size


def give_back(drawing, original):
    beside = free_name(drawing)
    spare = drawing.with_name(beside.name + "~")
    spare.write_bytes(original)
    os.replace(drawing, beside)
    os.replace(spare, drawing)
    return beside


def free_name(drawing):
    """A name beside the drawing that no file has."""
    number, end = 1, ""
    while (name := drawing.with_name(f"{drawing.stem}-pictures{end}{drawing.suffix}")).exists():
        number += 1
        end = f"-{number}"
    return name


def tell(drawing, beside):
    text = _("{drawing} stays as it is, with its meshes; the copy, with pictures, is {copy} beside it.").format(
        drawing=drawing.name, copy=beside.name
    )
    log(text)
    from gradmesh_window import toolkit

    gtk, _glib = toolkit()
    if gtk is None:
        return
    from gradmesh_theme import prefer_dark

    prefer_dark()
    dialog = gtk.MessageDialog(text=text, buttons=gtk.ButtonsType.CLOSE, title=_("Gradient Mesh"))
    dialog.set_position(gtk.WindowPosition.CENTER)
    dialog.set_keep_above(True)
    dialog.run()


def main(drawing, digest):
    send_stderr_to_the_log()
    beside = watch(Path(drawing), digest)
    if beside:
        tell(Path(drawing), beside)


if __name__ == "__main__":
    main(*sys.argv[1:])
