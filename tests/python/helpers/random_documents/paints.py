"""What of an object a mesh paints, and how its element says so."""

from .gradients import gradient
from .markup import attributes, url
from .style_sheets import SELECTORS

# --- properties: each returns those that paint an object ---


def filled(draft, box):
    return {"fill": url(draft, gradient(draft, box))}


def translucent(draft, box):
    return {**filled(draft, box), draft.pick({"fill-opacity": 1, "opacity": 1}): 0.6}


def stroked(draft, box):
    fill = draft.pick({"none": 2, "#c0d0e0": 1})
    paint = url(draft, gradient(draft, box.grown(5)))
    return {"fill": fill, "stroke": paint, "stroke-width": draft.length(draft.pick({8: 2, 3: 1}))}


def filled_and_stroked(draft, box):
    return {**stroked(draft, box), **filled(draft, box)}


def dashed(draft, box):
    return {**stroked(draft, box), "stroke-dasharray": f"{draft.length(12)} {draft.length(7)}"}


def with_plain_stroke(draft, box):
    return {**filled(draft, box), "stroke": draft.colour(), "stroke-width": draft.length(4)}


def with_fallback(draft, box):
    return {"fill": filled(draft, box)["fill"] + " " + draft.colour()}


PARTS = {
    filled: 8, translucent: 1, stroked: 2, filled_and_stroked: 1, dashed: 0.5, with_plain_stroke: 1,
    with_fallback: 0.5,
}  # fmt: skip

# --- where they are written: each returns what lies around the element, whose attributes it changes ---


def by_attribute(draft, tag, values, paint):
    values.update(paint)
    return "{}"


def by_style(draft, tag, values, paint):
    values["style"] = draft.pick({";": 3, " ; ": 1}).join(f"{name}:{value}" for name, value in paint.items())
    return "{}"


def by_rule(draft, tag, values, paint):
    selector, around = draft.pick(SELECTORS)(draft, tag, values)
    important = " !important" if draft.maybe(0.15) else ""
    draft.rules.append((selector, {name: f"{value}{important}" for name, value in paint.items()}))
    if draft.maybe(0.3):
        values["fill"] = "#806040"
    return around


def inherited(draft, tag, values, paint):
    group = {}
    draft.pick({by_attribute: 2, by_style: 1})(draft, "g", group, paint)
    return f"<g {attributes(group)}>{{}}</g>"


PAINTS = {by_attribute: 4, by_style: 5, by_rule: 5, inherited: 2}
