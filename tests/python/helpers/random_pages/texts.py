"""Texts in a box, as operators."""

from .fonts import font
from .matrices import numbers

FILLED, STROKED, FILLED_AND_STROKED, CLIP = 0, 1, 2, 7


def text(draft, box, mode):
    """A text object that paints or clips in a mode of Tr."""
    name, written = font(draft)
    letters = "".join(draft.chance.choice("ABO") for _ in range(draft.any({1: 1, 2: 3, 3: 1})))
    size = min(box.height, box.width / (0.8 * len(letters))) * 1.1
    start = box.point(0, 0.1)
    place = draft.any({
        f"{numbers(*start)} Td": 3,
        f"{numbers(1, 0.1, -0.2, 1, *start)} Tm": 1,
        f"{numbers(*start)} Td 5 Ts 80 Tz": 1,
        f"{numbers(*box.point(0, 0.5))} Td {numbers(box.height * 0.4)} TL T*": 1,
    })  # fmt: skip
    shown = draft.any({f"{written(letters)} Tj": 3, f"[{written(letters[0])} -80 {written(letters[1:] or 'A')}] TJ": 1})
    return f"BT {name} {numbers(size)} Tf {mode} Tr {place} {shown} ET"
