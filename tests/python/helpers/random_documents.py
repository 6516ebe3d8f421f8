"""Random documents by seed: small pages with mesh gradients, written in the ways that people and programs write.

Each way is a line of a table: a function with its weight. Lengths are in hundredths of the page's side until
`Draft.length` writes them in the user units of the document.
"""

import random
import sys
from typing import NamedTuple
from urllib.parse import quote
from xml.sax.saxutils import escape, quoteattr

from built import SAMPLES

sys.path.append(str(SAMPLES))  # after the tests' own modules of the same names

from meshgrid import Mesh, mix  # noqa: E402

XLINK = 'xmlns:xlink="http://www.w3.org/1999/xlink"'
SVG = 'xmlns="http://www.w3.org/2000/svg"'


def document(seed):
    """The bytes of one document; the same for the same seed."""
    draft = Draft(seed)
    drawn = [draw(draft) for _ in range(draft.pick({1: 4, 2: 3, 3: 1}))]
    sheets = draft.pick(SHEETS)(draft) if draft.rules else ""
    body = f"{sheets}<defs>{''.join(draft.defs)}</defs>\n" + "\n".join(drawn)
    root = attributes({**draft.page.root, "id": "page"})
    return draft.pick(ENCODINGS)(draft, f"<svg {SVG} {XLINK} {root}>\n{body}\n</svg>\n")


class Box(NamedTuple):
    x: float
    y: float
    width: float
    height: float

    def grown(self, by):
        return Box(self.x - by, self.y - by, self.width + 2 * by, self.height + 2 * by)


class Page(NamedTuple):
    root: dict  #: attributes of the outermost element
    unit: float  #: user units in a hundredth of the side


class Draft:
    """A document that is being written, and the chance by which all of it is chosen."""

    def __init__(self, seed):
        self.chance = random.Random(seed)
        self.rules, self.defs, self.gradients = [], [], []
        self._names = 0
        self._spelled = self.pick(NAMES)
        self.page = self.pick(PAGES)(self)

    def pick(self, table):
        (one,) = self.chance.choices(list(table), list(table.values()))
        return one

    def maybe(self, share):
        return self.chance.random() < share

    def name(self, stem):
        """A new id, spelled in the way of this document."""
        self._names += 1
        return self._spelled(f"{stem}{self._names}")

    def length(self, hundredths):
        return f"{hundredths * self.page.unit:.6g}"

    def lengths(self, *pairs):
        return " ".join(f"{self.length(x)},{self.length(y)}" for x, y in pairs)

    def box(self):
        x, y = self.chance.uniform(3, 40), self.chance.uniform(3, 40)
        return Box(x, y, self.chance.uniform(25, 97 - x), self.chance.uniform(25, 97 - y))

    def colour(self):
        return "#%06x" % self.chance.randrange(1 << 24)


def attributes(values):
    return " ".join(f"{name}={quoteattr(str(value))}" for name, value in values.items())


def element(tag, values, content=""):
    opening = f"{tag} {attributes(values)}".strip()
    return f"<{opening}>{content}</{tag}>" if content else f"<{opening}/>"


# --- ids, and what refers to them ---

NAMES = {
    str: 12,
    lambda name: f"grün-{name}": 2,
    lambda name: f"ein {name}": 2,
    lambda name: f"a.b.{name}": 2,
    lambda name: f"-{name}_-x": 1,
    lambda name: f"a\u00a0{name}": 1,
    lambda name: f"{name}:1": 1,
    lambda name: f"{name}(2)": 0.5,
}


def url(draft, id):
    """A reference to an id that is a value of a property: escaped where it must be, else at times."""
    text = quote(id) if " " in id or "(" in id or draft.maybe(0.2) else id
    return draft.pick({"url(#{})": 12, "url('#{}')": 1, 'url("#{}")': 1, "url( #{} )": 0.5}).format(text)


def in_selector(id):
    """An id as style sheets write it."""
    return "".join(letter if letter.isalnum() or letter in "_-" else "\\" + letter for letter in id)


# --- pages ---


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

# --- meshes ---


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


def moved(draft, x, y):
    """A transform around a point."""
    turned = f"rotate({draft.chance.uniform(-40, 40):.4g} {x} {y})"
    there, back = f"translate({x} {y})", f"translate(-{x} -{y})"
    return draft.pick({
        turned: 2,
        f"{there} scale(0.8 1.1) {back}": 1,
        f"{there} skewX(20) {back}": 1,
        f"{there} matrix(1 0.2 -0.3 0.9 0 0) {back}": 1,
        f"{there} scale(-1 1) {back}": 1,
        f"translate({x}) rotate(10) translate(-{x})": 1,
    })  # fmt: skip


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

# --- shapes ---


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

# --- selectors: each returns a selector, and what lies around the element that it selects ---


def of_id(draft, tag, values):
    return f"#{in_selector(values['id'])}", "{}"


