"""A page that is being written."""

import random
from typing import NamedTuple

from boxes import Box

from .features import FEATURES, NAMES
from .file_bytes import Objects
from .matrices import IDENTITY, numbers, product


class Layer(NamedTuple):
    ref: str
    state: str  #: ON, OFF, or "" where the base state counts
    is_told: bool  #: whether the page asks what its usage says


class Draft:
    """A page that is being written, the features that it may have, and the chance by which all of it is chosen.

    Lengths are in user units: what is painted lies in the square from (0, 0) to (100, 100), whatever the page is.
    """

    def __init__(self, seed, features=FEATURES):
        self.chance = random.Random(seed)
        self.allowed, self.used = frozenset(features), set()
        self.objects = Objects()
        self.layers, self.annotations = [], []
        self.has_backdrop = False
        #: Whether what is painted here is translucent or mixed with what lies below, each polygon by itself.
        self.is_seen_through = False
        self.default_spaces = {}
        self._resources, self._names = {}, 0
        #: From the user space at this place to that in which the content began, which is that of its patterns.
        self.to_content = IDENTITY

    # --- chance ---

    def pick(self, table):
        """A function of a table from functions to weights, among those whose names are features that are allowed or
        no features; the first one where there is none."""
        choices = {each: weight for each, weight in table.items() if self._may(name_of(each))}
        if not choices:
            return next(iter(table))
        (one,) = self.chance.choices(list(choices), list(choices.values()))
        if name_of(one) in NAMES:
            self.used.add(name_of(one))
        return one

    def any(self, table):
        """A value of a table from values to weights."""
        (one,) = self.chance.choices(list(table), list(table.values()))
        return one

    def maybe(self, feature, share=0.5):
        """Whether the page has a feature at this place."""
        assert feature in NAMES, feature
        has = feature in self.allowed and self.chance.random() < share
        if has:
            self.used.add(feature)
        return has

    def _may(self, name):
        return name not in NAMES or name in self.allowed

    def between(self, low, high):
        return self.chance.uniform(low, high)

    def box(self):
        x, y = self.between(3, 40), self.between(3, 40)
        return Box(x, y, self.between(30, 97 - x), self.between(30, 97 - y))

    # --- content ---

    def name(self, stem):
        self._names += 1
        return f"{stem}{self._names}"

    def use(self, category, ref):
        """The name by which the content being written finds an object in its resources."""
        name = self.name(category[:2])
        self._resources.setdefault(category, {})[name] = ref
        return f"/{name}"

    def resources(self):
        categories = dict(self._resources)
        if self.default_spaces:
            categories["ColorSpace"] = {**categories.get("ColorSpace", {}), **self.default_spaces}
        parts = [f"/{category} << {entries(names)} >>" for category, names in categories.items()]
        return f"<< {' '.join(parts)} >>"

    def state(self, values):
        """The operators that set parameters of the graphics state."""
        ref = self.objects.add(f"<< /Type /ExtGState {values} >>")
        return f"{self.use('ExtGState', ref)} gs"

    def moved(self, matrix, write):
        """What `write` writes in the coordinates of a matrix."""
        before = self.to_content
        self.to_content = product(before, matrix)
        body = write()
        self.to_content = before
        return f"q {numbers(*matrix)} cm\n{body}\nQ"

    def seen_through(self, write, is_so=True):
        """What `write` writes where all is translucent, or is so as a group only."""
        before, self.is_seen_through = self.is_seen_through, is_so
        body = write()
        self.is_seen_through = before
        return body

    def content(self, write, has_resources=True):
        """What `write` writes as a content stream of its own, and the entry for its resources."""
        before = self._resources, self.to_content
        if has_resources:
            self._resources = {}
        self.to_content = IDENTITY
        body = write()
        own = f"/Resources {self.resources()}" if has_resources else ""
        self._resources, self.to_content = before
        return body, own

    def form(self, box, write, values="", has_resources=True):
        """A form XObject that shows what lies in a box."""
        body, own = self.content(write, has_resources)
        return self.form_of(box, body, f"{own} {values}")

    def form_of(self, box, body, values):
        values = f"/Type /XObject /Subtype /Form /BBox [{numbers(*box.corners)}] {values}"
        return self.objects.stream(self, values, body.encode("latin-1"))


def name_of(function):
    return function.__name__.replace("_", " ")


def entries(names):
    return " ".join(f"/{name} {ref}" for name, ref in names.items())
