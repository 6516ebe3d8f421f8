"""A document that is being written."""

import random

from boxes import Box

from .markup import NAMES
from .page_sizes import PAGES


class Draft:
    """A document that is being written, and the chance by which all of it is chosen."""

    def __init__(self, seed):
        self.chance = random.Random(seed)
        self.rules, self.defs, self.gradients = [], [], []
        self._names = 0
        self._spelled = self.pick(NAMES)
        self.page = self.pick(PAGES)(self)

    def pick(self, table):
        (one,) = self.chance.choices(list(table), list(table.values()))
        return one

    def maybe(self, share):
        return self.chance.random() < share

    def name(self, stem):
        """A new id, spelled in the way of this document."""
        self._names += 1
        return self._spelled(f"{stem}{self._names}")

    def length(self, hundredths):
        return f"{hundredths * self.page.unit:.6g}"

    def lengths(self, *pairs):
        return " ".join(f"{self.length(x)},{self.length(y)}" for x, y in pairs)

    def box(self):
        x, y = self.chance.uniform(3, 40), self.chance.uniform(3, 40)
        return Box(x, y, self.chance.uniform(25, 97 - x), self.chance.uniform(25, 97 - y))

    def colour(self):
        return "#%06x" % self.chance.randrange(1 << 24)
