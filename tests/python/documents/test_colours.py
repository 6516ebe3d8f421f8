"""Colours of CSS Color 4, as Inkscape 1.5 writes them: they are read, and written back as they stood."""

import re

import pytest

np = pytest.importorskip("numpy")

from bad_documents import document, patch, row, stop
from built import ROOT
from program import printed, refused

import gradmesh

# What was picked in each space, and what it is in sRGB: worked out by hand, of 255.
PICKED = {
    "hsl(120, 100, 45.9)": (0, 234, 0),
    "hwb(150 20 10)": (51, 230, 140),
    "lab(29.2345 39.3825 20.0664)": (125, 35, 41),
    "oklch(0.7 0.15 40)": (235, 122, 82),
    "color(xyz 0.3 0.25 0.2)": (186, 120, 117),
    "device-cmyk(0.5 0.2 0 0.1)": (115, 184, 230),
}
OF_1_5 = ROOT.parent / "shared" / "faults5" / "colours-of-inkscape-1.5-become-black.svg"


def flat(color, count=2):
    """Squares in a row that all have this colour."""
    first = patch(*(stop(path, color) for path in ("l 20,0", "l 0,20", "l -20,0", "l 0,-20")))
    next = patch(*(stop(path, color) for path in ("l 20,0", "l 0,20", "l -20,0")))
    return document(row(first, *[next] * (count - 1)))


def middle(path):
    """What is painted inside of the left square."""
    image = np.asarray(gradmesh.render(gradmesh.load(path), "box"), int)
    return image[image.shape[0] // 2, image.shape[1] // 4, :3]


def colors_in(path):
    return re.findall('stop-color[:=]"?([^";]+)', path.read_text())


@pytest.mark.parametrize("color", PICKED)
def test_a_picked_colour_is_painted_and_written_back(tmp_path, color):
    before, after = tmp_path / "before.svg", tmp_path / "after.svg"
    before.write_text(flat(color))
    printed("simplify", before, "-o", after)
    for path in (before, after):
        assert np.abs(middle(path) - PICKED[color]).max() <= 1
    assert colors_in(after) == [color] * 4


def test_colours_that_a_line_took_along_are_remembered(tmp_path):
    before, once, twice = (tmp_path / name for name in ("before.svg", "once.svg", "twice.svg"))
    ends, between = "hsl(120, 100, 45.9)", "hsl(121, 100, 45.9)"
    patches = flat(ends, 40).split("</meshpatch>")
    patches[10:20] = [patch.replace(ends, between) for patch in patches[10:20]]
    before.write_text("</meshpatch>".join(patches))
    printed("simplify", before, "-o", once, "--epsilon", "0.1")
    assert colors_in(once) == [ends] * 4
    printed("simplify", once, "-o", twice, "--epsilon", "0.1")
    for path in (once, twice):
        assert re.search('fill-colors="([^"]*)"', path.read_text())[1] == f"{ends};{between}"
    printed("simplify", before, "-o", once, "--epsilon", "0.1", "--forget-original")
    assert "fill-colors" not in once.read_text()


@pytest.mark.parametrize("method", ["best", "plain"])
@pytest.mark.skipif(not OF_1_5.exists(), reason="the documents are not in ../shared/faults5")
def test_a_document_of_inkscape_1_5_keeps_its_colours(tmp_path, method):
    out = tmp_path / "out.svg"
    picture = np.asarray(gradmesh.render(gradmesh.load(OF_1_5), "r"), int)[..., :3]
    assert picture.max() > 100 and picture.std() > 20
    printed("simplify", OF_1_5, "-o", out, "--method", method, "--epsilon", "0.05")
    kept = set(colors_in(out)) & set(colors_in(OF_1_5))
    assert len(kept) >= 15


def test_a_colour_that_nobody_can_read_is_a_sentence(tmp_path):
    path, out = tmp_path / "in.svg", tmp_path / "out.svg"
    path.write_text(flat("oklch(0.7 0.15)"))
    said = refused("simplify", path, "-o", out)
    assert said == (f'{path}: meshgradient "m": row 1, patch 1, stop 1: the colour "oklch(0.7 0.15)" is none '
                    "that can be read.")
    assert not out.exists()


def test_no_paint_is_black_as_in_inkscape(tmp_path):
    path = tmp_path / "in.svg"
    path.write_text(flat("none"))
    assert list(middle(path)) == [0, 0, 0]
