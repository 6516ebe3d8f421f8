# SPDX-License-Identifier: GPL-2.0-or-later
"""The window of Simplify by Eye: shows the pictures of an Eye and passes on what a person does."""

import json

from gi.repository import Gdk, GLib, Gtk

import gradmesh
from gradmesh_eye_keys import Keys
from gradmesh_eye_panel import Panel
from gradmesh_eye_pointer import Pointer
from gradmesh_eye_words import hint
from gradmesh_log import cache_folder
from gradmesh_text import _, sentence, translated
from gradmesh_widgets import HAS_SURFACES, as_fits_the_screen, prefer_dark, show_samples

REFRESH = 100  # milliseconds
#: How large the window and its picture are at first, and how small the picture may be.
SIZE, LEAST = (1100, 880), 320


class EyeWindow:
    """Call run() once."""

    def __init__(self, eye):
        self.eye = eye
        self.applies = False
        self._must_paint = False
        self._was_fitted = False
        self._hinted = None
        self._build()

    def run(self):
        """Shows the window until it is closed; whether what was made is to be kept."""
        self.window.show_all()
        self.panel.show_forms()
        GLib.timeout_add(REFRESH, self._refresh)
        Gtk.main()
        self._remember()
        self.window.destroy()
        # The window is gone before what goes on in the background has ended.
        Gdk.Display.get_default().flush()
        return self.applies

    def _build(self):
        prefer_dark()
        self.window = Gtk.Window(title=_("Simplify by Eye"))
        self.window.set_default_size(*as_fits_the_screen(self._remembered().get("size", SIZE)))
        self.window.connect("delete-event", self._close)
        self.panel = Panel(self)
        keys = Keys(self)
        self.window.connect("key-press-event", keys.pressed)
        self.window.connect("key-release-event", keys.released)
        row = Gtk.Box()
        row.pack_start(self._build_picture(), True, True, 0)
        row.pack_end(self.panel.box, False, False, 0)
        column = Gtk.Box(orientation=Gtk.Orientation.VERTICAL)
        column.pack_start(row, True, True, 0)
        self.hint = Gtk.Label(xalign=0, margin=6, ellipsize=3)
        column.pack_end(self.hint, False, False, 0)
        self.window.add(column)

    def _build_picture(self):
        self.image = Gtk.Image(halign=Gtk.Align.START, valign=Gtk.Align.START)
        pointer = Pointer(self)
        pointer.canvas.add(self.image)
        # Its picture may be larger than there is room while the window becomes smaller.
        self.frame = Gtk.ScrolledWindow(
            hscrollbar_policy=Gtk.PolicyType.EXTERNAL, vscrollbar_policy=Gtk.PolicyType.EXTERNAL
        )
        self.frame.set_size_request(LEAST, LEAST)
        self.frame.add(pointer.canvas)
        self.frame.connect("size-allocate", self._resized)
        return self.frame

    # --- what is to be seen ---

    @property
    def factor(self):
        """Pixels of the screen for each of the window's, as far as they can be shown."""
        return self.frame.get_scale_factor() if HAS_SURFACES else 1

    def _resized(self, _frame, allocation):
        size = (allocation.width * self.factor, allocation.height * self.factor)
        if size == self.eye.size:
            return
        self.eye.resize(*size, self.factor)
        if not self._was_fitted:
            self.eye.fit_to_window()
        self.paint_soon()

    def paint_soon(self):
        if not self._must_paint:
            self._must_paint = True
            GLib.idle_add(self._paint, priority=GLib.PRIORITY_DEFAULT_IDLE)

    def _paint(self):
        self._must_paint = False
        self._was_fitted = True
        show_samples(self.image, *self.eye.picture(), self.factor)
        self._tell()
        return False

    def _tell(self):
        """Brings everything beside the picture up to date."""
        now = hint(self.eye)
        if now != self._hinted:
            self._hinted = now
            self.hint.set_text(now)
        self.panel.tell()

    def _refresh(self):
        """Looks for what has been found in the background; goes on as long as the window is there."""
        if not self.eye.states or self.eye.is_searching:
            self.eye.refresh()
            self.panel.show_forms()
            self._tell()
        if self.eye.look_for_news():
            self.paint_soon()
        return True

    def do(self, action, *arguments):
        """Does something, and shows what has become; what cannot be done is said below the picture."""
        self._hinted = None
        try:
            action(*arguments)
            self.eye.refresh()
        except gradmesh.InputError as error:
            self._paint()
            self.hint.set_text(sentence(translated(error.message)))
            return
        self.paint_soon()

    def escape(self):
        """First what is marked is no longer, then the window closes."""
        if self.eye.marked:
            self.eye.unmark()
        else:
            GLib.idle_add(self.cancel)

    # --- the end ---

    def apply(self):
        self.applies = not self.eye.is_unchanged
        Gtk.main_quit()

    def cancel(self):
        self.applies = False
        Gtk.main_quit()
        return False

    def _close(self, *_):
        """Closing the window keeps nothing without asking."""
        if self.eye.is_unchanged:
            self.cancel()
            return True
        dialog = Gtk.MessageDialog(
            transient_for=self.window,
            modal=True,
            message_type=Gtk.MessageType.QUESTION,
            text=_("Shall what was made of the mesh be written into the document?"),
        )
        dialog.add_buttons(
            *(_("Discard"), Gtk.ResponseType.REJECT),
            *(_("Go Back"), Gtk.ResponseType.CANCEL),
            *(_("Apply"), Gtk.ResponseType.ACCEPT),
        )
        dialog.set_default_response(Gtk.ResponseType.ACCEPT)
        answer = dialog.run()
        dialog.destroy()
        if answer == Gtk.ResponseType.ACCEPT:
            self.apply()
        elif answer == Gtk.ResponseType.REJECT:
            self.cancel()
        return True

    # --- what stays from one time to the next ---

    def _remembered(self):
        try:
            return json.loads(settings_file().read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return {}

    def _remember(self):
        values = {"size": list(self.window.get_size()), "lines": self.eye.lines, "handles": self.eye.handles}
        try:
            settings_file().parent.mkdir(parents=True, exist_ok=True)
            settings_file().write_text(json.dumps(values), encoding="utf-8")
        except OSError:
            pass  # The window is as large as ever then.


def settings_file():
    return cache_folder() / "by-eye.json"
