# SPDX-License-Identifier: GPL-2.0-or-later
"""What Simplify by Eye shows and does, without a window: the mesh that is looked at, from where, and
what each key and click makes of it.

The core paints and measures (gradmesh.Session); the window only shows pictures and passes on what a
person does.
"""

import math

import gradmesh

from gradmesh_eye_chart import Chart
from gradmesh_text import _, sentence, translated

GRADIENT, BLOCKS = "one gradient", "blocks"
#: The pictures that can be looked at, in the order of their buttons.
GROUNDS = ("result", "original", "halves", "error")
#: What can be shown of what is known of the mesh: names as of gradmesh.Session.find_out().
KNOWN = ("nothing", "prices", "regions", "parts")
#: What a click does: names as of gradmesh.Session.point().
EDITS = ("merge", "rows", "columns", "both")
#: How far a step of the wheel zooms.
ZOOM = 1.25
#: Within how many pixels of the pointer a line is meant.
REACH = 8
#: How far a line may go aside and still be straight, by its length.
STRAIGHT = 0.1
#: How many of the worst places are listed.
WORST = 5
#: The amounts, with the names that marks on the slider have.
AMOUNTS = {"gentle": _("Gentle"), "balanced": _("Balanced"), "strong": _("Strong")}


class Eye:
    """The meshes of a document, one of which is looked at."""

    def __init__(self, document, ids, **options):
        """options: as of gradmesh.Session."""
        self.ids = list(ids)
        self._document = document
        self._options = options
        self._sessions = {}
        self.size = (800, 600)
        self.density = 1
        self.ground = "result"
        self.split = 0.5
        self.lines = True
        self.handles = False
        self.known = "nothing"
        self.edit = "merge"
        self.brushes = False
        self.fits = True
        self.choose(self.ids[0])

    def choose(self, name):
        """Looks at another mesh; what was made of the one before stays."""
        if name not in self._sessions:
            self._sessions[name] = gradmesh.Session(self._document, name, **self._options)
        self.id = name
        self.lasso = []
        self._flicker = False
        self._forget()
        self.fit_to_window()

    @property
    def session(self):
        return self._sessions[self.id]

    @property
    def status(self):
        return self.session.status

    def close(self):
        for session in self._sessions.values():
            session.close()

    def apply(self):
        """Writes all meshes of which something was made; the results."""
        changed = [s for s in self._sessions.values() if not s.status["unchanged"]]
        for session in self._sessions.values():
            if session not in changed:
                session.close()
        return [session.write() for session in changed]

    @property
    def is_unchanged(self):
        return all(session.status["unchanged"] for session in self._sessions.values())

    # --- from where ---

    def resize(self, width, height, density=1):
        """density: how many pixels the screen has for each of an ordinary one."""
        self.size = (max(width, 1), max(height, 1))
        self.density = density

    def fit_to_window(self):
        left, top, right, bottom = self.session.box
        width, height = self.size
        span = max(right - left, 1e-9), max(bottom - top, 1e-9)
        self.scale = 0.94 * min(width / span[0], height / span[1])
        self.middle = ((left + right) / 2, (top + bottom) / 2)

    @property
    def view(self):
        return gradmesh.View(*self.size, *self.middle, self.scale)

    def place_at(self, x, y):
        """Where a pixel lies, in the units of the page."""
        return tuple(
            m + (p - size / 2) / self.scale for m, p, size in zip(self.middle, (x, y), self.size)
        )

    def zoom(self, factor, x=None, y=None):
        """Enlarges; the place at the pixel, or in the middle, stays where it is."""
        x, y = (self.size[0] / 2 if x is None else x, self.size[1] / 2 if y is None else y)
        before = self.place_at(x, y)
        left, top, right, bottom = self.session.box
        least = 8 / max(right - left, bottom - top, 1e-9)
        self.scale = min(max(self.scale * factor, least), 1e5 * least)
        after = self.place_at(x, y)
        self.middle = tuple(m + b - a for m, b, a in zip(self.middle, before, after))

    def zoom_to(self, scale):
        """Shows as many pixels of an ordinary screen for each unit of the page."""
        self.zoom(scale * self.density / self.scale)

    def pan(self, dx, dy):
        self.middle = tuple(m - d / self.scale for m, d in zip(self.middle, (dx, dy)))

    def look_at(self, place):
        """Brings one of the worst places into the middle, large."""
        self.middle = (place["x"], place["y"])
        left, top, right, bottom = self.session.box
        self.scale = max(self.scale, 3 * min(self.size) / max(right - left, bottom - top, 1e-9))

    # --- the picture ---

    def flicker(self, is_on):
        """Shows the original while a key is held."""
        self._flicker = is_on

    def picture(self):
        """Width, height and samples, as of gradmesh.Session.paint()."""
        if self.found.get("complete"):
            self.find_out()
        return self.session.paint(
            self.view,
            ground="original" if self._flicker else self.ground,
            split=self.split,
            lines=self.lines and not self._flicker,
            handles=self.handles and not self._flicker,
            proposal=not self._flicker,
            marked=self.marked,
            lasso=self.outline,
            known=None if self._flicker or self.known == "nothing" else self.known,
            patch=self.patch,
            region=self.region,
            density=self.density,
        )

    # --- what is known of the mesh ---

    def show_known(self, known):
        self.known = known
        self.region = 0
        self.found = {}

    @property
    def patch(self):
        """The patch whose regions are looked at: the one that is marked, or else pointed at last."""
        return self.marked[0] if self.marked else self._patch

    def find_out(self):
        """Asks what is known; whether that is news."""
        before = self.found, self._regions_of
        if self._regions_of != self.patch:
            self._regions_of, self.region = self.patch, 0
        self.found = {}
        if self.known != "nothing":
            self.found = self.session.find_out(self.known, self.patch, self.region, self.fits)
            failure = self.found["failure"]
            self.found["failure"] = failure and sentence(translated(failure.message))
        return before != (self.found, self._regions_of)

    def look_for_news(self):
        """Asks what is known, once the mesh has stayed the same from one call to the next: while the slider
        moves nothing is begun. Whether there is news."""
        if self._has_changed:
            self._has_changed = False
            return False
        return self.is_finding_out and self.find_out()

    @property
    def is_finding_out(self):
        return self.known != "nothing" and not self.found.get("complete")

    def step_region(self, by):
        """Goes to a smaller region of the patch, or with -1 to a larger one, round and round."""
        count = self.found.get("regions", 0)
        self.region = (self.region + by) % count if count else 0

    @property
    def region_shown(self):
        return self.found.get("region")

    # --- the curve ---

    @property
    def curve(self):
        """What is known of the curve of the form that is shown."""
        return self.status.get("curves", {}).get(self.status["form"], {})

    @property
    def states(self):
        return self.curve.get("states", [])

    @property
    def marks(self):
        """The states of the amounts, by their names on the slider."""
        marks = self.curve.get("marks", {})
        return {words: marks[name] for name, words in AMOUNTS.items() if name in marks}

    @property
    def is_searching(self):
        return bool(self.curve.get("wanted")) and not self.curve.get("complete")

    def refresh(self):
        """Asks what has been found of the curves."""
        self.session.refresh()

    def slide(self, state, moving=False):
        """Shows a state of the curve."""
        last = len(self.states) - 1
        if last < 0:
            return
        state = min(max(int(state), 0), last)
        if moving and state == self.status["state"]:
            return
        self.session.show(self.status["form"], state, moving)
        self._forget()

    def step(self, by):
        """Goes on along the curve; from a mesh edited by hand, to the state with about as many handles."""
        if self.status["state"] >= 0:
            self.slide(self.status["state"] + by)
            return
        handles = self.status["handles"]
        least = min(
            range(len(self.states)),
            key=lambda n: abs(self.states[n]["handles"] - handles),
            default=0,
        )
        self.slide(least)

    def set_form(self, form):
        self.session.set_form(form)
        self._forget()
        self.session.want_curve(form)

    @property
    def has_forms(self):
        """Whether the mesh may be one gradient or blocks."""
        return len(self.status.get("curves", {})) > 1

    # --- by hand ---

    def point(self, x, y, edit=None):
        """Works out what a click would do; whether the picture has changed."""
        before = self.pointed
        if self.brushes:
            self.pointed = self._patch_at(x, y)
        else:
            reach = REACH * self.density
            self.pointed = self.session.point(self.view, x, y, edit or self.edit, self.fits, reach)
        if self.pointed is not None:
            self._patch = self.pointed.face
        return before != self.pointed or self.pointed is not None

    def _patch_at(self, x, y):
        """What lies at a pixel, where a click does nothing."""
        return self.session.point(self.view, x, y, "merge", False, reach=-1)

    def leave(self):
        """The pointer has left the picture."""
        self.pointed = self.session.point(self.view, -1e6, -1e6)

    def click(self):
        """Does what was pointed at; False where that is nothing."""
        if self.pointed is None or self.pointed.handles is None:
            return False
        self.session.make()
        self._forget()
        return True

    @property
    def outline(self):
        """What is drawn around patches: a rectangle while the pointer goes straight, a lasso otherwise."""
        if len(self.lasso) < 2:
            return self.lasso
        (x0, y0), (x1, y1) = self.lasso[0], self.lasso[-1]
        length = math.hypot(x1 - x0, y1 - y0)
        aside = max(abs((x - x0) * (y1 - y0) - (y - y0) * (x1 - x0)) for x, y in self.lasso)
        if aside > STRAIGHT * length**2:
            return self.lasso
        return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]

    def mark(self, adds=False):
        """Marks the patches in the outline, which is done with."""
        found = self.session.patches_in(self.view, self.outline)
        self.lasso = []
        self.marked = sorted({*self.marked, *found}) if adds else found

    def brush(self, line):
        """Marks the patches that a line of pixels touches, besides those that are."""
        self.marked = sorted({*self.marked, *self.session.patches_in(self.view, line, touched=True)})

    def mark_patch(self, x, y):
        """Marks the patch at a pixel, or no longer."""
        pointed = self._patch_at(x, y)
        if pointed is not None:
            self.marked = sorted({*self.marked} ^ {pointed.face})

    def unmark(self):
        self.marked = []

    @property
    def to_merge(self):
        """The patches that are marked; where no more than one is, those of the region that is shown."""
        if len(self.marked) < 2 and self.region_shown:
            return self.region_shown["patches"]
        return self.marked

    @property
    def price_of_marked(self):
        """What merging the patches that are marked would do, as of gradmesh.Session.propose_merge(); worked
        out once for the same patches of the same mesh."""
        asked = (tuple(self.marked), self.fits)
        if self._price_asked != asked:
            self._price_asked, self._price = asked, self.session.propose_merge(self.marked, self.fits)
            self.leave()
        return self._price

    def merge_marked(self):
        self.session.merge(self.to_merge, self.fits)
        self._forget()

    @property
    def is_release(self):
        """Whether all that is marked is protected, so that protecting it again means the opposite."""
        return bool(self.marked) and {*self.marked} <= {*self.status["protected"]}

    def protect_marked(self):
        """Lets what is marked stay as it is whatever is done, or no longer."""
        self.session.protect(self.marked, not self.is_release)
        self._forget()

    def protect_others(self):
        """Lets only what is marked change, even what was protected before."""
        self.session.protect_others(self.marked)
        self._forget()

    def weigh_marked(self, factor):
        """Lets errors in what is marked count so many times."""
        self.session.weigh(self.marked, factor)
        self._forget()

    def fit(self):
        self.session.fit()
        self._forget()

    def undo(self):
        self.session.undo()
        self._forget()

    def redo(self):
        self.session.redo()
        self._forget()

    def _forget(self):
        """What was marked, pointed at and found out was of another mesh."""
        self.marked = []
        self.pointed = self._patch = None
        self.found = {}
        self.region, self._regions_of = 0, None
        self._price_asked = self._price = None
        self._has_changed = True

    def worst_places(self):
        return self.session.worst_places(WORST)

    # --- the chart of the curve ---

    def chart(self, width, height, is_dark=False):
        """Width, height and samples of a picture of the curve: handles from many to few, left to right,
        by the error, below to above; marks of the amounts, and the state that is shown."""
        return Chart(width, height, is_dark, self.density).draw(self.states, self.curve.get("marks", {}), self.status)
