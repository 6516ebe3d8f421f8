"""Meshes as the format allows them: transparent, on a stroke, borrowed, transformed, twisted."""

from cmath import exp, rect
from math import atan2, cos, pi, sin, sqrt

from meshgrid import Mesh, Notation, colour, meshgradient, mix, ramp, smooth_line, transposed
from page import document, grid, linear, path_data


def disc(down, right):
    """The unit disc's point for a point of the unit square, without folds."""
    a, b = sin(pi * (right - 0.5)), sin(pi * (down - 0.5))
    return complex(a * sqrt(1 - b * b / 2), b * sqrt(1 - a * a / 2))


def opacity():
    """A soap bubble over a checkerboard: clear in its middle, and opacity on the object too."""
    hues = "#ff7ac8 #ffb86b #f6f08a #7de3a0 #6fc8ff #a48bff #ff7ac8".split()
    film = [(k / 6, colour(paint)) for k, paint in enumerate(hues)]

    def point(down, right):
        return 250 + 250j + 193 * disc(down, right)

    def shade(down, right):
        p = disc(down, right)
        turn = (atan2(p.imag, p.real) / (2 * pi) + 0.35 * abs(p)) % 1
        red, green, blue, _ = mix(colour("#f4fbff"), ramp(film, turn), 0.35 + 0.55 * abs(p) ** 2)
        return (red, green, blue, 0.06 + 0.84 * abs(p) ** 4)

    mesh = Mesh(grid(10, 10, point), grid(10, 10, shade))
    for split in (mesh.split_column, mesh.split_row):
        split(7, 0.5)
        split(3, 0.5)
        split(2, 0.5)
    mesh.dab(colour("#ffffff", 1.0), 176 + 160j, 50, 44, 1.0)
    mesh.dab(colour("#ffffff", 0.9), 336 + 340j, 28, 24, 0.8)
    checker = """<pattern id="checker" patternUnits="userSpaceOnUse" width="50" height="50">
<rect width="50" height="50" style="fill:#f4f1ea"/>
<path d="M 0,0 H 25 V 50 H 50 V 25 H 0 Z" style="fill:#33506b"/>
</pattern>"""
    defs = [meshgradient(mesh, "bubble-mesh", notation=Notation(style=False)), checker]
    body = """<rect id="background" width="500" height="500" style="fill:url(#checker)"/>
<circle id="bubble" cx="250" cy="250" r="190"
   style="opacity:0.9;fill:url(#bubble-mesh) #a0d0ff"/>"""
    return document(500, 500, "Soap bubble", "\n".join(defs), body)


def stroke():
    """A loop whose thick stroke, not its fill, is the mesh."""
    hues = "#ff5a5f #ff9f45 #ffd93d #6bcb77 #2ec4c6 #4d96ff #8b5cf6 #d946a8 #ff5a5f".split()
    spectrum = [(k / 8, colour(paint)) for k, paint in enumerate(hues)]

    def point(down, right):
        inner = 0 < down < 1 and 0 < right < 1
        sway = complex(10 * sin(6 * down), 10 * sin(7 * right)) if inner else 0
        return complex(20 + 600 * right, 20 + 320 * down) + sway

    def shade(down, right):
        return mix(ramp(spectrum, (0.86 * right + 0.14 * down)), colour("#2a1a4a"), 0.30 * down)

    mesh = Mesh(grid(4, 8, point), grid(4, 8, shade))
    for row in (3, 2, 1, 0):
        mesh.split_row(row, 0.5)
    mesh.split_column(4, 0.5)
    mesh.split_column(3, 0.5)
    mesh.dab(colour("#ffffff"), 150 + 70j, 90, 52, 0.75)
    mesh.dab(colour("#ffffff"), 490 + 70j, 90, 52, 0.75)
    mesh.dab(colour("#1a0f2e"), 320 + 180j, 70, 60, 0.55)
    notation = Notation(comma=False, closing_point=False)
    body = """<rect id="background" width="640" height="360" style="fill:#f7f3ec"/>
<path id="loop"
   style="fill:none;stroke:url(#loop-mesh) #4d96ff;stroke-width:58;stroke-linejoin:round"
   d="M 320,180 C 400,60 570,40 570,180 C 570,320 400,300 320,180
      C 240,60 70,40 70,180 C 70,320 240,300 320,180 Z"/>"""
    return document(640, 360, "Loop", meshgradient(mesh, "loop-mesh", notation=notation), body)


