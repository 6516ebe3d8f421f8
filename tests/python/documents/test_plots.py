"""Plots become one grid each: pages with the kinds of records that programs write for the surface of a function.

A grid stands for triangles only where no one sees the difference, with a FLIP of at most 0.01: two triangles of a cell
bend where the bilinear patch does not, the less the smaller the cell. Sizes here are such ones of this surface.
"""

import math
import struct
import zlib

import pytest

import built  # noqa: F401, which says where the package is
from pdf_pages import document

gradmesh = pytest.importorskip("gradmesh", reason="the compiled package is not there")

POINTS = 2**32 - 1
DECODE = (-100.0, 300.0)  #: of both coordinates


def height(x, y):
    """Of a surface over the square from 0 to 1."""
    return 0.5 + 0.5 * math.sin(3 * x) * math.cos(4 * y)


def color(z):
    return (z, 0.3 + 0.4 * z, 1 - z)


def mean(values):
    return tuple(sum(each) / len(values) for each in zip(*values))


class Lattice:
    """Corners of cells, 160 points wide, that lie as they are wanted."""

    def __init__(self, cells, color_of=color):
        self.cells = cells
        self.step = 160 / cells
        self.color_of = color_of

    def corner(self, i, j):
        return (20 + self.step * j, 20 + self.step * i), self.color_of(height(j / self.cells, i / self.cells))

    def cell(self, i, j):
        """Its corners, one after the other around it."""
        return [self.corner(i, j), self.corner(i, j + 1), self.corner(i + 1, j + 1), self.corner(i + 1, j)]

    def all_cells(self):
        return [self.cell(i, j) for i in range(self.cells) for j in range(self.cells)]


def packed(point, color):
    """A vertex in 32 bits a coordinate and 8 a component."""
    low, high = DECODE
    raw = [round((each - low) / (high - low) * POINTS) for each in point]
    return struct.pack(">II", *raw) + bytes(round(255 * each) for each in color)


def triangles(corners):
    """Each is a new one, as matplotlib, gl2ps and pgfplots write them: a flag of 0 before every vertex."""
    return b"".join(b"\0" + packed(*corner) for corner in corners)


def shading(data, kind=4, components=3, more=""):
    """A stream object of a shading."""
    low, high = DECODE
    entries = (
        f"/ShadingType {kind} /ColorSpace /DeviceRGB /BitsPerCoordinate 32 /BitsPerComponent 8 /BitsPerFlag 8"
        f" /Decode [{low} {high} {low} {high} {'0 1 ' * components}] /Filter /FlateDecode {more}"
    )
    return entries, zlib.compress(data)


def page(*shadings):
    """A page that paints shadings one after another."""
    names = " ".join(f"/s{n} {5 + n} 0 R" for n in range(len(shadings)))
    content = " ".join(f"/s{n} sh" for n in range(len(shadings)))
    return document(f"/MediaBox [0 0 200 200] /Resources << /Shading << {names} >> >>", content, shadings)


def fans(lattice):
    """The cells of matplotlib's lattices: four triangles around a point in the middle, which has what is the mean of
    the corners."""
    data = b""
    for cell in lattice.all_cells():
        middle = mean([place for place, _ in cell]), mean([color for _, color in cell])
        for n in range(4):
            data += triangles([cell[n], cell[(n + 1) % 4], middle])
    return data


def load(data):
    """The document of a page; skips the test where none is read."""
    try:
        return gradmesh.loads(data, "plot.pdf")
    except gradmesh.InputError as error:
        if "was built without PDF" in str(error):
            pytest.skip(str(error))
        raise


def found(data):
    """Of the only mesh of a page what `info` says was found."""
    (mesh,) = gradmesh.info(load(data))["meshes"]
    return mesh["found"]


