"""The size of a page, and how long the user units of its document are."""

from typing import NamedTuple


class Page(NamedTuple):
    root: dict  #: attributes of the outermost element
    unit: float  #: user units in a hundredth of the side


def pixels(draft):
    side = draft.pick({100: 4, 200: 2, 50: 1, 400: 1})
    return Page({"width": side, "height": side}, side / 100)


def pixels_in_name(draft):
    return Page({"width": "150px", "height": "150px"}, 1.5)


def view_box(draft, unit=None, **size):
    unit = unit or draft.pick({1: 6, 2.5: 2, 0.01: 1, 0.2: 1, 40: 1})
    corner = draft.pick({0: 4, -5: 1}) * unit
    return Page({**size, "viewBox": f"{corner:g} {corner:g} {100 * unit:g} {100 * unit:g}"}, unit)


def view_box_alone(draft):
    """Without a size of its own: a user unit is a pixel."""
    return view_box(draft, draft.pick({1: 4, 2.5: 2, 0.3: 1}), **dict(draft.pick({(): 2, IN_PERCENT: 1})))


def millimetres(draft):
    return view_box(draft, 0.4, width="40mm", height="40mm")


def other_units(draft):
    size = draft.pick({"90pt": 1, "1.2in": 1, "3cm": 1, "8pc": 1, "20mm": 1})
    return view_box(draft, width=size, height=size)


def millimetres_alone(draft):
    """Without a viewBox: a user unit is a pixel."""
    return Page({"width": "30mm", "height": "30mm"}, 30 / 25.4 * 96 / 100)


def pixels_of_view_box(draft):
    side = draft.pick({100: 4, 64: 1, 300: 1, 40: 0.5})
    return view_box(draft, width=side, height=side)


def wider_than_view_box(draft):
    return view_box(draft, width=160, height=100)


IN_PERCENT = (("width", "100%"), ("height", "100%"))
PAGES = {
    pixels: 4, pixels_in_name: 1, pixels_of_view_box: 5, view_box_alone: 2, millimetres: 3, other_units: 2,
    millimetres_alone: 1, wider_than_view_box: 1,
}  # fmt: skip
