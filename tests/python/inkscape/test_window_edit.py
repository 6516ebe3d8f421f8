"""In Inkscape's window the blocks of a simplified mesh are one mesh: all handles, joined corners."""

from collections import Counter

import pytest

import inkscape_harness
from in_inkscape import needs
from displays import WINDOW_PROGRAMS
from inkscape_harness import Inkscape

np = pytest.importorskip("numpy")
image = pytest.importorskip("PIL.Image")

import svg_meshes
from built import SAMPLES
from pictures import gradmesh, info

pytestmark = needs(*WINDOW_PROGRAMS)

PAGE = 480 + 600j  # of the sample "fruit"
MESH_TOOL = (16, 511) if inkscape_harness.is_older_than(1, 4) else (13, 532)
DRAG = 14 + 9j  # pixels on the screen
ROUNDING = 1e-3  # Inkscape writes eight digits, relative to the point before


class Editing:
    """The fruit, simplified, in Inkscape's window: its mesh selected, the mesh tool chosen, one
    shared corner dragged, and saved."""

    def __init__(self, folder):
        self.svg = folder / "fruit.svg"
        options = ("--epsilon", 0.03, "--method", "grid")
        gradmesh("simplify", SAMPLES / "fruit.svg", "-o", self.svg, *options)
        self.counts_before = counts(self.svg)
        self.before = svg_meshes.Document(self.svg).blocks()
        with Inkscape() as inkscape, inkscape.window(self.svg) as window:
            self.open(window)
            self.corner = self.lone_shared_corner()
            self.enter(window)
            self.select(window)
            self.selected = pixels(window.screenshot(folder / "selected.png"))
            window.click(*MESH_TOOL)
            self.handles = pixels(window.screenshot(folder / "handles.png"))
            start = self.on_screen(self.corner)
            end = start + DRAG
            window.drag(*(round(v) for v in (start.real, start.imag, end.real, end.imag)))
            window.key("ctrl+s")
        self.after = svg_meshes.Document(self.svg).blocks()

    def select(self, window):
        """All blocks of the group that has been entered."""
        window.key("ctrl+a")

    def open(self, window):
        """Fits the page, the only large thing on the screen that is not grey, into the window."""
        window.key("5")
        shot = pixels(window.screenshot(self.svg.with_name("page.png")))
        beige = shot[:, :, 0] - shot[:, :, 2] > 20
        columns, rows = (longest_run(beige.sum(axis=axis) > 200) for axis in (0, 1))
        self.origin = complex(columns[0], rows[0])
        self.zoom = (columns[-1] + 1 - columns[0]) / PAGE.real
        assert abs(self.zoom * PAGE.imag - (rows[-1] + 1 - rows[0])) < 3

    def enter(self, window):
        """Enters the group of blocks."""
        window.double_click(*self.pixel(240 + 340j))

    def pixel(self, point):
        """Where a point of the page is on the screen."""
        place = self.on_screen(point)
        return round(place.real), round(place.imag)

    def on_screen(self, points):
        return self.origin + self.zoom * points

    def lone_shared_corner(self):
        """The corner of several blocks that is farthest from every other point of the mesh."""
        points = np.unique(np.concatenate([net.ravel() for net in self.before.values()]))
        shared = [p for p, count in shared_corners(self.before).items() if count > 1]
        return max(shared, key=lambda p: np.partition(abs(points - p), 1)[1])


def counts(svg):
    """What `gradmesh info` knows of the pear, but for its elements, of which some have moved."""
    return {name: value for name, value in info(svg)["pear"].items() if name != "elements"}


def longest_run(flags):
    places = np.flatnonzero(flags)
    return max(np.split(places, np.flatnonzero(np.diff(places) > 1) + 1), key=len)


def pixels(png):
    with image.open(png) as picture:
        return np.array(picture.convert("RGB"), int)


def corners(net):
    return net[::3, ::3]


def shared_corners(blocks):
    """In how many blocks each corner lies."""
    return Counter(p for net in blocks.values() for p in np.unique(corners(net)))


@pytest.fixture(scope="module")
def editing(tmp_path_factory):
    return Editing(tmp_path_factory.mktemp("window"))


def changed_share(before, after, places):
    """The share of places on the screen around which the two screenshots differ clearly."""
    clear = abs(before - after).max(axis=2) > 60
    boxes = [(int(p.imag) - 3, int(p.real) - 3) for p in places]
    return np.mean([clear[y : y + 7, x : x + 7].any() for y, x in boxes])


@pytest.mark.full
def test_every_block_shows_its_handles_at_once(editing):
    assert len(editing.before) > 3
    for net in editing.before.values():
        places = editing.on_screen(corners(net).ravel())
        assert changed_share(editing.selected, editing.handles, places) == 1
    # Not everything has changed: the picture itself still shows between the handles.
    rows, columns = np.mgrid[0:40, 0:40]
    everywhere = editing.on_screen(100 + 280 * columns / 40 + 1j * (120 + 380 * rows / 40)).ravel()
    assert changed_share(editing.selected, editing.handles, everywhere) < 0.8


@pytest.mark.full
def test_a_dragged_corner_moves_in_every_block_that_has_it(editing):
    owners = [name for name, net in editing.before.items() if editing.corner in corners(net)]
    assert len(owners) > 1
    moved = [
        p
        for name in owners
        for p in corners(editing.after[name])[corners(editing.before[name]) == editing.corner]
    ]
    assert max(abs(p - moved[0]) for p in moved) < ROUNDING
    assert abs(moved[0] - editing.corner - DRAG / editing.zoom) < 3 / editing.zoom


@pytest.mark.full
def test_all_other_corners_stay_where_they_are(editing):
    assert editing.before.keys() == editing.after.keys()
    for name, net in editing.before.items():
        stays = corners(net) != editing.corner
        assert abs(corners(editing.after[name]) - corners(net))[stays].max() < ROUNDING


@pytest.mark.full
def test_the_edited_file_still_holds_the_same_mesh(editing):
    # As edited it is measured against itself.
    assert counts(editing.svg) == {**editing.counts_before, "remembers": False}
