"""What meshes paint: whole shadings, areas, lines, letters and tiles."""

from boxes import Box

from .color_spaces import Space
from .fonts import font_of_meshes
from .matrices import IDENTITY, numbers, of_any, product
from .meshes import any_shading, mesh, shading
from .shapes import SHAPES, curve, polygon, star
from .texts import FILLED, FILLED_AND_STROKED, STROKED, text as text_of


def sh(draft, box):
    return f"{draft.use('Shading', any_shading(draft, box))} sh"


def pattern(draft, box):
    """The name of a pattern that covers a box, in whatever coordinates its matrix has."""
    own = IDENTITY if draft.chance.random() < 0.5 else of_any(draft, *box.point(0.5, 0.5))
    at = draft.to_content if own == IDENTITY else product(draft.to_content, own)
    matrix = "" if at == IDENTITY else f"/Matrix [{numbers(*at)}]"
    ref = draft.objects.add(f"<< /PatternType 2 /Shading {any_shading(draft, box)} {matrix} >>")
    return draft.use("Pattern", ref)


def fill_with(draft, box):
    return f"/Pattern cs {pattern(draft, box)} scn"


def stroke_with(draft, box):
    return f"/Pattern CS {pattern(draft, box)} SCN {line(draft, box)}"


def line(draft, box):
    """The operators that set how lines are drawn. Of dashes with joins that are no miters Inkscape leaves out what
    lies in some of the strips of 64 rows in which it paints."""
    width = draft.any({0.06: 1, 0.15: 3, 0.3: 1}) * min(box.width, box.height)
    parts = [f"{numbers(width)} w", draft.any({"": 2, "1 J": 1, "2 J": 1})]
    parts.append(draft.any({"": 2, "1 j": 1, "2 j": 1, "3 M": 1}))
    if draft.maybe("dashes", 0.3):
        parts = [part for part in parts if part not in ("1 j", "2 j")]
        parts.append(draft.any({f"[{numbers(2 * width)}] 0 d": 1, f"[{numbers(width, width / 2)}] {width:.3f} d": 1}))
    return " ".join(filter(None, parts))


def fill(draft, box):
    return f"{fill_with(draft, box.grown(2))} {draft.pick(SHAPES)(draft, box)} {draft.any({'f': 3, 'F': 1})}"


def fill_even_odd(draft, box):
    return f"{fill_with(draft, box.grown(2))} {draft.any({star: 2, curve: 1})(draft, box)} f*"


def stroke(draft, box):
    shape = draft.any({polygon: 1, curve: 1, star: 1})(draft, box.grown(-3))
    if shape.endswith(" h") and draft.chance.random() < 0.6:
        ending = "S" if draft.chance.random() < 0.4 else "s"
        shape = shape[:-2]
    else:
        ending = "S"
    return f"{stroke_with(draft, box.grown(8))} {shape} {ending}"


def fill_and_stroke(draft, box):
    shape = draft.pick(SHAPES)(draft, box.grown(-3))
    paints = f"{fill_with(draft, box)} {stroke_with(draft, box.grown(8))}"
    return f"{paints} {shape} {draft.any({'B': 3, 'b': 1, 'B*': 1})}"


def sh_with_opacities(draft, box):
    """As cairo writes a mesh whose colours have opacities: seen through a mask of the same patches in grey."""
    of = draft.seen_through(lambda: mesh(draft, box))
    gray = shading(draft, of, Space("/DeviceGray", [(0, 1)]))
    everything = Box(-100, -100, 300, 300)
    values = "/Group << /Type /Group /S /Transparency /CS /DeviceGray >>"
    form = draft.form(everything, lambda: f"{draft.use('Shading', gray)} sh", values)
    state = draft.state(f"/SMask << /Type /Mask /S /Luminosity /G {form} >>")
    return f"{state} {draft.use('Shading', shading(draft, of))} sh"


def tiles(draft, box):
    """An area filled by a cell in which meshes are painted, again and again."""
    side = draft.between(12, 25)
    cell = Box(0, 0, side, side)
    return tiled(draft, box, side, lambda: f"q {sh(draft, cell.grown(-1))} Q")


def tiles_of_a_fill(draft, box):
    side = draft.between(12, 25)
    cell = Box(0, 0, side, side)
    return tiled(draft, box, side, lambda: f"q {fill(draft, cell.grown(-1))} Q")


def tiled(draft, box, side, write):
    body, resources = draft.content(write)
    step = side * draft.any({1: 2, 1.3: 1})
    matrix = numbers(*product(draft.to_content, (1, 0, 0, 1, box.x, box.y)))
    values = (
        f"/PatternType 1 /PaintType 1 /TilingType 1 /BBox [{numbers(0, 0, side, side)}] /XStep {numbers(step)}"
        f" /YStep {numbers(step)} /Matrix [{matrix}] {resources}"
    )
    ref = draft.objects.stream(draft, values, body.encode("latin-1"))
    return f"/Pattern cs {draft.use('Pattern', ref)} scn {draft.pick(SHAPES)(draft, box)} f"


def text(draft, box):
    return f"{fill_with(draft, box.grown(5))} {text_of(draft, box, FILLED)}"


def stroked_text(draft, box):
    mode = draft.any({STROKED: 2, FILLED_AND_STROKED: 1})
    fill = fill_with(draft, box.grown(5)) if mode == FILLED_AND_STROKED else ""
    width = numbers(min(box.width, box.height) * 0.06)
    return f"{fill} /Pattern CS {pattern(draft, box.grown(8))} SCN {width} w {text_of(draft, box, mode)}"


def glyphs_of_meshes(draft, box):
    """Letters whose outlines are no outlines but meshes; whole shadings where poppler's polygons would be seen, as
    they are larger beside a letter."""
    if draft.is_seen_through:
        return sh(draft, box)
    name = font_of_meshes(draft, lambda: sh(draft, Box(5, 5, 85, 90)))
    size = min(box.width / 2, box.height)
    return f"BT {name} {numbers(size)} Tf {numbers(*box.point(0, 0))} Td (AA) Tj ET"


PAINTS = {
    sh: 5, fill: 3, fill_even_odd: 1, stroke: 3, fill_and_stroke: 1.5, sh_with_opacities: 1.5, tiles: 1,
    tiles_of_a_fill: 0.5, text: 1.5, stroked_text: 0.7, glyphs_of_meshes: 0.7,
}  # fmt: skip