SPOT_CUTS = (0.08, 0.24, 0.5, 0.76, 0.92)


def white_spot(mesh, top, left):
    """Colours the middle of the 6 x 6 patches at (top, left), and drags their lines to circles."""
    first, beside = 3 * top, 3 * left
    knots = [0, *SPOT_CUTS, 1]
    steps = [2 * mix(a, b, k / 3) - 1 for a, b in zip(knots, knots[1:]) for k in range(3)] + [1]
    along = (mesh.points[first + 9][beside + 18] - mesh.points[first + 9][beside]) / 2
    down = (mesh.points[first + 18][beside + 9] - mesh.points[first][beside + 9]) / 2
    for i, b in enumerate(steps):
        for j, a in enumerate(steps):
            reach = max(abs(a), abs(b))
            rounding = 0.85 * min(1, (1 - reach) / 0.16)
            if reach > 0 and rounding > 0:
                right = a * (sqrt(1 - (b / reach) ** 2 / 2) - 1) * rounding
                below = b * (sqrt(1 - (a / reach) ** 2 / 2) - 1) * rounding
                mesh.points[first + i][beside + j] += right * along + below * down
    for i in (2, 3, 4):
        for j in (2, 3, 4):
            old = mesh.colours[top + i][left + j]
            mesh.colours[top + i][left + j] = mix(old, colour("#fff4e6"), 0.95)


def mushroom_cap():
    """4 x 5 patches; each white spot has its own lines through the whole cap."""
    rows = [(44, 60), (100, 142), (158, 187), (222, 208), (292, 200)]

    def point(down, right):
        y, half = rows[round(4 * down)]
        bend = [0, 14, 22, 24, 0][round(4 * down)]
        return complex(250 - half * cos(pi * right), y + bend * (sin(pi * right) - 0.4))

    def shade(down, right):
        lit = 0.98 - 0.3 * (cos(pi * right) - 0.35) ** 2 - 0.6 * down**3
        return mix(colour("#5c0f1a"), colour("#f2382c"), lit)

    mesh = Mesh(grid(4, 5, point), grid(4, 5, shade))
    for column in (3, 2, 1):
        mesh.split_column(column, *SPOT_CUTS)
    for row in (2, 1):
        mesh.split_row(row, *SPOT_CUTS)
    for row, column in ((1, 2), (2, 1), (2, 3)):
        white_spot(mesh, 6 * row - 5, 6 * column - 5)
    return mesh


def mushroom_stalk():
    def point(down, right):
        half = ramp([(0, 50), (0.4, 42), (0.8, 58), (1, 72)], down)
        y = 236 + 214 * down + 12 * sin(pi * right) * down
        return complex(250 + half * sin(pi * (right - 0.5)), y)

    def shade(down, right):
        lit = 1 - 0.75 * max(0, right - 0.35) ** 1.2 - 0.6 * max(0, 0.25 - down) / 0.25
        return mix(colour("#6d4f3a"), colour("#fff1d6"), lit)

    mesh = Mesh(grid(5, 4, point), grid(5, 4, shade))
    mesh.split_column(2, 0.5)
    mesh.split_column(1, 0.5)
    mesh.split_row(2, 0.5)
    mesh.dab(colour("#c9a27a"), 262 + 350j, 20, 26, 0.6)
    return mesh


def two():
    """A mushroom of two meshes, spelled differently; the stalk's gradient borrows its rows."""
    absolute = Notation(relative=False, style=False)
    defs = [
        meshgradient(mushroom_cap(), "cap-mesh"),
        meshgradient(mushroom_stalk(), "stalk-rows", notation=absolute),
        '<meshgradient id="stalk-mesh" x="200" y="236" xlink:href="#stalk-rows"'
        ' gradientUnits="userSpaceOnUse"/>',
        linear("meadow", (0, "#e7f3d0", 1), (0.75, "#b7d88a", 1), (1, "#6c9d48", 1)),
    ]
    body = """<rect id="background" width="500" height="500" style="fill:url(#meadow)"/>
<ellipse id="shadow" cx="266" cy="456" rx="130" ry="20" style="fill:#2e4a1c;fill-opacity:0.45"/>
<path id="stalk" fill="url(#stalk-mesh) #f0dcc0"
   d="M 204,240 C 214,300 212,350 200,390 C 188,424 180,440 190,450 C 220,466 280,466 310,450
      C 320,440 312,424 300,390 C 288,350 286,300 296,240 Z"/>
<path id="cap" style="fill:url(#cap-mesh) #e03a2c"
   d="M 250,50 C 350,50 448,140 452,250 C 454,284 350,286 250,286
      C 150,286 46,284 48,250 C 52,140 150,50 250,50 Z"/>"""
    return document(500, 500, "Mushroom", "\n".join(defs), body)


