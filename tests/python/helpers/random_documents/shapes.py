"""Objects that fill a box: each function returns tag, attributes and content of an element."""

from .markup import attributes
from .paints import filled


def rect(draft, box):
    corner = {"rx": draft.length(6)} if draft.maybe(0.3) else {}
    return "rect", {**dict(zip(("x", "y", "width", "height"), map(draft.length, box))), **corner}, ""


def rect_in_percent(draft, box):
    return "rect", {name: f"{value:.4g}%" for name, value in box._asdict().items()}, ""


def ellipse(draft, box):
    x, y = box.width / 2, box.height / 2
    values = {"cx": box.x + x, "cy": box.y + y, "rx": x, "ry": y}
    return "ellipse", {name: draft.length(value) for name, value in values.items()}, ""


def circle(draft, box):
    radius = min(box.width, box.height) / 2
    values = {"cx": box.x + radius, "cy": box.y + radius, "r": radius}
    return "circle", {name: draft.length(value) for name, value in values.items()}, ""


def polygon(draft, box):
    x, y, width, height = box
    corners = [(x, y + height / 3), (x + width, y), (x + width / 2, y + height)]
    return "polygon", {"points": draft.lengths(*corners)}, ""


def curve(draft, box):
    x, y, width, height = box
    ends = draft.lengths((x, y), (x + width, y - height / 4), (x, y + height), (x + width, y + height))
    start, rest = ends.split(" ", 1)
    return "path", {"d": f"M {start} C {rest} Z"}, ""


def text(draft, box):
    size = draft.length(min(box.height, box.width / 1.5))
    values = {"x": draft.length(box.x), "y": draft.length(box.y + box.height), "font-size": size}
    own = f"<tspan {attributes(filled(draft, box))}>b</tspan>" if draft.maybe(0.3) else "b"
    spans = draft.pick({f"A{own}c": 3, f"A<tspan>{own}c</tspan>": 2, f'<tspan font-weight="bold">A{own}</tspan>': 1})
    return "text", {**values, "font-family": "sans-serif"}, spans


SHAPES = {rect: 5, rect_in_percent: 1, ellipse: 2, circle: 1, polygon: 1, curve: 3, text: 1.5}
