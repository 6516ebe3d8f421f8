"""Drawings of any number of patches for runs from the command line: folded cloth in soft light.

Made as an artist would: a coarse mesh, refined by whole rows and columns until a few small spots of
light and dirt can be painted in. So much of it carries no information. The same bytes on every run.
"""

import sys
from math import cos, pi, sin
from pathlib import Path
from random import Random

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "samples"))

from meshgrid import Mesh, colour, meshgradient, mix  # noqa: E402
from page import document, grid  # noqa: E402

SIZE = 600


def cloth(rows, columns):
    """An SVG document with one path, `cloth`, painted by 2 rows x 2 columns patches."""
    mesh = _folds(rows, columns)
    for row in reversed(range(rows)):
        mesh.split_row(row, 0.5)
    for column in reversed(range(columns)):
        mesh.split_column(column, 0.5)
    random = Random(1)
    for _ in range(max(3, rows * columns // 25)):
        centre = complex(random.uniform(0, SIZE), random.uniform(0, SIZE))
        paint = random.choice([colour("#fff8e0"), colour("#2b3350"), colour("#c06030")])
        reach = SIZE / rows * random.uniform(0.8, 1.6)
        mesh.dab(paint, centre, reach, reach * random.uniform(0.5, 1), 0.7)
    box = f"M 0,0 H {SIZE} V {SIZE} H 0 Z"
    return document(
        SIZE,
        SIZE,
        "Cloth",
        meshgradient(mesh, "cloth-mesh"),
        f'<path id="cloth" d="{box}" style="fill:url(#cloth-mesh) #8090b0;stroke:none"/>',
    )


def _folds(rows, columns):
    light, shadow = colour("#b9c8ea"), colour("#3d4a78")

    def point(down, right):
        inside = sin(pi * down) * sin(pi * right)
        sway = 0.03 * inside * complex(sin(5 * down + 2 * right), cos(4 * right - down))
        return SIZE * (complex(right, down) + sway)

    def shade(down, right):
        # A fold has about six rows or columns, so that larger meshes hold more of them.
        x, y = columns * right, rows * down
        return mix(shadow, light, 0.5 + 0.45 * sin(x + 1.2 * sin(0.7 * y)) * cos(0.4 * y - 0.3 * x))

    return Mesh(grid(rows, columns, point), grid(rows, columns, shade))
