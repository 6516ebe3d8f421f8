"""One mesh in places, sizes and states that are hard on numbers, each as an SVG document."""

import random
import sys

import svg_meshes
from built import SAMPLES

sys.path.append(str(SAMPLES))  # after the tests' own modules of the same names

from meshgrid import Mesh, Notation, colour, meshgradient  # noqa: E402

WIDTH, HEIGHT = 120.0, 90.0
#: What else is in each document, which must stay.
OTHER = '<circle xmlns:a="urn:a" id="other" r="0" fill="red" a:b="&lt;c&gt;"/><!-- kept -->'


def refined_mesh():
    """30 patches of a mesh of 9, refined across and locally recoloured; its outline is a
    rectangle, so that every result has the same frame."""
    chance = random.Random(3)
    corners = [[complex(WIDTH * j, HEIGHT * i) / 3 for j in range(4)] for i in range(4)]
    for i in (1, 2):
        for j in (1, 2):
            corners[i][j] += complex(chance.uniform(-8, 8), chance.uniform(-8, 8))
    paint = ["#205080", "#f0c040", "#c04030", "#60a060"]
    mesh = Mesh(corners, [[colour(paint[(i + j) % 4]) for j in range(4)] for i in range(4)])
    mesh.split_column(1, 0.4, 0.7)
    mesh.split_row(0, 0.5)
    mesh.split_row(3, 0.3, 0.6)
    mesh.dab(colour("#ffffff"), complex(60, 45), 20, 15, 0.6)
    return mesh


def moved(function):
    """A change of all points of a mesh."""

    def change(mesh):
        mesh.points = [[function(p) for p in line] for line in mesh.points]

    return change


def recoloured(function):
    def change(mesh):
        mesh.colours = [[function(c) for c in line] for line in mesh.colours]

    return change


def set_points(*moves):
    """Moves points ((row, column) of the lattice) to the place of others, or by a complex."""

    def change(mesh):
        for (row, column), to in moves:
            if isinstance(to, tuple):
                mesh.points[row][column] = mesh.points[to[0]][to[1]]
            else:
                mesh.points[row][column] += to

    return change


def without_handles(mesh):
    """Every handle at its corner."""
    for i, line in enumerate(mesh.points):
        for j in range(len(line)):
            line[j] = mesh.points[3 * round(i / 3)][3 * round(j / 3)]


def with_crossed_handles(mesh):
    """Handles on the straight line between their corners, each beyond the other's end."""
    for line in mesh.points[3:-3:3]:
        for j in range(0, len(line) - 1, 3):
            a, b = line[j], line[j + 3]
            line[j + 1], line[j + 2] = a + 1.4 * (b - a), a - 0.4 * (b - a)


#: By name: how the points and colours are changed. These are the same mesh in other coordinates.
SAME = {
    "as it is": None,
    "of 1e-6 units": moved(lambda p: 1e-6 / WIDTH * p),
    "of 1e+6 units": moved(lambda p: 1e6 / WIDTH * p),
    "of 1e+8 units": moved(lambda p: 1e8 / WIDTH * p),
    "far away": moved(lambda p: p + complex(1e5, -3e5)),
    "very far away": moved(lambda p: p + complex(3e8, 3e8)),
    "tiny and far away": moved(lambda p: 1e-6 * p + complex(1e4, 1e4)),
    "mirrored": moved(lambda p: complex(WIDTH - p.real, p.imag)),
    "upside down": moved(lambda p: complex(p.real, HEIGHT - p.imag)),
    "turned": moved(lambda p: 1j * p),
}
#: The same, by the gradient's transform.
TRANSFORMED = {
    "scaled by 1e-6": "scale(1e-6)",
    "scaled by 1e+6": "scale(1e6)",
    "mirrored by a transform": "matrix(-1 0 0 1 120 0)",
    "turned by a transform": "rotate(90)",
    "far away by a transform": "translate(1e6 -1e6)",
}
#: Meshes that have something wrong with them, and are simplified all the same.
DEGENERATE = {
    "folded over": set_points(((3, 6), 50 + 20j), ((3, 7), 60 - 9j), ((9, 9), -45j)),
    "turned inside out": set_points(((3, 3), (9, 12)), ((9, 12), -70 - 60j)),
    "side of no length": set_points(*(((9, 6 + k), (9, 9)) for k in range(3))),
    "sides of no length": set_points(*(((i, 6 + k), (i, 9)) for i in range(19) for k in range(3))),
    "opposite corners coincide": set_points(((6, 6), (9, 9))),
    "handles of no length": without_handles,
    "handles crossed": with_crossed_handles,
    "one pixel wide": moved(lambda p: complex(p.real, 0.01 * p.imag)),
    "transparent": recoloured(lambda c: (*c[:3], 0.0)),
    "hardly opaque": recoloured(lambda c: (*c[:3], 0.001)),
    "of one colour": recoloured(lambda c: (0.2, 0.4, 0.6, 1.0)),
    "white": recoloured(lambda c: (1.0, 1.0, 1.0, 1.0)),
}
#: Meshes that are refused, each with the words that the sentence must hold.
POINT = set_points(*(((6 + i, 6 + j), (9, 9)) for i in range(4) for j in range(4)))
REFUSED = {
    "patch of one point": (POINT, "row 3, patch 3 is degenerate"),
    "one point": (moved(lambda p: 5 + 5j), "degenerate"),
    "on a line": (moved(lambda p: complex(p.real, 7)), "covers no pixel"),
    "on a slanted line": (moved(lambda p: complex(p.real, p.real / 3)), "covers no pixel"),
    "hardly wider than a line": (moved(lambda p: complex(p.real, 1e-9 * p.imag)), "covers no pixel"),
    "too large": (moved(lambda p: 1e8 * p), "between -1e9 and 1e9"),
}
CASES = {
    **{name: (change, "") for name, change in {**SAME, **DEGENERATE}.items()},
    **{name: (None, f'gradientTransform="{text}"') for name, text in TRANSFORMED.items()},
    **{name: (change, "") for name, (change, _) in REFUSED.items()},
}


def document(name):
    """The mesh of a case on the object `box`; the bytes of an SVG document."""
    change, attributes = CASES[name]
    mesh = refined_mesh()
    if change:
        change(mesh)
    attributes = f'gradientUnits="userSpaceOnUse" {attributes}'
    gradient = meshgradient(mesh, "m", attributes, Notation(relative=False, digits=24))
    points = [p for line in mesh.points for p in line]
    matrix = svg_meshes.parse_transform(TRANSFORMED.get(name))
    corner, side = frame([svg_meshes.apply(matrix, p) for p in points])
    x, y = corner.real, corner.imag
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" width="240" height="240"'
        f' viewBox="{x!r} {y!r} {side!r} {side!r}"><defs>{gradient}</defs>'
        f'<rect id="box" x="{x!r}" y="{y!r}" width="{side!r}" height="{side!r}"'
        f' fill="url(#m)"/>{OTHER}</svg>'
    ).encode()


def frame(points):
    """The corner and side of a square around all points, none of which is where pixels meet."""
    low = complex(min(p.real for p in points), min(p.imag for p in points))
    size = complex(max(p.real for p in points), max(p.imag for p in points)) - low
    longer = max(size.real, size.imag) or 1.0
    return low - 0.1013 * longer * (1 + 1j), 1.2 * longer
