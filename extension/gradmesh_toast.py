#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Says what became of a mesh in a line at the lower end of the screen, which does not take the focus.

By design the picture looks as before, and Inkscape gives an extension no other place to say that something
happened. The window is a program of its own, since Inkscape waits until the extension has ended. It stays until it
has been read, and until a click where that is more than a sentence; a click always closes it, and so does the next.
"""

import os
import re
import subprocess
import sys

from gradmesh_attended import ATTENDED
from gradmesh_log import cache_folder, log, send_stderr_to_the_log
from gradmesh_window import stderr_in_the_log, toolkit

SECONDS_TO_NOTICE, WORDS_PER_SECOND = 2, 3
MARGIN = 72  # pixels to the lower end of the screen
POLL = 200  # milliseconds


def toast(text, document=None):
    """Says it where somebody is, and in the log. Inkscape keeps the copy of the document that an extension reads for
    as long as it shows a live preview; the line stays as long."""
    log(text)
    if ATTENDED:
        start([__file__, text, str(document or "")])


def seconds_to_read(text):
    return SECONDS_TO_NOTICE + len(text.split()) / WORDS_PER_SECOND


def stays_until_clicked(text):
    """Whether it is more than a sentence. What one letter stands before, as in "z. B.", ends none."""
    return re.search(r"\S{2}[.!?]\S?\s+\S", text) is not None


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


class Latest:
    """Tells the line that was begun last from those before, which go then."""

    def __init__(self):
        self._file = cache_folder() / "line"
        try:
            self._file.write_text(str(os.getpid()))
        except OSError:
            pass  # each stays as long as it would alone

    def is_another(self):
        try:
            return self._file.read_text() not in ("", str(os.getpid()))
        except OSError:
            return False


def show(text, document=""):
    gtk, glib = toolkit()
    if gtk is None:
        return
    from gi.repository import Gdk
    from gradmesh_theme import prefer_dark

    prefer_dark()
    # A window manager gives the focus of Inkscape's box, which goes now, to nobody if another window comes: this is
    # none that it knows of. On Wayland such a window has to belong to one of the same program.
    is_x11 = "X11" in type(Gdk.Display.get_default()).__name__
    kind = gtk.WindowType.POPUP if is_x11 else gtk.WindowType.TOPLEVEL
    window = gtk.Window(
        type=kind, title="gradmesh", accept_focus=False, focus_on_map=False, decorated=False
    )
    window.set_type_hint(Gdk.WindowTypeHint.NOTIFICATION)
    window.set_keep_above(True)
    window.set_resizable(False)
    window.get_style_context().add_class("osd")
    label = gtk.Label(label=text, wrap=True, max_width_chars=64, margin=16)
    row = gtk.Box(spacing=16)
    row.add(label)
    if stays_until_clicked(text):
        label.set_margin_end(0)
        row.add(gtk.Label(label="✕", margin_end=16))
    window.add(row)
    window.add_events(Gdk.EventMask.BUTTON_PRESS_MASK)
    window.connect("button-press-event", gtk.main_quit)
    row.show_all()
    monitor = Gdk.Display.get_default()
    monitor = monitor.get_primary_monitor() or monitor.get_monitor(0)
    room, size = monitor.get_workarea(), window.get_preferred_size()[1]
    window.move(room.x + (room.width - size.width) // 2, room.y + room.height - size.height - MARGIN)
    window.show()
    latest, left = Latest(), [1000 * seconds_to_read(text)]

    def wait():
        if latest.is_another() or left[0] <= 0:
            gtk.main_quit()
        elif not stays_until_clicked(text) and not os.path.exists(document):
            left[0] -= POLL
        return True

    glib.timeout_add(POLL, wait)
    gtk.main()


if __name__ == "__main__":
    send_stderr_to_the_log()
    show(*sys.argv[1:])
