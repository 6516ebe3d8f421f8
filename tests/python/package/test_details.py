"""What is small and stands out is still there once a mesh is simplified, whatever its size in pixels."""

import random

import pytest

import gradmesh
from lattices import document
from meshgrid import Mesh, colour

np = pytest.importorskip("numpy")

pytestmark = pytest.mark.module_only

SIDE = 350  # of the mesh, in user units, and of the picture in which the error is measured, in pixels
#: Least and largest width, and height, in pixels.
SIZES = {"dot": (3, 10, 3, 10), "thin line across": (40, 120, 3, 5), "thin line down": (3, 5, 40, 120)}


def lines(centre, size):
    """Where the lines of a mesh are, so that a cell of this size is around the centre, with an edge of a unit."""
    low, high = centre - size / 2, centre + size / 2
    return [0, 60, low - 50, low - 1, low, high, high + 1, high + 50, SIDE - 40, SIDE]


def ground(x, y):
    """A calm colour."""
    return np.array([90 + x / 6, 110 + y / 7, 150.0])


def with_detail(name, seed):
    """A smooth mesh with a detail of another colour; the document, and the detail's centre."""
    choice = random.Random(seed)
    narrow, wide, low, high = SIZES[name]
    size = (choice.uniform(narrow, wide), choice.uniform(low, high))
    centre = tuple(choice.uniform(SIDE / 2 - 5, SIDE / 2 + 5) for _ in size)
    shade = np.array(choice.choice([(255, 0, 0), (255, 255, 255), (0, 0, 0), (250, 210, 40)]), float)
    xs, ys = (lines(c, s) for c, s in zip(centre, size))
    colours = [
        ["#%02x%02x%02x" % tuple(map(int, shade if {i, j} <= {4, 5} else ground(x, y))) for j, x in enumerate(xs)]
        for i, y in enumerate(ys)
    ]
    mesh = Mesh([[complex(x, y) for x in xs] for y in ys], [[colour(c) for c in row] for row in colours])
    body = f'<rect width="{SIDE}" height="{SIDE}" fill="url(#m)"/>'
    return document(mesh, body), centre


def contrast(shown, centre):
    """How far the colour at the detail's centre is from its ground, as it is painted."""
    picture = gradmesh.render(shown, resolution=SIDE).astype(float)
    column, row = (int(v * len(picture) / SIDE) for v in centre)
    return np.abs(picture[row, column] - ground(*centre)).max()


@pytest.mark.parametrize("amount", ["gentle", "balanced"])
@pytest.mark.parametrize("name", SIZES)
@pytest.mark.parametrize("seed", range(6))
@pytest.mark.full(all_but=1)
def test_a_detail_stays(name, amount, seed):
    text, centre = with_detail(name, seed)
    shown = gradmesh.loads(text)
    before = contrast(shown, centre)
    (result,) = gradmesh.simplify(shown, amount=amount, resolution=SIDE)
    assert result.handles_after < result.handles_before
    # The faintest of the first 16 seeds keeps 0.45, and all others more than half.
    assert contrast(shown, centre) > before / 3
