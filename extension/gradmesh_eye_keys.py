# SPDX-License-Identifier: GPL-2.0-or-later
"""The keys of Simplify by Eye, as far as Inkscape has them the same."""

from gi.repository import Gdk

from gradmesh_eye import EDITS, GROUNDS, KNOWN, ZOOM


class Keys:
    """Passes the keys of a window on to its Eye and to its Panel, whose buttons show what is chosen."""

    def __init__(self, window):
        self.window, self.eye, self.panel = window, window.eye, window.panel

    def pressed(self, _window, event):
        name = Gdk.keyval_name(event.keyval) or ""
        has = event.state & (Gdk.ModifierType.CONTROL_MASK | Gdk.ModifierType.SHIFT_MASK)
        table = self._with_control(has) if has & Gdk.ModifierType.CONTROL_MASK else self._table()
        action = table.get(name) or table.get(name.lower())
        if action is None:
            return False
        self.window.do(action)
        return True

    def released(self, _window, event):
        if Gdk.keyval_name(event.keyval) in ("f", "F"):
            self.eye.flicker(False)
            self.window.paint_soon()
        return False

    def _with_control(self, has):
        eye, with_shift = self.eye, bool(has & Gdk.ModifierType.SHIFT_MASK)
        return {
            "z": eye.redo if with_shift else eye.undo,
            "y": eye.redo,
            "Return": self.window.apply,
            "KP_Enter": self.window.apply,
        }

    def _table(self):
        return {**self._along_the_curve(), **self._from_where(), **self._what_is_seen(), **self._by_hand()}

    def _along_the_curve(self):
        eye = self.eye
        return {
            "Right": lambda: eye.step(1),
            "Left": lambda: eye.step(-1),
            "Page_Down": lambda: eye.step(5),
            "Page_Up": lambda: eye.step(-5),
            "Home": lambda: eye.slide(0),
            "End": lambda: eye.slide(len(eye.states) - 1),
        }

    def _from_where(self):
        eye = self.eye
        table = {name: lambda: eye.zoom(ZOOM) for name in ("plus", "KP_Add", "equal")}
        table.update({name: lambda: eye.zoom(1 / ZOOM) for name in ("minus", "KP_Subtract")})
        table.update({name: eye.fit_to_window for name in "345"})
        return {**table, "1": lambda: eye.zoom_to(1), "2": lambda: eye.zoom_to(2)}

    def _what_is_seen(self):
        eye, panel = self.eye, self.panel
        table = {
            key: lambda name=name: panel.grounds[name].set_active(True) for key, name in zip("7890", GROUNDS)
        }
        return {
            **table,
            "f": lambda: eye.flicker(True),
            "l": lambda: panel.lines.set_active(not eye.lines),
            "h": lambda: panel.handles.set_active(not eye.handles),
            "s": lambda: panel.known.set_active((KNOWN.index(eye.known) + 1) % len(KNOWN)),
            "comma": lambda: eye.step_region(-1),
            "period": lambda: eye.step_region(1),
        }

    def _by_hand(self):
        eye, panel = self.eye, self.panel
        table = {key: lambda name=name: panel.edits[name].set_active(True) for key, name in zip("mrcb", EDITS)}
        return {
            **table,
            "t": lambda: panel.drags["around" if eye.brushes else "brush"].set_active(True),
            "Return": lambda: eye.merge_marked() if len(eye.to_merge) > 1 else None,
            "p": lambda: eye.protect_marked() if eye.marked else None,
            "o": lambda: eye.protect_others() if eye.marked else None,
            "Escape": self.window.escape,
        }
