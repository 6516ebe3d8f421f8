"""Where an object lies: each function returns what is drawn for an object with an id."""

from boxes import Box

from .gradients import gradient
from .markup import element, moved, reference, url
from .shapes import circle, polygon


def alone(draft, drawn, id):
    return drawn


def in_group(draft, drawn, id):
    return element("g", {"transform": moved(draft, draft.length(50), draft.length(50))}, drawn)


def in_groups(draft, drawn, id):
    return in_group(draft, in_group(draft, drawn, id), id)


def in_translucent_group(draft, drawn, id):
    return element("g", {"opacity": 0.7}, drawn)


def in_inner_svg(draft, drawn, id):
    frame = {name: draft.length(value) for name, value in {"x": 10, "y": 5, "width": 80, "height": 80}.items()}
    side = draft.length(draft.pick({80: 1, 100: 1}))
    return element("svg", {**frame, "viewBox": f"0 0 {side} {side}"}, drawn)


def in_link(draft, drawn, id):
    return element("a", {"xlink:href": "https://example.org/"}, drawn)


def clipped(draft, drawn, id):
    clip = draft.name("clip")
    draft.defs.append(element("clipPath", {"id": clip}, element(*circle(draft, Box(15, 15, 70, 70)))))
    return element("g", {"clip-path": url(draft, clip)}, drawn)


def masked(draft, drawn, id):
    mask = draft.name("mask")
    tag, values, _ = polygon(draft, Box(0, 0, 100, 100))
    draft.defs.append(element("mask", {"id": mask}, element(tag, {**values, "fill": "#d0d0d0"})))
    return element("g", {"mask": url(draft, mask)}, drawn)


def cloned(draft, drawn, id):
    place = {"transform": f"translate({draft.length(12)},{draft.length(9)}) scale(0.7)"}
    return drawn + element("use", {**reference(draft, id), **place})


def only_cloned(draft, drawn, id):
    draft.defs.append(drawn)
    return element("use", {**reference(draft, id), "x": draft.length(4)})


def in_symbol(draft, drawn, id):
    symbol = draft.name("s")
    draft.defs.append(element("symbol", {"id": symbol, "overflow": "visible"}, drawn))
    return element("use", reference(draft, symbol))


def in_pattern(draft, drawn, id):
    pattern = draft.name("p")
    size = {"width": draft.length(100), "height": draft.length(100)}
    draft.defs.append(element("pattern", {"id": pattern, "patternUnits": "userSpaceOnUse", **size}, drawn))
    tag, values, _ = circle(draft, Box(2, 2, 96, 96))
    return element(tag, {**values, "fill": url(draft, pattern)})


def in_marker(draft, drawn, id):
    marker = draft.name("marker")
    size = {"markerUnits": "userSpaceOnUse", "markerWidth": draft.length(100), "markerHeight": draft.length(100)}
    draft.defs.append(element("marker", {"id": marker, "overflow": "visible", **size}, drawn))
    return element("path", {"d": f"M 0,0 L {draft.lengths((30, 0))}", "marker-start": url(draft, marker)})


def filtered(draft, drawn, id):
    name = draft.name("f")
    blur = element("feGaussianBlur", {"stdDeviation": draft.length(2)})
    draft.defs.append(element("filter", {"id": name}, blur))
    return element("g", {"filter": url(draft, name)}, drawn)


def in_switch(draft, drawn, id):
    return element("switch", {}, drawn + element("rect", {}))


def hidden(draft, drawn, id):
    other = element("rect", {"fill": url(draft, gradient(draft, draft.box()))})
    return drawn + element("g", {"display": "none"}, other)


PLACES = {
    alone: 12, in_group: 4, in_groups: 2, in_translucent_group: 1, in_inner_svg: 1, in_link: 0.5, clipped: 1.5,
    masked: 1, cloned: 1.5, only_cloned: 1, in_symbol: 1, in_pattern: 0.4, in_marker: 0.4, filtered: 0.4,
    in_switch: 0.4, hidden: 0.5,
}  # fmt: skip
