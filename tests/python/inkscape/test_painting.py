"""500 random meshes are painted as Inkscape paints them, pixel by pixel."""

import random
import xml.etree.ElementTree as ET
from typing import NamedTuple

import pytest

from in_inkscape import inkscape, needs  # noqa: F401

Image = pytest.importorskip("PIL.Image")
np = pytest.importorskip("numpy")

import pictures
from random_meshes import KINDS
from svg_meshes import SVG, apply, compose, read_net

gradmesh = pytest.importorskip("gradmesh", reason="the compiled package is not there")

pytestmark = needs()

PIXELS = 96  # along a mesh's longer side
ACROSS, IN_STEP, OUT_OF_STEP = 101, 128, 101  # from cell to cell
COLUMNS, CELLS = 10, 50
#: Kinds and seeds; one sheet more has all kinds.
SHEETS = [(kind, 0) for kind in KINDS] + [(kind, 1) for kind in ("Coons", "tensor", "folds")]


class Cell(NamedTuple):
    x: int
    y: int
    width: int
    height: int


class Sheet:
    """An SVG document with a mesh in each of its cells, which is gradmesh's own frame of it.

    Inkscape writes pictures in strips of 64 rows, and which patches reach across one makes a
    difference to cairo's roundings. `--like-inkscape` takes the strips of a picture that begins
    with the frame, so cells that begin with a strip are in step.
    """

    def __init__(self, kinds, seed, down=IN_STEP):
        self.chance = random.Random(f"{kinds} {seed}")
        self.cells = []
        size = {"width": str(COLUMNS * ACROSS), "height": str(CELLS // COLUMNS * down)}
        self.root = ET.Element(SVG + "svg", size)
        ET.SubElement(self.root, SVG + "rect", size, fill="white")
        for i in range(CELLS):
            self._add(KINDS[kinds[i % len(kinds)]], ACROSS * (i % COLUMNS), down * (i // COLUMNS))

    def _add(self, kind, x, y):
        name = f"cell{len(self.cells)}"
        gradient = ET.fromstring(kind.gradient(self.chance, f"{name}-mesh"))
        for element in gradient.iter():
            element.tag = SVG + element.tag
        start = complex(float(gradient.get("x")), float(gradient.get("y")))
        matrix = (*kind.matrix(self.chance), 0.0, 0.0)
        frame = pictures.fit_frame([apply(matrix, read_net(gradient, start))], PIXELS)
        matrix = compose((1, 0, 0, 1, x, y), compose(frame.matrix, matrix))
        gradient.set("gradientTransform", pictures.matrix_text(matrix))
        cell = Cell(x, y, frame.width, frame.height)
        box = {side: str(value) for side, value in cell._asdict().items()}
        self.root.append(gradient)
        ET.SubElement(self.root, SVG + "rect", box, id=name, fill=f"url(#{name}-mesh)")
        self.cells.append(cell)

    def pairs(self, path, png, **how):
        """Of each cell Inkscape's picture and gradmesh's."""
        with Image.open(png) as picture:
            theirs = np.array(picture.convert("RGB"))
        document = gradmesh.load(path)
        for i, (x, y, width, height) in enumerate(self.cells):
            ours = gradmesh.render(document, f"cell{i}", PIXELS, **how)
            yield theirs[y : y + height, x : x + width].astype(int), ours.astype(int)


def levels(theirs, ours):
    """How far each pixel is off, in levels of the channel that is farthest."""
    return np.abs(theirs - ours).max(axis=2)


def around(picture):
    """Each pixel and the eight beside it, along a new first axis."""
    height, width = picture.shape[:2]
    padded = np.pad(picture, ((1, 1), (1, 1), (0, 0)), mode="edge")
    return np.stack([padded[i : i + height, j : j + width] for i in range(3) for j in range(3)])


def levels_beyond_neighbours(theirs, ours):
    """How far ours is beyond what Inkscape paints in a pixel and the eight beside it, where those
    are all inside the mesh in both pictures."""
    near = around(theirs)
    beyond = np.maximum(near.min(axis=0) - ours, ours - near.max(axis=0)).max(axis=2)
    is_white = (near == 255).all(axis=3) | (around(ours) == 255).all(axis=3)
    return beyond.clip(0)[~is_white.any(axis=0)]


@pytest.fixture(scope="module")
def drawn(inkscape, tmp_path_factory):
    """How far all pixels of a sheet are off, by a measure: levels of Inkscape's picture."""
    folder = tmp_path_factory.mktemp("sheets")
    sheets = {key: Sheet([key[0]], key[1]) for key in SHEETS}
    sheets["out of step"] = Sheet(list(KINDS), 0, OUT_OF_STEP)
    paths = {}
    for number, (key, sheet) in enumerate(sheets.items()):
        paths[key] = folder / f"sheet{number}.svg"
        ET.ElementTree(sheet.root).write(paths[key])
    pngs = dict(zip(paths, pictures.export(inkscape, paths.values())))

    def differences(key, measure, **how):
        pairs = sheets[key].pairs(paths[key], pngs[key], **how)
        return np.concatenate([measure(*pair).ravel() for pair in pairs])

    return differences


@pytest.mark.parametrize("sheet", SHEETS, ids=lambda sheet: f"{sheet[0]} {sheet[1]}")
@pytest.mark.full(all_but=1)
def test_like_inkscape_is_what_inkscape_paints(drawn, sheet):
    off = drawn(sheet, levels, like_inkscape=True)
    # Of opacities and of bicubic colours a rounding in a hundred thousand falls the other way.
    assert off.max() <= 1
    assert (off > 0).mean() <= 1e-4


def test_where_inkscape_puts_its_strips_makes_little_difference(drawn):
    off = drawn("out of step", levels, like_inkscape=True)
    # One sample more or less, which shows where colours are steep, and at outlines.
    assert 0 < (off > 1).mean() <= 0.004
    assert (off > 8).mean() <= 0.0002


@pytest.mark.parametrize("sheet", SHEETS, ids=lambda sheet: f"{sheet[0]} {sheet[1]}")
@pytest.mark.full(all_but=1)
def test_centres_of_pixels_are_on_the_same_surface(drawn, sheet):
    """Cairo takes another point of the pixel, up to one pixel away, and rounds down twice."""
    beyond = drawn(sheet, levels_beyond_neighbours)
    assert len(beyond) > 100_000
    # What is narrower than a pixel shows at one point and not at another: slivers of folds.
    folds = sheet[0] == "folds"
    assert (beyond > 2).mean() <= (0.005 if folds else 0.001)
    assert (beyond > 8).mean() <= (0.001 if folds else 5e-5)
