"""Mesh gradients: their points and colours, how stops are written, and what holds the rows."""

import sys

from boxes import Box
from built import SAMPLES

from .markup import element, in_selector, moved

sys.path.append(str(SAMPLES))  # after the tests' own modules of the same names

from meshgrid import Mesh, mix  # noqa: E402


def lattice(draft, box):
    """The points of one to three rows and columns of patches that fill a box, more or less."""
    chance, rows, columns = draft.chance, draft.pick({1: 3, 2: 3, 3: 1}), draft.pick({1: 3, 2: 3, 3: 1})
    shake = draft.pick({0: 2, 0.05: 2, 0.15: 1}) * min(box.width / columns, box.height / rows)

    def corner(i, j):
        moved = complex(chance.uniform(-shake, shake), chance.uniform(-shake, shake))
        return complex(box.x + box.width * j / columns, box.y + box.height * i / rows) + moved

    corners = [[corner(i, j) for j in range(columns + 1)] for i in range(rows + 1)]
    return Mesh(corners, draft.pick(COLOURS)(draft, rows, columns))


def any_colours(draft, rows, columns):
    return [[draft.colour() for _ in range(columns + 1)] for _ in range(rows + 1)]


def along_a_line(draft, rows, columns):
    """Colours of which whole rows and columns can be taken out."""
    start, end = ([draft.chance.random() for _ in "rgb"] for _ in range(2))
    steps = rows + columns

    def text(share):
        return "#" + "".join(f"{round(255 * mix(a, b, share)):02x}" for a, b in zip(start, end))

    return [[text((i + j) / steps) for j in range(columns + 1)] for i in range(rows + 1)]


COLOURS = {any_colours: 2, along_a_line: 3}


def segment(draft, side, write, may_close):
    """A stop's path along the four points of a side; `write` gives the text of points."""
    straight = all(abs(mix(side[0], side[3], k / 3) - side[k]) < 1e-6 for k in (1, 2))
    letter = draft.pick({"l": 3, "c": 1} if straight else {"c": 1})
    points = side[3:] if letter == "l" else side[1:]
    if may_close and draft.maybe(0.3):
        points = points[:-1]
    if draft.maybe(0.3):
        return f"{letter.upper()} {write(points)}".strip()
    return f"{letter} {write([point - side[0] for point in points])}".strip()


def rows_of(draft, mesh, write, paint):
    """The `meshrow` elements; `paint` gives the attributes of a stop for its colour."""
    points, colours = mesh.points, mesh.colours
    lines = []
    for i in range(mesh.rows):
        patches = []
        for j in range(mesh.columns):
            top, left = 3 * i, 3 * j
            right = [points[top + k][left + 3] for k in range(4)]
            below = [points[top + 3][left + 3 - k] for k in range(4)]
            sides = [
                (points[top][left : left + 4], colours[i][j], i == 0, j == 0),
                (right, colours[i][j + 1], True, i == 0),
                (below, colours[i + 1][j + 1], True, True),
                ([points[top + 3 - k][left] for k in range(4)], colours[i + 1][j], j == 0, True),
            ]
            written = [side for side in sides if side[2]]
            stops = ""
            for side, colour, _, is_new in written:
                closes = side is written[-1][0]
                values = {"path": segment(draft, side, write, closes), **(paint(colour) if is_new else {})}
                stops += element("stop", values)
            patches.append(f"<meshpatch>{stops}</meshpatch>")
        lines.append(f"<meshrow>{''.join(patches)}</meshrow>")
    return "\n".join(lines)


def in_attributes(draft, id):
    return lambda values: values


def in_style(draft, id):
    return lambda values: {"style": ";".join(f"{name}:{value}" for name, value in values.items())}


def in_rules(draft, id):
    def paint(values):
        name = f"c{len(draft.rules)}"
        draft.rules.append((f".{name}", values))
        return {"class": name}

    return paint


def in_rule_of_gradient(draft, id):
    draft.rules.append((f"#{in_selector(id)} stop", {"stop-opacity": 0.6}))
    return in_style(draft, id)


def of_current_colour(draft, id):
    def paint(values):
        return {**values, "color": values["stop-color"], "stop-color": "currentColor"}

    return paint


STOPS = {in_attributes: 3, in_style: 4, in_rules: 1, in_rule_of_gradient: 0.7, of_current_colour: 0.4}


def gradient(draft, box):
    """The id of a mesh that covers a box of the page or, in its own units, of any object."""
    if draft.gradients and draft.maybe(0.3):
        return draft.chance.choice(draft.gradients)
    id = draft.name("m")
    of_box = draft.maybe(0.3)
    box = Box(0, 0, 1, 1).grown(0.05) if of_box else box.grown(draft.pick({1: 4, 5: 2, -4: 1}))
    mesh = lattice(draft, box)

    def number(value):
        return f"{value:.5g}" if of_box else draft.length(value)

    def write(points):
        return " ".join(f"{number(point.real)},{number(point.imag)}" for point in points)

    corner = mesh.points[0][0]
    values = {"x": number(corner.real), "y": number(corner.imag)}
    if not of_box:
        values["gradientUnits"] = "userSpaceOnUse"
    elif draft.maybe(0.5):
        values["gradientUnits"] = "objectBoundingBox"
    if draft.maybe(0.25):
        middle = number(box.x + box.width / 2), number(box.y + box.height / 2)
        values["gradientTransform"] = moved(draft, *middle)
    if draft.maybe(0.2):
        values["type"] = draft.pick({"bicubic": 2, "coons": 1})
    translucent = draft.maybe(0.2)
    how = draft.pick(STOPS)(draft, id)

    def paint(colour):
        opacity = {"stop-opacity": f"{draft.chance.uniform(0.2, 1):.2g}"} if translucent else {}
        return how({"stop-color": colour, **opacity})

    rows = rows_of(draft, mesh, write, paint)
    draft.defs.append(draft.pick(HOLDERS)(draft, id, values, rows))
    draft.gradients.append(id)
    return id


def holds_rows(draft, id, values, rows):
    return element("meshgradient", {"id": id, **values}, rows)


def of_another(draft, id, values, rows):
    """The rows, and at times all else, are those of a mesh that another one refers to."""
    holder = draft.name("h")
    own = ("x", "y", "gradientUnits") if draft.maybe(0.5) else ("gradientTransform",)
    kept = {name: value for name, value in values.items() if name in own}
    parts = [
        element("meshgradient", {"id": holder, **values}, rows),
        element("meshgradient", {"id": id, "xlink:href": f"#{holder}", **kept}),
    ]
    if draft.maybe(0.5):
        parts.reverse()
    return "".join(parts)


HOLDERS = {holds_rows: 6, of_another: 1}