def transformed():
    """A leaf whose mesh lives in its own small units, inside rotated, skewed and scaled groups."""
    widths = [0.02, 0.55, 0.88, 1.0, 0.92, 0.70, 0.40, 0.01]

    def point(down, right):
        across = 24 * widths[round(7 * right)] + 0.6
        forward = 11 * abs(2 * down - 1) * sin(pi * right)
        return complex(100 * right + forward, 50 + across * (2 * down - 1) + 5 * sin(pi * right))

    def shade(down, right):
        edge = abs(2 * down - 1)
        green = mix(colour("#a9cf46"), colour("#2f7d32"), edge)
        return mix(green, colour("#f2b134"), 0.85 * right**2 * (0.4 + 0.6 * edge))

    mesh = Mesh(grid(4, 7, point), grid(4, 7, shade))
    mesh.split_row(2, 0.16, 0.55)
    mesh.split_row(1, 0.45, 0.84)
    for column in range(6, -1, -1):
        mesh.split_column(column, 0.5)
    middle = mesh.rows // 2
    for j in range(mesh.columns + 1):
        mesh.colours[middle][j] = mix(mesh.colours[middle][j], colour("#f7f7b0"), 0.8)
        for i in range(1, mesh.rows):
            if j % 2 and i != middle:
                mesh.colours[i][j] = mix(mesh.colours[i][j], colour("#dcea86"), 0.4)
    mesh.dab(colour("#8a3d1a"), 70 + 38j, 9, 8, 0.9)
    upper = smooth_line([4 * point(0, k / 7) - 200 - 198j for k in range(8)])
    lower = smooth_line([4 * point(1, k / 7) - 200 - 202j for k in range(7, -1, -1)])
    # A straight end on either side joins the two edges.
    leaf = path_data(upper + [upper[-1], lower[0]] + lower + [lower[-1], upper[0], upper[0]])
    units = 'gradientUnits="userSpaceOnUse" gradientTransform="matrix(4,0,0,4,-200,-200)"'
    defs = [
        meshgradient(mesh, "leaf-mesh", units, Notation(digits=4)),
        '<filter id="soft"><feGaussianBlur stdDeviation="0.7"/></filter>',
        '<filter id="softer" x="-0.2" width="1.4" y="-0.2" height="1.4">'
        '<feGaussianBlur stdDeviation="7"/></filter>',
        linear("sky", (0, "#fdf6e3", 1), (1, "#cfe3e8", 1)),
    ]
    body = f"""<rect id="background" width="560" height="460" style="fill:url(#sky)"/>
<g id="branch" transform="translate(280,230) rotate(-28)">
<path id="shadow" transform="translate(4,34)" d="{leaf}"
   style="fill:#2c3a3a;fill-opacity:0.35;filter:url(#softer)"/>
<path id="stem" style="fill:#7a8f35"
   d="M -260,22 C -236,16 -214,6 -190,2 L -190,-2 C -216,0 -240,8 -264,14 Z"/>
<g id="wind" transform="scale(1.06,1.15) skewX(-12)">
<path id="leaf" d="{leaf}" style="opacity:0.97;fill:url(#leaf-mesh) #5aa03a;filter:url(#soft)"/>
</g>
</g>"""
    return document(560, 460, "Leaf", "\n".join(defs), body)


