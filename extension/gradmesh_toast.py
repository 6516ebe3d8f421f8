#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Says what became of a mesh for some seconds, in a window that takes neither a click nor the focus.

By design the picture looks as before, and Inkscape gives an extension no other place to say that something
happened. The window is a program of its own, since Inkscape waits until the extension has ended.
"""

import subprocess
import sys

from gradmesh_attended import ATTENDED
from gradmesh_log import log, send_stderr_to_the_log
from gradmesh_window import stderr_in_the_log, toolkit

SECONDS, SECONDS_PER_LETTER = 3, 0.03
MARGIN = 72  # pixels to the lower end of the screen


def toast(text):
    """Says it where somebody is, and in the log."""
    log(text)
    if ATTENDED:
        start([__file__, text])


def is_seen():
    """Whether toast() reaches somebody."""
    with stderr_in_the_log():
        return ATTENDED and toolkit()[0] is not None


def start(arguments, **how):
    """Starts a program of the extension's that lives on when the extension has ended."""
    child = subprocess.Popen(
        [sys.executable, *arguments],
        stdin=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
        creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        **{"stdout": subprocess.DEVNULL, **how},
    )
    child.returncode = 0  # it is not waited for, of which Python would warn, and Inkscape show that
    return child


def show(text):
    gtk, glib = toolkit()
    if gtk is None:
        return
    from gi.repository import Gdk
    from gradmesh_theme import prefer_dark

    prefer_dark()
    window = gtk.Window(title="gradmesh", accept_focus=False, focus_on_map=False, decorated=False)
    window.set_type_hint(Gdk.WindowTypeHint.NOTIFICATION)
    window.set_keep_above(True)
    window.set_resizable(False)
    window.get_style_context().add_class("osd")
    label = gtk.Label(label=text, wrap=True, max_width_chars=64, margin=16)
    window.add(label)
    label.show()
    monitor = Gdk.Display.get_default()
    monitor = monitor.get_primary_monitor() or monitor.get_monitor(0)
    room, size = monitor.get_workarea(), window.get_preferred_size()[1]
    window.move(room.x + (room.width - size.width) // 2, room.y + room.height - size.height - MARGIN)
    window.show()
    glib.timeout_add(round(1000 * (SECONDS + SECONDS_PER_LETTER * len(text))), gtk.main_quit)
    gtk.main()


if __name__ == "__main__":
    send_stderr_to_the_log()
    show(sys.argv[1])
