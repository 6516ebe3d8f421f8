"""Soft masks: forms whose luminosity or opacity says how much is seen of what is painted."""

from boxes import Box

from .matrices import numbers
from .shapes import SHAPES

EVERYTHING = Box(-100, -100, 300, 300)


def gray_shapes(draft, box):
    """Areas in greys, and at times in colours, before a black ground."""
    parts = []
    for _ in range(draft.any({1: 2, 2: 1})):
        color = draft.any({f"{draft.between(0.3, 1):.3f} g": 3, "1 g": 2, "1 1 0 rg": 1})
        parts.append(f"{color} {draft.any(SHAPES)(draft, box.grown(-draft.between(0, 10)))} f")
    return "\n".join(parts)


def luminosity_of_fills(draft, box, write):
    space = draft.any({"/DeviceGray": 2, "/DeviceRGB": 1})
    group = f"/Group << /Type /Group /S /Transparency /CS {space} >>"
    ground = draft.any({"": 3, f"/BC [{'1' if space == '/DeviceGray' else '1 1 1'}]": 0.5})
    form = draft.form(EVERYTHING, lambda: gray_shapes(draft, box), group)
    return through(draft, f"/S /Luminosity {ground} /G {form}", write)


def alpha_of_fills(draft, box, write):
    group = "/Group << /Type /Group /S /Transparency /CS /DeviceRGB >>"
    form = draft.form(EVERYTHING, lambda: gray_shapes(draft, box), group)
    return through(draft, f"/S /Alpha /G {form}", write)


def alpha_of_translucent_fills(draft, box, write):
    """As cairo writes what is painted with an opacity."""
    group = "/Group << /Type /Group /S /Transparency /CS /DeviceRGB /I true >>"

    def inside():
        translucent = draft.state(f"/ca {numbers(draft.between(0.3, 0.9))}")
        return f"{translucent} {gray_shapes(draft, box)}"

    return through(draft, f"/S /Alpha /G {draft.form(EVERYTHING, inside, group)}", write)


def through(draft, values, write):
    state = draft.state(f"/SMask << /Type /Mask {values} >>")
    if draft.maybe("mask reset", 0.2):
        return f"q {state} q {draft.state('/SMask /None')}\n{write()}\nQ Q"
    return f"q {state}\n{draft.seen_through(write)}\nQ"