def tensor():
    """A small silk square, twisted inside by `tensor`, with every row and column split once."""
    paints = ["#233a8e #3f7fd6 #7fd0e8 #f2f6d0", "#5a2f9a #e8f0ff #49b6d8 #2fa59a"]
    paints += ["#b93d9a #f7a8c8 #3d49b0 #8fe0c0", "#ffb46b #e8507a #8a3fb0 #2b2f7a"]

    def point(down, right):
        inner = 0 < down < 1 and 0 < right < 1
        p = complex(right, down)
        if inner:
            p = 0.5 + 0.5j + (p - 0.5 - 0.5j) * exp(0.45j)
        bulge = complex(0.04 * sin(2 * pi * down), -0.04 * sin(2 * pi * right))
        return 40 + 40j + 360 * (p + (0 if inner else bulge))

    rows = [[colour(paint) for paint in line.split()] for line in paints]
    mesh = Mesh(grid(3, 3, point), rows)
    mesh.twist(1, 1, rect(2.2, 0.9))
    for row, column in ((0, 1), (1, 0), (1, 2), (2, 1)):
        mesh.twist(row, column, rect(1.5, -0.7))
    mesh.twist(0, 0, rect(1.4, 0.5))
    for split in (mesh.split_column, mesh.split_row):
        for line in (2, 1, 0):
            split(line, 0.5)
    border = transposed(mesh.points)
    outline = mesh.points[0] + border[-1][1:] + mesh.points[-1][-2::-1] + border[0][-2::-1]
    body = f"""<rect id="background" width="440" height="440" style="fill:#f6f1e7"/>
<path id="silk" d="{path_data(outline)}" style="fill:url(#silk-mesh) #7fd0e8"/>"""
    return document(440, 440, "Silk", meshgradient(mesh, "silk-mesh"), body)


def smooth():
    """A glass vase whose colours are smooth, type="bicubic", in units wider than they are high."""
    half_widths = [(0, 27), (9, 20), (24, 18), (46, 34), (70, 44), (90, 37), (100, 30)]
    rows, columns = len(half_widths) - 1, 5

    def point(down, right):
        y, half = half_widths[round(rows * down)]
        rim = 3 * sin(pi * right) * (2 * down - 1)
        return complex(50 + half * sin(pi * (right - 0.5)), y + rim)

    def shade(down, right):
        side = sin(pi * (right - 0.5))
        lit = 1.05 - 0.75 * (side + 0.35) ** 2
        glaze = mix(colour("#123a6b", 0.94), colour("#58c4c9", 0.72), max(0, min(1, lit)))
        return mix(glaze, colour("#7a4fb0", 0.96), 0.6 * down**2)

    mesh = Mesh(grid(rows, columns, point), grid(rows, columns, shade))
    for column in (3, 2, 1):
        mesh.split_column(column, 0.5)
    for row in (5, 4, 3, 2, 0):
        mesh.split_row(row, 0.5)
    mesh.dab(colour("#ffffff", 0.95), 33 + 62j, 9, 17, 0.95)
    mesh.dab(colour("#f3fbff", 0.9), 43 + 25j, 6, 9, 0.6)
    mesh.dab(colour("#ff9fb0", 0.9), 68 + 82j, 12, 12, 0.5)
    border = transposed(mesh.points)
    edge = mesh.points[0] + border[-1][1:] + mesh.points[-1][-2::-1] + border[0][-2::-1]
    outline = path_data([complex(80 + 3.2 * p.real, 150 + 4 * p.imag) for p in edge])
    units = (
        'gradientUnits="userSpaceOnUse" type="bicubic" gradientTransform="matrix(3.2,0,0,4,80,150)"'
    )
    defs = [
        meshgradient(mesh, "vase-mesh", units),
        linear("wall", (0, "#f7efe2", 1), (0.72, "#ead9c0", 1), (1, "#c9ad88", 1)),
    ]
    tulips = [(178, 96, "#e8475b"), (240, 62, "#f2a33c"), (304, 100, "#d9569a")]
    stems = " ".join(
        f"M {x},{y} C {x},{y + 40} {240 + 0.5 * (x - 240):g},190 {240 - 0.4 * (x - 240):g},500"
        for x, y, _ in tulips
    )
    flowers = "\n".join(
        f'<path id="tulip{i}" transform="translate({x},{y})" style="fill:{paint}"\n'
        '   d="M -26,-34 L -12,-14 L 0,-40 L 12,-14 L 26,-34'
        ' C 34,14 16,26 0,26 C -16,26 -34,14 -26,-34 Z"/>'
        for i, (x, y, paint) in enumerate(tulips, 1)
    )
    body = f"""<rect id="background" width="480" height="600" style="fill:url(#wall)"/>
<ellipse id="shadow" cx="266" cy="552" rx="150" ry="22" style="fill:#4a2f1a;fill-opacity:0.4"/>
<path id="stems" style="fill:none;stroke:#4f8a3a;stroke-width:9"
   d="{stems}"/>
{flowers}
<path id="vase" d="{outline}" style="fill:url(#vase-mesh) #58a4c9"/>"""
    return document(480, 600, "Vase", "\n".join(defs), body)