@pytest.mark.parametrize("cells", [1, 5, 99])
@pytest.mark.full(all_but=1)
def test_cells_of_matplotlib_are_one_grid_of_their_corners(cells):
    """Of 2 x 2 to 4 x 4 cells some bend by more than 4 levels of 255, and stay four triangles each."""
    mesh = found(page(shading(fans(Lattice(cells)))))
    assert (mesh["rows"], mesh["columns"]) == (cells, cells)
    assert mesh["patches"] == cells * cells
    assert mesh["difference"] < 0.01


def test_middles_that_no_one_expects_stay_points():
    """The cell's four triangles are seen, and are no grid."""
    data = b""
    for cell in Lattice(4).all_cells():
        middle = mean([place for place, _ in cell]), (1, 1, 0)
        for n in range(4):
            data += triangles([cell[n], cell[(n + 1) % 4], middle])
    mesh = found(page(shading(data)))
    assert (mesh["rows"], mesh["columns"], mesh["patches"]) == (0, 0, 4 * 4 * 4)
    assert mesh["handles"] == 5 * 5 + 4 * 4
    assert mesh["difference"] < 0.01


def halves(cell):
    """The two triangles of a cell."""
    a, b, c, d = cell
    return [a, b, d], [b, c, d]


def test_triangles_of_gl2ps_are_one_grid():
    """Each is a shading of its own. 16 x 16 cells would keep their triangles."""
    shadings = [shading(triangles(half)) for cell in Lattice(20).all_cells() for half in halves(cell)]
    mesh = found(page(*shadings))
    assert (mesh["rows"], mesh["columns"], mesh["shadings"]) == (20, 20, 800)
    assert mesh["difference"] < 0.01


FUNCTION = "/Function << /FunctionType 2 /Domain [0 1] /C0 [0 0 0.6] /C1 [1 0.9 0] /N 1 >>"


@pytest.mark.parametrize("kind", ["triangles", "lattice"])
def test_surfaces_of_pgfplots_are_one_grid(kind):
    """Their colours are a parameter of a function. 24 x 24 cells are its 25 samples unless one asks for others;
    triangles are one grid from 20 x 20 on, lattices, of which flat cells are patches anyway, from 14 x 14."""
    lattice = Lattice(24, color_of=lambda z: (z,))
    if kind == "triangles":
        data = b"".join(triangles(half) for cell in lattice.all_cells() for half in halves(cell))
        made = shading(data, components=1, more=FUNCTION)
    else:
        corners = [lattice.corner(i, j) for i in range(25) for j in range(25)]
        data = b"".join(packed(*corner) for corner in corners)
        made = shading(data, kind=5, components=1, more=f"/VerticesPerRow 25 {FUNCTION}")
    mesh = found(page(made))
    assert (mesh["rows"], mesh["columns"]) == (24, 24)
    assert mesh["difference"] < 0.01


def coons(cell):
    """A record of a patch with straight sides: the points around it, then the colours of its corners."""
    places = []
    for n in range(4):
        (ax, ay), (bx, by) = cell[n][0], cell[(n + 1) % 4][0]
        places += [(ax + k / 3 * (bx - ax), ay + k / 3 * (by - ay)) for k in range(3)]
    points = b"".join(packed(place, ()) for place in places)
    return b"\0" + points + b"".join(bytes(round(255 * each) for each in color) for _, color in cell)


def test_tiles_of_asymptote_are_one_grid():
    """Each is a shading of one patch."""
    mesh = found(page(*(shading(coons(cell), kind=6) for cell in Lattice(8).all_cells())))
    assert (mesh["rows"], mesh["columns"], mesh["shadings"]) == (8, 8, 64)
    assert mesh["difference"] < 0.01


def test_lines_of_a_plot_that_no_one_sees_are_taken_out():
    plot = load(page(shading(fans(Lattice(12)))))
    (mesh,) = gradmesh.info(plot)["meshes"]
    gradmesh.simplify(plot)
    (simpler,) = gradmesh.info(plot)["meshes"]
    assert mesh["handles"] == 13 * 13
    assert simpler["handles"] < 12 * 13
    assert simpler["objects"] == 1
