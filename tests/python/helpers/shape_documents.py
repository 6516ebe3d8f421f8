"""Documents of one shape of each kind, painted by a mesh gradient."""

#: The side of the square that a shape has for itself, in user units, and how many are beside one another.
CELL, COLUMNS = 100, 6
#: The colour of two marks, in the document's upper left and lower right corners.
MARK = (255, 0, 255)

FILL = 'id="{id}" style="fill:url(#{mesh})"'
STROKE = 'id="{id}" style="fill:none;stroke:url(#{mesh});stroke-width:15"'
SQUARE = 'x="10" y="10" width="80" height="80"'
STAR = (
    'd="M10,10H90V90H10Z" sodipodi:type="star" sodipodi:sides="4" sodipodi:cx="50" sodipodi:cy="50" '
    'sodipodi:r1="56.5685" sodipodi:r2="28" sodipodi:arg1="0.785398" sodipodi:arg2="1.5708" inkscape:flatsided="true"'
)
SLICE = (
    'd="M90,50A40,40 0 0 1 10,50Z" sodipodi:type="arc" sodipodi:cx="50" sodipodi:cy="50" sodipodi:rx="40" '
    'sodipodi:ry="40" sodipodi:start="0" sodipodi:end="3.14159" sodipodi:arc-type="slice"'
)
#: The shapes in their squares, and the boxes of what they paint there.
SHAPES = {
    "path": (f'<path d="M10,10H90V90H10Z" {FILL}/>', (10, 10, 80, 80)),
    "rect": (f"<rect {SQUARE} {FILL}/>", (10, 10, 80, 80)),
    "round rect": (f'<rect {SQUARE} rx="20" {FILL}/>', (10, 10, 80, 80)),
    "circle": (f'<circle cx="50" cy="50" r="40" {FILL}/>', (10, 10, 80, 80)),
    "ellipse": (f'<ellipse cx="50" cy="50" rx="40" ry="30" {FILL}/>', (10, 20, 80, 60)),
    "polygon": (f'<polygon points="10,10 90,10 90,90" {FILL}/>', (10, 10, 80, 80)),
    "polyline": (f'<polyline points="10,10 90,10 90,90" {FILL}/>', (10, 10, 80, 80)),
    "star": (f"<path {STAR} {FILL}/>", (10, 10, 80, 80)),
    "slice": (f"<path {SLICE} {FILL}/>", (10, 50, 80, 40)),
    "turned": (f'<rect transform="rotate(20 50 50)" x="20" y="30" width="60" height="40" {FILL}/>', (20, 30, 60, 40)),
    "in a group": (
        f'<g transform="translate(10 10) scale(2)"><rect width="40" height="40" {FILL}/></g>',
        (0, 0, 40, 40),
    ),
    "filled by a group": (f'<g style="fill:url(#{{mesh}})"><rect id="{{id}}" {SQUARE}/></g>', (10, 10, 80, 80)),
    "cloned": (
        f'<rect x="10" y="10" width="35" height="80" {FILL}/><use xlink:href="#{{id}}" x="45"/>',
        (10, 10, 35, 80),
    ),
    "symbol": (
        f'<symbol id="{{id}}-symbol"><rect {SQUARE} {FILL}/></symbol><use xlink:href="#{{id}}-symbol"/>',
        (10, 10, 80, 80),
    ),
    "stroked path": (f'<path d="M20,20H80V80H20Z" {STROKE}/>', (20, 20, 60, 60)),
    "stroked rect": (f'<rect x="20" y="20" width="60" height="60" {STROKE}/>', (20, 20, 60, 60)),
    "stroked ellipse": (f'<ellipse cx="50" cy="50" rx="30" ry="30" {STROKE}/>', (20, 20, 60, 60)),
    "stroked line": (f'<line x1="20" y1="20" x2="80" y2="80" {STROKE}/>', (20, 20, 60, 60)),
    "stroked polyline": (f'<polyline points="20,20 80,20 80,80" {STROKE}/>', (20, 20, 60, 60)),
    "text": (f'<text x="10" y="90" font-size="100" {FILL}>B</text>', (0, 0, 100, 100)),
    "two of one gradient": (
        f'<rect x="10" y="10" width="80" height="30" {FILL}/><circle cx="50" cy="70" r="20" '
        f'style="fill:url(#{{mesh}})" id="{{id}}-other"/>',
        (10, 10, 80, 80),
    ),
}
#: The box of a text is not known without its font.
NEVER_IN_A_BOX = {"text"}


def mesh_gradient(name, units, box=(0, 0, 1, 1), lines=4):
    """A grid of squares over a box, whose colours let it become one square; `units` is "box" or "user"."""
    left, top, width, height = box if units == "user" else (0, 0, 1, 1)

    def corner(row, column):
        place = f"{left + width * column / lines:g},{top + height * row / lines:g}"
        return place, f"rgb({40 + 200 * row // lines},{220 - 180 * column // lines},{60 + 100 * row // lines})"

    def patch(row, column):
        around = [corner(row + i, column + j) for i, j in ((0, 0), (0, 1), (1, 1), (1, 0))]
        stops = ""
        for side in range(0 if row == 0 else 1, 4 if column == 0 else 3):
            is_given = (side == 0 and column > 0) or (side == 1 and row > 0)
            color = "" if is_given else f' stop-color="{around[side][1]}"'
            stops += f'<stop path="L {around[(side + 1) % 4][0]}"{color}/>'
        return f"<meshpatch>{stops}</meshpatch>"

    rows = ["".join(patch(row, column) for column in range(lines)) for row in range(lines)]
    said = ' gradientUnits="userSpaceOnUse"' if units == "user" else ""
    content = "".join(f"<meshrow>{row}</meshrow>" for row in rows)
    return f'<meshgradient id="{name}" x="{left}" y="{top}"{said}>{content}</meshgradient>'


def cells(names):
    """Where the squares of these shapes begin, by their names."""
    for i, name in enumerate(names):
        yield name, (CELL * (i % COLUMNS), CELL * (i // COLUMNS))


def shapes_document(units, without=()):
    """A document of all shapes whose meshes can have these units, and their names. The object of a shape has its
    name as id, with `-` for spaces, and is painted by the gradient of that id with `-m`."""
    left_out = {*without, *(NEVER_IN_A_BOX if units == "box" else ())}
    names = [name for name in SHAPES if name not in left_out]
    gradients, body = "", ""
    for name, (x, y) in cells(names):
        shape, box = SHAPES[name]
        ids = {"id": name.replace(" ", "-"), "mesh": name.replace(" ", "-") + "-m"}
        gradients += mesh_gradient(ids["mesh"], units, box)
        body += f'<g id="{ids["id"]}-cell" transform="translate({x} {y})">{shape.format(**ids)}</g>'
    width, height = COLUMNS * CELL, CELL * -(-len(names) // COLUMNS)
    mark = '<path id="mark{}" style="fill:rgb{}" d="M{},{}h6v6h-6z"/>'
    marks = mark.format(1, MARK, 0, 0) + mark.format(2, MARK, width - 6, height - 6)
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
        'xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd" '
        'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
        f'width="{width}" height="{height}" viewBox="0 0 {width} {height}">'
        f'<defs id="defs">{gradients}</defs>{body}{marks}</svg>'
    ), names
