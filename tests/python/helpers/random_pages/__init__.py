"""Random pages of PDF by seed: all that is seen on one is painted by meshes, in the ways that programs paint.

Each way is a line of a table: a function with its weight. A function whose name is in `FEATURES` is a feature, which
can be left out by name.

    python -m random_pages 0 100 --folder pages

prints how far gradmesh is from poppler on a hundred of them, and keeps them.
"""

from typing import NamedTuple

from boxes import Box

from .annotations import add_annotation
from .color_spaces import add_default_spaces
from .draft import Draft
from .features import BEYOND_POPPLER, FEATURES
from .file_bytes import FILES
from .pages import file_of
from .paints import PAINTS, sh
from .places import PLACES

__all__ = ["BEYOND_POPPLER", "FEATURES", "Page", "document", "page"]


class Page(NamedTuple):
    data: bytes
    features: frozenset  #: the names of those that it has


def document(seed, features=FEATURES):
    """The bytes of one document; the same for the same seed and features."""
    return page(seed, features).data


def page(seed, features=FEATURES):
    draft = Draft(seed, features)
    add_default_spaces(draft)
    drawn = [f"q {draw(draft, draft.box(), 2)} Q" for _ in range(draft.any({1: 4, 2: 3, 3: 1}))]
    if draft.has_backdrop:
        drawn.insert(0, backdrop(draft))
    if draft.maybe("annotation", 0.12):
        add_annotation(draft, draft.box())
    root = file_of(draft, drawn)
    return Page(draft.any(FILES)(draft.objects.bodies, root), frozenset(draft.used))


def draw(draft, box, depth):
    """One object in its place, which may lie in others."""
    if depth == 0 or draft.chance.random() < 0.2:
        return draft.pick(PAINTS)(draft, box)
    return draft.pick(PLACES)(draft, box, lambda: draw(draft, box, depth - 1))


def backdrop(draft):
    """A mesh below all others: modes by which colours are mixed mean nothing over an empty page."""
    return f"q {sh(draft, Box(-10, -10, 120, 120))} Q"
