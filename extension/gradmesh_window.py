# SPDX-License-Identifier: GPL-2.0-or-later
"""A small window beside long work: how far it is, and a button that stops it.

Inkscape waits for an extension, blocked, and cannot stop it. The window opens only where the work
takes longer than a person waits without wondering; without a person, GTK or a display the work runs
alone, as long as it is allowed to take.
"""

import os
import sys
import threading
import warnings
from contextlib import contextmanager

from gradmesh_attended import ATTENDED
from gradmesh_log import log_once, send_stderr_to_the_log
from gradmesh_text import _

PATIENCE = 1.5  # seconds until the window opens
REFRESH = 100  # milliseconds
LARGEST_PICTURE = 320  # pixels


class LongWork:
    """Runs work(progress) in a thread of its own; progress is that of gradmesh.simplify().

    titles: what is being done, for each of the meshes, or one for all.
    """

    def __init__(self, titles, work):
        self._titles = titles
        self._work = work
        self._ended = threading.Event()
        self._stop = False
        self._now, self._handles = None, 0
        #: What the result so far looks like: width, height and bytes, three for each pixel; or nothing.
        self.picture = None
        self._result = self._failure = None

    def run(self):
        """What the work returns or raises; where it was stopped it says so itself."""
        thread = threading.Thread(target=self._run, daemon=True)
        thread.start()
        if not self._ended.wait(PATIENCE) and ATTENDED:
            with stderr_in_the_log():
                show(self)
        thread.join()
        if self._failure:
            raise self._failure
        return self._result

    def _run(self):
        try:
            self._result = self._work(self._progress)
        except BaseException as failure:  # pylint: disable=broad-except
            self._failure = failure
        finally:
            self._ended.set()

    def _progress(self, now):
        self._now = now
        self._handles = now.handles or self._handles
        return not self._stop

    def show(self, *picture):
        """Takes a picture of the result so far, which the window shows."""
        self.picture = picture

    @property
    def ended(self):
        return self._ended.is_set()

    @property
    def share(self):
        """How much is done of all meshes, 0 to 1."""
        now = self._now
        if not now:
            return 0
        return (now.mesh + (min(now.done / now.total, 1) if now.total else 0)) / now.meshes

    @property
    def title(self):
        """What is being done now."""
        return self._titles[self._now.mesh if self._now and len(self._titles) > 1 else 0]

    @property
    def words(self):
        if self._stop:
            return _("Stopping: the best so far is kept …")
        if self._handles:
            return _("{handles} handles so far").format(handles=self._handles)
        if self._now and self._now.patches:
            return _("{patches} patches so far").format(patches=self._now.patches)
        return _("Preparing …")

    @property
    def stopped(self):
        """Whether a person has stopped it."""
        return self._stop

    def stop(self):
        self._stop = True


def show(work):
    """Opens the window until the work has ended; returns at once where that is not possible."""
    gtk, glib = toolkit()
    if gtk is None:
        return
    from gradmesh_theme import prefer_dark

    prefer_dark()
    window = gtk.Window(title=_("Gradient Mesh"), window_position=gtk.WindowPosition.CENTER)
    window.set_keep_above(True)
    window.set_default_size(380, -1)
    window.set_resizable(False)
    column = gtk.Box(orientation=gtk.Orientation.VERTICAL, spacing=12, margin=18)
    title = gtk.Label(label=work.title, xalign=0, wrap=True, max_width_chars=48)
    column.add(title)
    shown = gtk.Image()
    column.add(shown)
    bar = gtk.ProgressBar()
    column.add(bar)
    row = gtk.Box(spacing=12)
    words = gtk.Label(xalign=0)
    row.pack_start(words, True, True, 0)
    button = gtk.Button(label=_("Stop"), tooltip_text=_("Keeps the best result so far"))
    row.pack_end(button, False, False, 0)
    column.add(row)
    window.add(column)

    def stop(*_):
        work.stop()
        button.set_sensitive(False)
        return True  # closing the window stops the work, which then closes the window

    def refresh():
        title.set_text(work.title)
        bar.set_fraction(work.share)
        words.set_text(work.words)
        if work.picture:
            shown.set_from_pixbuf(small(*work.picture))
        if work.ended:
            gtk.main_quit()
        return not work.ended

    button.connect("clicked", stop)
    window.connect("delete-event", stop)
    window.show_all()
    glib.timeout_add(REFRESH, refresh)
    gtk.main()
    window.destroy()


def small(width, height, pixels):
    """A picture, three bytes for each pixel, as one of GTK's that fits into the window."""
    from gi.repository import GdkPixbuf, GLib

    row = 3 * width
    whole = GdkPixbuf.Pixbuf.new_from_bytes(
        GLib.Bytes.new(pixels), GdkPixbuf.Colorspace.RGB, False, 8, width, height, row
    )
    scale = min(1, LARGEST_PICTURE / max(width, height))
    size = (max(1, round(scale * length)) for length in (width, height))
    return whole.scale_simple(*size, GdkPixbuf.InterpType.BILINEAR)


def toolkit():
    """The modules Gtk and GLib, or nothing where they or a display are missing."""
    try:
        # inkex has Python show all warnings, and of how Python loads it gi is warned with every module.
        warnings.filterwarnings("ignore", category=ImportWarning)
        import gi

        gi.require_version("Gtk", "3.0")
        from gi.repository import GLib, Gtk
    except (ImportError, ValueError) as missing:
        log_once(
            _(
                "No window can stop long work, because Python finds no GTK 3 ({error}). On Debian install python3-gi "
                "and gir1.2-gtk-3.0."
            ).format(error=missing)
        )
        return None, None
    return (Gtk, GLib) if Gtk.init_check(None)[0] else (None, None)


@contextmanager
def stderr_in_the_log():
    """What GTK grumbles would open a dialog in Inkscape."""
    sys.stderr.flush()
    before = os.dup(2)
    send_stderr_to_the_log()
    try:
        yield
    finally:
        os.dup2(before, 2)
        os.close(before)
