"""Documents that must be refused, each with the words that its sentence must hold."""

from typing import NamedTuple, Tuple

DOCUMENT = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
  width="40" height="20">
<defs>{defs}</defs>
<rect id="box" width="40" height="20" fill="url(#m)"/>
<rect id="plain" width="9" height="9" fill="red"/>
</svg>
"""
GRADIENT = '<meshgradient id="m" x="{x}" y="0" gradientUnits="userSpaceOnUse">{rows}</meshgradient>'


def stop(path, color="#fff"):
    return f'<stop path="{path}" stop-color="{color}"/>'


def patch(*stops):
    return f"<meshpatch>{''.join(stops)}</meshpatch>"


def row(*patches):
    return f"<meshrow>{''.join(patches)}</meshrow>"


TOP, RIGHT, BOTTOM, LEFT = stop("l 20,0"), stop("l 0,20"), stop("l -20,0"), stop("l 0,-20")
FIRST = patch(TOP, RIGHT, BOTTOM, LEFT)
NEXT = patch(TOP, RIGHT, BOTTOM)
BELOW = patch(RIGHT, BOTTOM, LEFT)


def document(*rows, x="0"):
    """A document whose object `box` is painted by the mesh `m` of these rows."""
    return DOCUMENT.format(defs=GRADIENT.format(x=x, rows="".join(rows)))


def linked(*links):
    """A document of mesh gradients without rows, each with this href."""
    gradients = (f'<meshgradient id="{a}" xlink:href="#{b}"/>' for a, b in links)
    return DOCUMENT.format(defs="".join(gradients))


TWO_PATCHES = document(row(FIRST, NEXT))
#: A mesh `n` that cannot be read, and what is said of it.
RAGGED = f'<meshgradient id="n">{row(FIRST, NEXT)}{row(BELOW)}</meshgradient>'
REASON = 'meshgradient "n": row 2 does not have as many patches as row 1: 1, not 2.'
MESH = 'meshgradient "m"'


class Bad(NamedTuple):
    text: str
    words: Tuple[str, ...]  #: that name the element and what is wrong


def with_entity(doctype, content):
    """A document with an entity in the place of a stop's colour."""
    return doctype + document(row(patch(stop("l 20,0", content), RIGHT, BOTTOM, LEFT)))


BOMB = "<!DOCTYPE svg [<!ENTITY a0 'lollollol'>" + "".join(
    f"<!ENTITY a{i + 1} '{f'&a{i};' * 10}'>" for i in range(9)
)

BAD = {
    "not XML": Bad("This is a letter, not a drawing.", ("not a readable SVG",)),
    "empty": Bad("", ("it is empty",)),
    "truncated": Bad(TWO_PATCHES[: len(TWO_PATCHES) // 2], ("not a readable SVG",)),
    "not SVG": Bad("<html><body/></html>", ("svg",)),
    "no mesh": Bad(DOCUMENT.format(defs=""), ("painted by a",)),
    "NaN": Bad(document(row(patch(stop("l nan,0"), RIGHT, BOTTOM, LEFT))), (MESH, "nan,0")),
    "infinite": Bad(document(row(patch(stop("l inf,0"), RIGHT, BOTTOM, LEFT))), (MESH, "inf,0")),
    "overflow": Bad(document(row(patch(stop("l 1e999,0"), RIGHT, BOTTOM, LEFT))), (MESH, "1e999")),
    "huge": Bad(document(row(FIRST), x="1e30"), (MESH,)),
    "huge corner": Bad(document(row(patch(stop("L 1e30,0"), RIGHT, BOTTOM, LEFT))), (MESH,)),
    "missing stops": Bad(document(row(patch(TOP, RIGHT))), (MESH, "stop")),
    "ragged rows": Bad(document(row(FIRST, NEXT), row(BELOW)), (MESH, "row 2")),
    "empty first row": Bad(document(row(), row(BELOW)), (MESH, "row 1")),
    "no rows": Bad(document(), (MESH, "meshrow")),
    "dangling href": Bad(linked(("m", "gone")), (MESH, "gone")),
    "circular href": Bad(linked(("m", "n"), ("n", "m")), (MESH, "itself")),
    "zero size": Bad(document(row(patch(*[stop("l 0,0")] * 4))), (MESH, "degenerate")),
    "no path": Bad(document(row(patch("<stop/>", RIGHT, BOTTOM, LEFT))), (MESH, "path")),
    "external entity": Bad(
        with_entity('<!DOCTYPE svg [<!ENTITY e SYSTEM "SECRET">]>', "&e;"), ("external entity",)
    ),
    "entity bomb": Bad(with_entity(BOMB + "]>", "&a9;"), ("entity",)),
}
