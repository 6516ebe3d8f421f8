"""A row of one block is cut by a double click in Inkscape's window, and updated."""

import pytest

np = pytest.importorskip("numpy")
pytest.importorskip("PIL.Image")

import svg_meshes
from inkscape_harness import Inkscape
from pictures import difference, flip, gradmesh
from test_pictures import SAME
from test_update_in_window import painted
from test_window_edit import MESH_TOOL, SAMPLES, Editing, corners, pytestmark  # noqa: F401

import gradmesh as core


class Cutting(Editing):
    """The fruit in few patches, so that there is room between handles, and the longest side at a
    block's left double-clicked in its middle."""

    def __init__(self, folder):
        self.whole, self.svg = folder / "whole.svg", folder / "fruit.svg"
        options = ("--patches", 12, "--method", "best")
        gradmesh("simplify", SAMPLES / "fruit.svg", "-o", self.whole, *options)
        self.svg.write_bytes(self.whole.read_bytes())
        self.before = svg_meshes.Document(self.svg).blocks()
        net = max(self.before.values(), key=lambda net: abs(net[3, 0] - net[0, 0]))
        with Inkscape() as inkscape, inkscape.window(self.svg) as window:
            self.open(window)
            self.enter(window)
            window.click(*self.pixel(corners(net)[:2, :2].mean()))
            window.click(*MESH_TOOL)
            window.double_click(*self.pixel(np.array([1, 3, 3, 1]) @ net[:4, 0] / 8))
            window.key("ctrl+s")
        self.after = svg_meshes.Document(self.svg).blocks()
        self.updated = folder / "updated.svg"
        self.said = gradmesh("update", self.svg, "-o", self.updated)


@pytest.fixture(scope="module")
def cutting(tmp_path_factory):
    return Cutting(tmp_path_factory.mktemp("window"))


def patches(net):
    return (net.shape[0] // 3) * (net.shape[1] // 3)


@pytest.mark.full
def test_one_block_has_more_patches(cutting):
    assert cutting.before.keys() == cutting.after.keys()
    grown = [n for n, net in cutting.before.items() if patches(cutting.after[n]) > patches(net)]
    assert len(grown) == 1


@pytest.mark.full
def test_updated_all_of_them_are_in_the_mesh(cutting):
    count = sum(map(patches, cutting.after.values()))
    assert count > 12 and f" {count} patches, " in cutting.said
    assert cutting.said.endswith(", updated\n")


@pytest.mark.full
def test_it_is_painted_as_before(cutting):
    whole = core.load(cutting.whole)
    before = core.render(whole).astype(int)
    after = core.render(core.load(cutting.updated), framed_as=whole).astype(int)
    assert (abs(before - after).max(axis=2) > 3).mean() < 1e-4
    theirs, ours = painted(cutting.updated)
    assert (difference(theirs, ours) > 16).sum() <= 20
    assert flip(theirs, ours) <= SAME