def of_class(draft, tag, values):
    values["class"] = draft.pick({"k": 3, "other k": 1, "k-2_b": 1})
    return "." + values["class"].split()[-1], "{}"


def of_element(draft, tag, values):
    return tag, "{}"


def of_all(draft, tag, values):
    return "*", "{}"


def of_element_and_class(draft, tag, values):
    selector, around = of_class(draft, tag, values)
    return tag + selector, around


def of_descendant(draft, tag, values):
    return f".outer {tag}", '<g class="outer"><g>{}</g></g>'


def of_child(draft, tag, values):
    return draft.pick({f".outer > {tag}": 1, f"g.outer>{tag}": 1}), '<g class="outer">{}</g>'


def of_neighbour(draft, tag, values):
    return f".before + {tag}", '<g class="before"/>{}'


def of_attribute(draft, tag, values):
    values["title"] = "soft"
    return draft.pick({'[title="soft"]': 1, f"{tag}[title]": 1, "[title=soft]": 1}), "{}"


def of_first_child(draft, tag, values):
    return f"{tag}:first-child", "<g>{}<g/></g>"


def of_second_child(draft, tag, values):
    return f"{tag}:nth-child(2)", "<g><g/>{}</g>"


def of_several(draft, tag, values):
    selector, around = of_class(draft, tag, values)
    return f"#none, {selector}, .gone", around


SELECTORS = {
    of_class: 6, of_id: 3, of_element: 1, of_all: 0.4, of_element_and_class: 1, of_descendant: 1, of_child: 1,
    of_neighbour: 1, of_attribute: 1, of_first_child: 1, of_second_child: 0.5, of_several: 1,
}  # fmt: skip

# --- paint: each returns what lies around the element, whose attributes it changes ---


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

# --- where an object lies: each gives what is drawn for an object with an id ---


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


def reference(draft, id):
    name = draft.pick({"xlink:href": 8, "href": 1})
    return {name: "#" + (quote(id) if " " in id or "(" in id else id)}


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


def draw(draft):
    """One object in its place."""
    box = draft.box()
    tag, values, content = draft.pick(SHAPES)(draft, box)
    values["id"] = id = draft.name("o")
    if draft.maybe(0.2):
        values["transform"] = moved(draft, draft.length(box.x + box.width / 2), draft.length(box.y + box.height / 2))
    paint = draft.pick(PARTS)(draft, box)
    around = draft.pick(PAINTS)(draft, tag, values, paint)
    drawn = around.format(element(tag, values, content))
    return draft.pick(PLACES)(draft, drawn, id)


# --- style sheets, and the bytes ---


def rule_text(rule):
    selector, values = rule
    return selector + "{" + ";".join(f"{name}:{value}" for name, value in values.items()) + "}"


def one_sheet(draft):
    return f"<style>{escape(' '.join(map(rule_text, draft.rules)))}</style>\n"


def several_sheets(draft):
    return "".join(f'<style type="text/css">{escape(rule_text(rule))}</style>\n' for rule in draft.rules)


def in_cdata(draft):
    lines = "\n".join(map(rule_text, draft.rules))
    return f'<style type="text/css"><![CDATA[\n/* colours */ {lines}\n]]></style>\n'


def for_media(draft):
    medium = draft.pick({"screen": 2, "all": 1, "print": 1})
    return f"<style>@media {medium} {{ {escape(' '.join(map(rule_text, draft.rules)))} }}</style>\n"


SHEETS = {one_sheet: 6, several_sheets: 2, in_cdata: 2, for_media: 0.7}


def plain(draft, text):
    return text.encode("utf-8")


def declared(draft, text):
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}'.encode("utf-8")


def with_mark(draft, text):
    return f'\ufeff<?xml version="1.0"?>\n{text}'.encode("utf-8")


def sixteen_bits(draft, text):
    return b"\xff\xfe" + f'<?xml version="1.0" encoding="UTF-16"?>\n{text}'.encode("utf-16-le")


def latin(draft, text):
    return f'<?xml version="1.0" encoding="ISO-8859-1"?>\n{text}'.encode("iso-8859-1", "xmlcharrefreplace")


def with_entities(draft, text):
    """Units, names and namespaces are entities, as some programs write them."""
    entities = {"user": "userSpaceOnUse"}
    if draft.maybe(0.3):
        entities["ns_svg"] = "http://www.w3.org/2000/svg"
    for name, value in entities.items():
        text = text.replace(f'"{value}"', f'"&{name};"')
    lines = "".join(f'<!ENTITY {name} "{value}">\n' for name, value in entities.items())
    return f'<?xml version="1.0"?>\n<!DOCTYPE svg [\n{lines}]>\n{text}'.encode("utf-8")


ENCODINGS = {plain: 8, declared: 4, with_mark: 1, sixteen_bits: 1, latin: 1, with_entities: 1}
