"""One block alone is edited in Inkscape's window, which tears the mesh; updated it is whole again."""

import pytest


np = pytest.importorskip("numpy")
pytest.importorskip("PIL.Image")

import pictures
import svg_meshes
from inkscape_harness import Inkscape
from pictures import difference, export, flip, gradmesh
from test_pictures import SAME
from test_window_edit import DRAG, ROUNDING, Editing, corners, pytestmark  # noqa: F401


class EditingOne(Editing):
    """As Editing, but of the smallest block alone that has the corner: it lies above the others."""

    def select(self, window):
        owners = [net for net in self.before.values() if self.corner in corners(net)]
        net = min(owners, key=lambda net: net.size)
        row, column = np.argwhere(corners(net) == self.corner)[0]
        i, j = (min(k, n - 2) for k, n in zip((row, column), corners(net).shape))
        window.click(*self.pixel(corners(net)[i : i + 2, j : j + 2].mean()))

    def copies_of_corner(self, blocks):
        """Where the blocks have the corner now, that had it before."""
        return {
            name: corners(blocks[name])[corners(net) == self.corner][0]
            for name, net in self.before.items()
            if self.corner in corners(net)
        }


@pytest.fixture(scope="module")
def editing(tmp_path_factory):
    return EditingOne(tmp_path_factory.mktemp("window"))


@pytest.fixture(scope="module")
def updated(editing):
    path = editing.svg.with_name("updated.svg")
    assert gradmesh("update", editing.svg, "-o", path).endswith("updated\n")
    return path


def painted(svg):
    """The bare mesh by Inkscape, and by gradmesh, which always sees it whole."""
    bare, ours = svg.with_name(f"bare-{svg.name}"), svg.with_suffix(".ours.png")
    document = svg_meshes.Document(svg)
    pictures.write_bare_mesh(document, document.by_id["pear"], bare)
    gradmesh("render", svg, "--like-inkscape", "-o", ours)
    with Inkscape() as inkscape:
        (theirs,) = export(inkscape, [bare])
    return theirs, ours


def test_the_corner_has_moved_in_one_block_only(editing):
    places = editing.copies_of_corner(editing.after).values()
    moved = [abs(p - editing.corner) > ROUNDING for p in places]
    assert len(moved) > 1 and sum(moved) == 1


def test_updated_the_corner_is_one_again_where_it_was_put(editing, updated):
    places = editing.copies_of_corner(editing.after).values()
    put = max(places, key=lambda p: abs(p - editing.corner))
    assert abs(put - editing.corner - DRAG / editing.zoom) < 3 / editing.zoom
    blocks = svg_meshes.Document(updated).blocks().values()
    here = [p for net in blocks for p in corners(net).ravel() if abs(p - put) < 1]
    assert len(set(here)) == 1 and abs(here[0] - put) < ROUNDING
    assert sum((corners(net) == here[0]).any() for net in blocks) == len(places)


def test_what_was_torn_is_whole(editing, updated):
    theirs, ours = painted(editing.svg)
    assert (difference(theirs, ours) > 16).sum() > 200
    theirs, ours = painted(updated)
    assert (difference(theirs, ours) > 16).sum() <= 20
    assert flip(theirs, ours) <= SAME


def test_nothing_is_left_to_update(updated):
    again = updated.with_name("again.svg")
    assert gradmesh("update", updated, "-o", again).endswith("not edited\n")
    assert again.read_bytes() == updated.read_bytes()
