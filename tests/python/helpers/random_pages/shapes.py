"""Paths in a box, as operators."""

from .matrices import numbers


def rectangle(draft, box):
    return f"{numbers(*box)} re"


def polygon(draft, box):
    points = [(0, 0.3), (1, 0), (0.85, 0.9), (0.3, 1)]
    return lines(box, points) + " h"


def star(draft, box):
    """A path that crosses itself, so that the fill rule is seen."""
    return lines(box, [(0.1, 0), (0.5, 1), (0.9, 0), (0, 0.65), (1, 0.65)]) + " h"


def curve(draft, box):
    a, b, c, d, e, f, g = (
        numbers(*box.point(*at)) for at in [(0, 0.5), (0, 1.2), (1, 1.2), (1, 0.5), (1, 0), (0.5, -0.1), (0.4, 0.3)]
    )
    way = draft.any({f"{a} m {b} {c} {d} c {e} {f} {g} c": 2, f"{a} m {b} {d} v {e} {g} y": 1})
    return way + " h"


def ring(draft, box):
    """A rectangle with another one in it, in the same or in the other direction."""
    x, y, width, height = box.grown(-min(box.width, box.height) / 4)
    inner = draft.any({(x, y, width, height): 1, (x + width, y, -width, height): 1})
    return f"{numbers(*box)} re {numbers(*inner)} re"


def lines(box, points):
    first, *others = (numbers(*box.point(*at)) for at in points)
    return f"{first} m " + " ".join(f"{each} l" for each in others)


SHAPES = {rectangle: 3, polygon: 2, star: 2, curve: 3, ring: 1}
