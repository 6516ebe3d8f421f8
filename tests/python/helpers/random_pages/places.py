"""What lies around an object on its page: transforms, clips, masks, forms, layers. Each function gets the box of the
object and what writes it."""

from . import layers
from .masks import EVERYTHING, alpha_of_fills, alpha_of_translucent_fills, luminosity_of_fills
from .matrices import inverse, numbers, of_any
from .shapes import curve, polygon, rectangle, star
from .texts import CLIP, text

SAME_TWICE = "/Darken", "/Lighten"


def plainly(draft, box, write):
    return write()


def moved(draft, box, write):
    return draft.moved(of_any(draft, *box.point(0.5, 0.5)), write)


def translucent(draft, box, write):
    """With the same opacity for strokes: poppler takes that of fills wherever a pattern paints."""
    opacity = f"{draft.between(0.3, 0.9):.3f}"
    return f"q {draft.state(f'/ca {opacity} /CA {opacity}')}\n{draft.seen_through(write)}\nQ"


def blended(draft, box, write):
    """In modes in which an object may as well be painted twice, as poppler does where its polygons overlap."""
    draft.has_backdrop = True
    return f"q {draft.state(f'/BM {draft.any(dict.fromkeys(SAME_TWICE, 1))}')}\n{draft.seen_through(write)}\nQ"


def blended_group(draft, box, write):
    draft.has_backdrop = True
    mode = draft.any({"/Multiply": 2, "/Screen": 1, "/Darken": 1, "[/Unknown /Difference]": 0.5})
    group = draft.form(EVERYTHING, lambda: draft.seen_through(write, False), "/Group << /S /Transparency >>")
    return f"q {draft.state(f'/BM {mode}')} {draft.use('XObject', group)} Do Q"


# --- clips ---


def clip_to_rectangle(draft, box, write):
    return clipped(draft, rectangle(draft, box.grown(-5)), write)


def clip_to_polygon(draft, box, write):
    return clipped(draft, polygon(draft, box), write)


def clip_to_curve(draft, box, write):
    return clipped(draft, curve(draft, box), write)


def clip_even_odd(draft, box, write):
    return clipped(draft, star(draft, box), write, "W*")


def clip_to_text(draft, box, write):
    return f"q {text(draft, box, CLIP)}\n{write()}\nQ"


def clipped(draft, path, write, rule="W"):
    return f"q {path} {rule} n\n{write()}\nQ"


# --- forms ---


def form(draft, box, write):
    """A form, with what a form may have."""
    values, shown, is_group = [], box.grown(30), draft.maybe("group", 0.4)
    if draft.maybe("form box", 0.3):
        shown = box.grown(-6)
    around = "{}"
    if draft.maybe("form matrix", 0.4):
        matrix = of_any(draft, *box.point(0.5, 0.5))
        values.append(f"/Matrix [{numbers(*matrix)}]")
        if draft.chance.random() < 0.5:
            around = f"q {numbers(*inverse(matrix))} cm {{}} Q"
    if is_group:
        more = draft.any({"": 2, "/I true": 1, "/I true /K false": 1, "/CS /DeviceRGB": 1})
        values.append(f"/Group << /Type /Group /S /Transparency {more} >>")
    if draft.maybe("layer of a form", 0.15):
        values.append(f"/OC {layers.optional_content(draft)}")
    has_resources = not draft.maybe("resources of the page", 0.15)
    ref = draft.form(shown, lambda: shown_in_form(draft, write, is_group), " ".join(values), has_resources)
    return around.format(f"{draft.use('XObject', ref)} Do")


def shown_in_form(draft, write, is_group):
    """One object, or two that lie over one another."""
    is_whole = is_group and draft.is_seen_through
    count = 2 if draft.maybe("two in a translucent group" if is_whole else "two in a form", 0.25) else 1
    bodies = (draft.seen_through(write, draft.is_seen_through and not is_group) for _ in range(count))
    return "\n".join(f"q {body} Q" for body in bodies)


def invisible_marks(draft, box, write):
    """What a page may hold and nobody sees."""
    x, y = numbers(box.x), numbers(box.y)
    marks = draft.any({
        f"{numbers(*box)} re n": 2,
        f"0.2 0.5 0.1 rg q 0 0 0 0 re W n {numbers(*box)} re f Q": 1,
        f"BT /None 12 Tf 3 Tr {x} {y} Td (AB) Tj ET": 1,
        "/Gone Do /Gone gs /Gone sh": 0.3,
    })  # fmt: skip
    return f"q {marks} Q\n{write()}"


PLACES = {
    plainly: 4, moved: 2, translucent: 1, blended: 0.5, blended_group: 0.7, clip_to_rectangle: 1.5,
    clip_to_polygon: 1, clip_to_curve: 1, clip_even_odd: 0.7, clip_to_text: 1, form: 3, luminosity_of_fills: 1,
    alpha_of_fills: 0.7, alpha_of_translucent_fills: 0.5, layers.layer: 2, invisible_marks: 0.4,
}  # fmt: skip
