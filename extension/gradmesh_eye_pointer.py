# SPDX-License-Identifier: GPL-2.0-or-later
"""The pointer over the picture of Simplify by Eye: what clicks, drags and the wheel mean."""

import math

from gi.repository import Gdk, GLib, Gtk

from gradmesh_eye import ZOOM

#: A button that is pressed and moved by fewer pixels clicks.
STEADY = 4
#: Pixels by which a step of the wheel moves the picture.
STEP = 60


class Pointer:
    """Its widget is `canvas`. What a person does there goes to the Eye of a window."""

    def __init__(self, window):
        self.window, self.eye = window, window.eye
        self.canvas = Gtk.EventBox(can_focus=True)
        self._at_last = None
        self._must_point = False
        self._press = None
        self._drag_does = None
        masks = Gdk.EventMask
        self.canvas.add_events(
            masks.POINTER_MOTION_MASK
            | masks.BUTTON_PRESS_MASK
            | masks.BUTTON_RELEASE_MASK
            | masks.SCROLL_MASK
            | masks.SMOOTH_SCROLL_MASK
            | masks.LEAVE_NOTIFY_MASK
        )
        for signal, handler in (
            ("motion-notify-event", self._moved),
            ("button-press-event", self._pressed),
            ("button-release-event", self._released),
            ("scroll-event", self._scrolled),
            ("leave-notify-event", self._left),
        ):
            self.canvas.connect(signal, handler)

    def _at(self, event):
        return event.x * self.window.factor, event.y * self.window.factor

    # --- drags ---

    def _pressed(self, _canvas, event):
        self.canvas.grab_focus()
        if event.type == Gdk.EventType.BUTTON_PRESS and event.button in (1, 2):
            x, y = self._at(event)
            self._press = (event.button, x, y, False)
            self._drag_does = self._what_a_drag_does(event, x)
            if self._drag_does == self._brush and not event.state & Gdk.ModifierType.SHIFT_MASK:
                self.eye.unmark()
            self.eye.lasso = [(x, y)]
        return True

    def _what_a_drag_does(self, event, x):
        if event.button == 2:
            return self._pan
        is_on_line = abs(x - self.eye.split * self.eye.size[0]) < 12 * self.window.factor
        if self.eye.ground == "halves" and is_on_line:
            return self._split
        return self._brush if self.eye.brushes or event.state & Gdk.ModifierType.MOD1_MASK else self._surround

    def _moved(self, _canvas, event):
        if self._press is None:
            self._point_soon(event)
            return True
        x, y = self._at(event)
        mouse, x0, y0, seen = self._press
        if seen or math.hypot(x - x0, y - y0) > STEADY * self.window.factor:
            self._drag_does((x0, y0), (x, y))
            # A lasso begins where the button was pressed; all else goes on from the last place.
            start = (x0, y0) if self._drag_does == self._surround else (x, y)
            self._press = (mouse, *start, True)
            self.window.paint_soon()
        return True

    def _pan(self, before, now):
        self.eye.pan(now[0] - before[0], now[1] - before[1])

    def _split(self, _before, now):
        self.eye.split = min(max(now[0] / self.eye.size[0], 0), 1)

    def _brush(self, before, now):
        self.eye.lasso = []
        self.eye.brush([before, now])

    def _surround(self, _before, now):
        self.eye.lasso.append(now)

    def _released(self, _canvas, event):
        if self._press is None:
            return True
        mouse, _x0, _y0, has_moved = self._press
        self._press = None
        x, y = self._at(event)
        is_more = bool(event.state & Gdk.ModifierType.SHIFT_MASK)
        if has_moved and self._drag_does == self._surround:
            self.window.do(self.eye.mark, is_more)
        elif not has_moved and mouse == 1:
            self._click(x, y, event.state, is_more)
        elif not has_moved and mouse == 2:
            self.window.do(self.eye.zoom, ZOOM, x, y)
        self.eye.lasso = []
        return True

    def _click(self, x, y, state, is_more):
        if self._drag_does == self._brush:
            self.window.do(self.eye.brush, [(x, y)])
        elif is_more:
            self.window.do(self.eye.mark_patch, x, y)
        else:
            self.window.do(self._make, x, y, state)

    def _make(self, x, y, state):
        self.eye.point(x, y, edit_for(state))
        self.eye.click()

    # --- without a button ---

    def _point_soon(self, event):
        """Works out what a click would do at the place where the pointer is once there is time."""
        self._at_last = (*self._at(event), event.state)
        if not self._must_point:
            self._must_point = True
            GLib.idle_add(self._point, priority=GLib.PRIORITY_DEFAULT_IDLE + 10)

    def _point(self):
        self._must_point = False
        if self._at_last is not None and self._press is None:
            x, y, state = self._at_last
            if self.eye.point(x, y, edit_for(state)):
                self.window.paint_soon()
        return False

    def _left(self, *_):
        self._at_last = None
        self.eye.leave()
        self.window.paint_soon()

    def _scrolled(self, _canvas, event):
        """As in Inkscape: the wheel moves up and down, with Shift to the sides, with Ctrl it zooms."""
        known, dx, dy = event.get_scroll_deltas()
        if not known:
            dx = {Gdk.ScrollDirection.LEFT: -1, Gdk.ScrollDirection.RIGHT: 1}.get(event.direction, 0)
            dy = {Gdk.ScrollDirection.UP: -1, Gdk.ScrollDirection.DOWN: 1}.get(event.direction, 0)
        x, y = self._at(event)
        if event.state & Gdk.ModifierType.CONTROL_MASK:
            self.eye.zoom(ZOOM**-dy, x, y)
        else:
            if event.state & Gdk.ModifierType.SHIFT_MASK:
                dx, dy = dy, dx
            step = STEP * self.window.factor
            self.eye.pan(-step * dx, -step * dy)
        self.window.paint_soon()
        return True


def edit_for(state):
    """The edit that the keys held with a click mean; None for the one that is chosen."""
    return "both" if state & Gdk.ModifierType.CONTROL_MASK else None
