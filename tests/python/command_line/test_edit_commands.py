"""The commands that edit by hand: merge, refine, color and one-mesh, of SVG documents and .hemesh files."""

import json

import numpy as np
import pytest
from PIL import Image

from built import SAMPLES
from hemesh_files import grid
from program import error, listed, meshes, printed, refused

FRUIT = SAMPLES / "fruit.svg"
QUICK = ("--resolution", "100")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Documents to edit: a mesh gradient, blocks, a grid, and a grid with a T-junction."""
    folder = tmp_path_factory.mktemp("edited")
    (folder / "fruit.svg").write_bytes(FRUIT.read_bytes())
    printed("simplify", FRUIT, "-o", folder / "blocks.svg", "--method", "best", "--epsilon", "0.02", *QUICK, "--quiet")
    (folder / "grid.hemesh").write_text(grid(3, 4))
    refine = ("--patches", "5", "--direction", "columns", "--quiet")
    printed("refine", folder / "grid.hemesh", "-o", folder / "junction.hemesh", *refine)
    return folder


def edited(command, document, out, *options):
    """What the command says of the one mesh that it edits."""
    said = printed(command, document, "-o", out, "--json", *QUICK, *options)
    (mesh,) = json.loads(said)["meshes"]
    return mesh


#: What becomes of the number of patches.
EDITS = [
    ("merge", "fruit.svg", "--rows 2-3 --columns 4-6", -5),
    ("merge", "fruit.svg", "--id pear --rows 2 --columns 4-6", -2),
    ("merge", "fruit.svg", "--patches 0,1,12,13", -3),
    ("merge", "grid.hemesh", "--patches 0,1", -1),
    ("merge", "grid.hemesh", "--id mesh --columns 1-2", -5),
    ("merge", "junction.hemesh", "--patches 5,12", -1),
    ("refine", "fruit.svg", "--row 2 --column 3", 3),
    ("refine", "fruit.svg", "--patches 14 --direction rows", 1),
    ("refine", "blocks.svg", "--patches 0,1 --direction columns", 2),
    ("refine", "grid.hemesh", "--direction rows --place 0.3", 12),
    ("refine", "grid.hemesh", "--patches 5,6 --direction rows --whole", 4),
    ("refine", "grid.hemesh", "--patches 5,9 --direction rows --whole", 8),
    ("refine", "grid.hemesh", "--row 1 --column 1 --whole", 8),
    ("color", "fruit.svg", "--points 60 --color red", 0),
    ("color", "fruit.svg", "--points 60 --patches 43,44 --color #102030", 0),
    ("color", "grid.hemesh", "--points 2 --patches 0 --color rgb(9,99,199)", 0),
    ("color", "fruit.svg", "--points 60,61 --patches 43,44 --color navy", 0),
    ("color", "junction.hemesh", "--points 6,7 --join", 0),
    ("one-mesh", "junction.hemesh", "", 2),
]  # fmt: skip


@pytest.mark.parametrize("command, document, options, more", EDITS, ids=lambda value: str(value))
@pytest.mark.full(all_but=1)
def test_what_becomes_of_the_patches(folder, tmp_path, command, document, options, more):
    out = tmp_path / document
    told = edited(command, folder / document, out, *options.split())
    (before,), (after,) = meshes(folder / document), meshes(out)
    assert after["patches"] == before["patches"] + more
    for name in ("handles", "patches"):
        assert (told[f"{name}_before"], told[f"{name}_after"]) == (before[name], after[name])
    assert (told["id"], told["objects"]) == (after["id"], after["objects"])
    shows_nothing = command in ("refine", "one-mesh") and document != "blocks.svg"
    assert told["error"] < 1e-3 if shows_nothing else told["error"] < 0.2


def test_what_is_told_and_what_is_not(folder, tmp_path):
    said = printed("refine", folder / "grid.hemesh", "-o", tmp_path / "out.hemesh", "--row", "1", "--column", "1")
    assert said == "mesh: 107 handles (82 before), 15 patches (12 before), 1 object, FLIP 0.00000\n"
    quiet = ("refine", folder / "grid.hemesh", "-o", tmp_path / "out.hemesh", "--patches", "0", "--quiet")
    assert printed(*quiet) == ""


@pytest.mark.parametrize("document", ["fruit.svg", "grid.hemesh"])
def test_a_preview_shows_the_mesh_as_it_is_and_as_it_would_become(folder, tmp_path, document):
    kept = (folder / document).read_bytes()
    picture, out = tmp_path / "preview.png", tmp_path / document
    edit = ("merge", folder / document, "--patches", "0,1", "--resolution", "200")
    said = printed(*edit, "--preview", picture)
    assert [path.name for path in tmp_path.iterdir()] == ["preview.png"]
    assert (folder / document).read_bytes() == kept
    assert printed(*edit, "-o", out) == said
    shown = np.array(Image.open(picture))
    left = 0
    for file in (folder / document, out):
        printed("render", file, "-o", tmp_path / "bare.png", "--resolution", "200")
        bare = np.array(Image.open(tmp_path / "bare.png"))
        height, width, _channels = bare.shape
        lines = shown[:height, left : left + width]
        assert 0.02 < (lines != bare).any(axis=2).mean() < 0.5
        left += width + 8
    assert shown.shape[1] == left - 8


def test_a_split_is_taken_back_by_a_merge(folder, tmp_path):
    refined, merged = tmp_path / "refined.hemesh", tmp_path / "merged.hemesh"
    edited("refine", folder / "grid.hemesh", refined, "--patches", "5", "--direction", "rows", "--place", "0.3")
    # A new patch comes after the one that it was cut off.
    edited("merge", refined, merged, "--patches", "5,12")
    assert meshes(merged)[0]["t_junctions"] == 0
    assert error(folder / "grid.hemesh", merged) < 1e-4


def colors_at_points(path):
    """The colours of patches, in 8 bits, by the numbers of points and of patches."""
    colors = {}
    for h in listed(path)["meshes"][0]["elements"]["halfedges"]:
        if h["face"] is not None:
            of_point = colors.setdefault(h["origin"], {})
            of_point[h["face"]] = tuple(round(255 * channel) for channel in h["color"][:3])
    return colors


def sharp_points(path):
    return {point: colors for point, colors in colors_at_points(path).items() if len(set(colors.values())) > 1}


@pytest.mark.parametrize("document, point", [("grid.hemesh", 2), ("fruit.svg", 60)])
def test_colors_are_sharp_at_a_point_until_they_are_joined(folder, tmp_path, document, point):
    sharp, joined = tmp_path / f"sharp-{document}", tmp_path / f"joined-{document}"
    before = colors_at_points(folder / document)[point]
    assert len(before) == 4 and not sharp_points(folder / document)
    some = ",".join(map(str, sorted(before)[:2]))
    edited("color", folder / document, sharp, "--points", str(point), "--patches", some, "--color", "#010203")
    (mesh,) = meshes(sharp)
    # One mesh gradient cannot hold that, but blocks can.
    assert mesh["simplified"] == (mesh["objects"] > 1) == document.endswith(".svg")
    ((number, colors),) = sharp_points(sharp).items()
    assert sorted(colors.values()) == sorted(2 * [(1, 2, 3)] + 2 * [before[min(before)]])
    edited("color", sharp, joined, "--points", str(number), "--join")
    assert not sharp_points(joined)


#: By the document: a command, options, and what the sentence says.
REFUSED = [
    ("merge", "fruit.svg", "", "no patches are chosen"),
    ("merge", "fruit.svg", "--id pear", "rows and columns of it"),
    ("merge", "fruit.svg", "--patches 0,2", "do not touch along a whole side"),
    ("merge", "fruit.svg", "--patches 0", "one patch already"),
    ("merge", "fruit.svg", "--patches 0,132", "there is no patch 132; the last is 131"),
    ("merge", "fruit.svg", "--rows 12-13", "no row 13"),
    ("merge", "blocks.svg", "--rows 1", "made of blocks"),
    ("merge", "grid.hemesh", "--id box --rows 1", "no mesh with the id"),
    ("merge", "junction.hemesh", "--rows 1", "not one rectangle"),
    ("refine", "fruit.svg", "--row 99", "no row 99"),
    ("refine", "blocks.svg", "", "made of blocks"),
    ("refine", "junction.hemesh", "", "not one rectangle"),
    ("refine", "grid.hemesh", "--patches -1", "there is no patch -1"),
    ("color", "grid.hemesh", "--points 99 --color red", "there is no point 99; the last is 19"),
    ("color", "grid.hemesh", "--points 2,6 --patches 0 --color red", "none of these patches has a corner at point 6"),
    ("color", "grid.hemesh", "--points 2 --patches 0,11 --color red", "patch 11 has no corner at these points"),
    ("one-mesh", "fruit.svg", "", "only simplified meshes"),
    ("one-mesh", "grid.hemesh", "", "only simplified meshes"),
]  # fmt: skip


@pytest.mark.parametrize("command, document, options, words", REFUSED, ids=lambda value: str(value))
def test_what_cannot_be_done_is_told_in_a_sentence(folder, tmp_path, command, document, options, words):
    out = tmp_path / document
    assert words in refused(command, folder / document, "-o", out, *options.split())
    assert not out.exists()


def test_smooth_colors_are_not_edited_by_patches(tmp_path):
    out = tmp_path / "out.svg"
    for command, options in ("merge", "--patches 0,1"), ("refine", "--patches 0"), ("color", "--points 0 --join"):
        assert "follow those of the neighbours" in refused(command, SAMPLES / "smooth.svg", "-o", out, *options.split())


def test_a_preview_of_several_meshes_asks_for_one(tmp_path):
    blocks = tmp_path / "blocks.svg"
    printed("simplify", SAMPLES / "two.svg", "-o", blocks, "--method", "gqe", "--epsilon", "0.02", *QUICK, "--quiet")
    picture = tmp_path / "preview.png"
    assert "choose one with --id" in refused("one-mesh", blocks, "--preview", picture, *QUICK)
    printed("one-mesh", blocks, "--preview", picture, "--id", "cap", *QUICK)
    assert picture.exists()


def test_errors_are_those_against_the_original_that_is_named(folder, tmp_path):
    once, twice = tmp_path / "once.hemesh", tmp_path / "twice.hemesh"
    first = edited("color", folder / "grid.hemesh", once, "--points", "6", "--color", "red")
    against_itself = edited("refine", once, twice, "--patches", "0")
    against_the_first = edited("refine", once, twice, "--patches", "0", "--original", folder / "grid.hemesh")
    assert against_itself["error"] < 1e-3
    assert against_the_first["error"] == pytest.approx(first["error"], rel=0.01)
