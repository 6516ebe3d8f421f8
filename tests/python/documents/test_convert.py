"""From .hemesh to SVG and back: gradmesh convert, and simplify from one kind to the other."""

import os
import xml.etree.ElementTree as ET
from math import cos, sin

import numpy as np
import pytest

from built import SAMPLES
from elements import check_elements, elements
from hemesh_files import SHARED, Surface, grid, of_the_authors
from in_inkscape import inkscape  # noqa: F401
from program import error, meshes, printed, refused, simplified as reported
from svg_meshes import LABEL, SVG

import gradmesh


class Curved(Surface):
    """Nowhere a part of one patch, so that merging costs something."""

    def at(self, u, v):
        x, y, r, g, b = super().at(u, v)
        return x, y, r, g + 0.05 * sin(9 * u) * sin(8 * v), b

    def along_u(self, u, v):
        x, y, r, g, b = super().along_u(u, v)
        return x, y, r, g + 0.45 * cos(9 * u) * sin(8 * v), b

    def along_v(self, u, v):
        x, y, r, g, b = super().along_v(u, v)
        return x, y, r, g + 0.4 * sin(9 * u) * cos(8 * v), b


FRUIT = SAMPLES / "fruit.svg"
#: Patches of a grid that are left out, and points of the others once each is cut into 4 x 4.
SHAPES = {
    "rectangle": ((2, 3), (), 8 * 12 + 8 + 12 + 1),
    "corner": ((2, 2), ((0, 1),), 9 * 9 - 16),
    "ring": ((3, 3), ((1, 1),), 13 * 13 - 9),
}


@pytest.fixture
def shape(tmp_path):
    """Writes the .hemesh file of a shape."""

    def write(name):
        path = tmp_path / f"{name}.hemesh"
        (rows, columns), without, _ = SHAPES[name]
        path.write_text(grid(rows, columns, without))
        return path

    return write


def converted(*arguments):
    """The number of patches and the error that are printed."""
    words = printed("convert", *arguments).split()
    assert words[2] == "patches," and words[3] in ("FLIP", "1")
    return int(words[1]), float(words[-1])


@pytest.fixture
def curved(tmp_path):
    """The .hemesh file of a grid of which nothing is a part of one patch."""

    def write(rows, columns):
        path = tmp_path / "curved.hemesh"
        path.write_text(grid(rows, columns, surface=Curved()))
        return path

    return write


def test_a_rectangle_becomes_one_ordinary_mesh(shape, tmp_path):
    leaf, out = shape("rectangle"), tmp_path / "out.svg"
    patches, told = converted(leaf, out, "--subdivide", 4)
    assert patches == 6 * 16 and 0 < told < 0.03
    assert error(leaf, out) == pytest.approx(told, abs=1e-4)
    root = ET.parse(out).getroot()
    assert root.get("viewBox") == f"0 0 {root.get('width')} {root.get('height')}"
    assert root.get("width") == "640"
    (path,), (gradient,) = root.iter(SVG + "path"), root.iter(SVG + "meshgradient")
    assert path.get("id") == "mesh" and path.get(LABEL)
    assert f"fill:url(#{gradient.get('id')})" in path.get("style")
    assert [len(row) for row in gradient] == [12] * 8
    assert "gradmesh" not in out.read_text()
    points = SHAPES["rectangle"][2]
    assert f" handles, 96 patches, 1 object, {points} points, 0 T-junctions\n" in printed("info", out)


@pytest.mark.parametrize("name", ["corner", "ring"])
def test_other_shapes_become_blocks(shape, tmp_path, name):
    mesh, out = shape(name), tmp_path / "out.svg"
    patches, told = converted(mesh, out, "--subdivide", 4)
    (rows, columns), without, points = SHAPES[name]
    assert patches == 16 * (rows * columns - len(without)) and 0 < told < 0.03
    assert error(mesh, out) == pytest.approx(told, abs=1e-4)
    root = ET.parse(out).getroot()
    (group,), (clip,) = root.iter(SVG + "g"), root.iter(SVG + "clipPath")
    assert group.get("id") == "mesh" and len(group) > 1
    outline = clip[0].get("d")
    assert outline.count("M") == (2 if name == "ring" else 1)
    # The blocks are one mesh again: every point is there once.
    counts = f" handles, {patches} patches, {len(group)} objects, {points} points, 0 T-junctions, simplified"
    assert counts in printed("info", out)
    check_elements(elements(out))


def test_smaller_patches_come_closer(shape, tmp_path):
    leaf, out = shape("corner"), tmp_path / "out.svg"
    made = [converted(leaf, out, "--subdivide", n) for n in (2, 4, 8)]
    assert [patches for patches, _ in made] == [3 * n * n for n in (2, 4, 8)]
    errors = [told for _, told in made]
    assert errors[0] > 1.5 * errors[1] > 1.5 * errors[2] > 0


def test_patches_are_split_where_that_is_needed(curved, tmp_path):
    mesh, out = curved(3, 3), tmp_path / "out.svg"
    uniform = converted(mesh, out, "--subdivide", 4)
    patches, told = converted(mesh, out, "--epsilon", 0.02)
    assert 9 < patches < uniform[0] and 0 < told <= 0.02
    assert error(mesh, out) == pytest.approx(told, abs=2e-4)
    assert " 0 T-junctions" not in printed("info", out)
    # What is split in one place only leaves no step of colour along the side of its neighbour.
    found = elements(out)
    check_elements(found)
    junctions = {p["id"] for p in found["points"] if p["stem"] is not None}
    there = [h for h in found["halfedges"] if h["origin"] in junctions and h["face"] is not None]
    assert len(there) > 10 and not any(h["own_color"] for h in there)

    again = tmp_path / "again.svg"
    assert converted(mesh, again) == (patches, told)  # the default
    assert again.read_bytes() == out.read_bytes()
    larger = converted(mesh, out, "--epsilon", 0.04)
    assert larger[0] < patches and told < larger[1] <= 0.04
    assert converted(mesh, out, "--epsilon", 1)[0] == 9


def test_the_result_does_not_depend_on_the_number_of_cores(curved, tmp_path):
    def on_one_core():
        os.sched_setaffinity(0, [min(os.sched_getaffinity(0))])

    mesh, out, one = curved(2, 2), tmp_path / "out.svg", tmp_path / "one.svg"
    converted(mesh, out, "--resolution", 300)
    printed("convert", mesh, one, "--resolution", 300, preexec_fn=on_one_core)
    assert one.read_bytes() == out.read_bytes()


@pytest.mark.full
def test_an_error_that_cannot_be_kept_is_refused(curved, tmp_path):
    mesh, out = curved(2, 2), tmp_path / "out.svg"
    for command in (["convert", mesh, out], ["simplify", mesh, "-o", out]):
        said = refused(*command, "--epsilon", 0.0001, "--resolution", 100)
        assert str(mesh) in said and "above epsilon" in said and not out.exists()


def test_metric_and_resolution_are_those_of_the_measure_alone(shape, tmp_path):
    leaf, out = shape("corner"), tmp_path / "out.svg"
    flip, ssim = (converted(leaf, out, "--metric", metric) for metric in ("flip", "ssim"))
    before = ET.parse(out).getroot().get("width")
    assert flip[1] != ssim[1] > 0
    assert converted(leaf, out, "--resolution", 100)[1] != flip[1]
    assert ET.parse(out).getroot().get("width") == before


def test_from_svg_nothing_is_lost(tmp_path):
    there, back = tmp_path / "pear.hemesh", tmp_path / "pear.svg"
    assert converted(FRUIT, there) == (132, 0)
    assert error(FRUIT, there) == 0
    assert converted(there, back, "--subdivide", 1) == (132, 0)
    assert converted(there, back) == (132, 0)  # as the colours are bilinear already
    sizes = [abs(x) for p in elements(there)["points"] for x in p["position"]]
    assert max(sizes) == pytest.approx(1, abs=0.05)


def test_t_junctions_are_kept(tmp_path):
    simple, there, back = (tmp_path / name for name in ("s.svg", "s.hemesh", "b.svg"))
    printed("simplify", FRUIT, "-o", simple, "--method", "motorcycle")

    def count(path):
        (mesh,) = meshes(path)
        return [mesh[kind] for kind in ("patches", "points", "t_junctions")]

    assert count(simple)[2] > 0
    # A bar that ends in a colour of its own takes its slope from the parent in a .hemesh file.
    assert converted(simple, there)[1] < 0.005
    converted(there, back, "--subdivide", 1)
    assert count(simple) == count(there) == count(back)
    check_elements(elements(there))


def test_from_hemesh_to_hemesh(shape, tmp_path):
    leaf, same, finer = shape("ring"), tmp_path / "same.hemesh", tmp_path / "finer.hemesh"
    assert converted(leaf, same) == (8, 0)
    assert error(leaf, same) == 0
    patches, told = converted(leaf, finer, "--subdivide", 2)
    assert patches == 32 and told < 0.004  # pixels between two levels may take the other one
    assert printed("info", finer) == "mesh: 208 handles, 32 patches, 1 object, 48 points, 0 T-junctions\n"


def test_opacity_is_lost_but_not_silently(tmp_path):
    bubble, out = SAMPLES / "opacity.svg", tmp_path / "out.hemesh"
    assert "opacity is lost" in printed("convert", bubble, out)
    assert "opacity" not in printed("convert", FRUIT, out)
    out.unlink()
    assert "opacities" in refused("simplify", bubble, "-o", out) and not out.exists()


def test_what_cannot_be_converted(shape, tmp_path):
    leaf, out = shape("corner"), tmp_path / "out.svg"
    two = SAMPLES / "two.svg"
    assert "--id" in refused("convert", two, tmp_path / "out.hemesh")
    assert converted(two, tmp_path / "cap.hemesh", "--id", "cap") == (280, 0)
    assert str(FRUIT) in refused("convert", FRUIT, out)
    assert '"gone"' in refused("convert", FRUIT, tmp_path / "out.hemesh", "--id", "gone")
    assert str(tmp_path / "gone" / "out.svg") in refused("convert", leaf, tmp_path / "gone" / "out.svg")
    assert not out.exists()


def test_python(shape, tmp_path):
    leaf, out = shape("corner"), tmp_path / "out.svg"
    patches, told = converted(leaf, out)
    made = gradmesh.convert(gradmesh.load(leaf), "svg")
    assert made.document.to_bytes() == out.read_bytes()
    assert made.patches == patches and made.error == pytest.approx(told, abs=1e-5)
    assert not made.lost_opacity
    assert [mesh.id for mesh in made.document.meshes] == ["mesh"]
    assert gradmesh.convert(gradmesh.load(leaf), "svg", subdivide=2).patches == 12
    with pytest.raises(gradmesh.InputError, match="2 meshes"):
        gradmesh.convert(gradmesh.load(SAMPLES / "two.svg"), "hemesh")
    bubble = gradmesh.convert(gradmesh.load(SAMPLES / "opacity.svg"), "hemesh", "bubble")
    assert bubble.lost_opacity
    (result,) = gradmesh.simplify(bubble.document, method="grid")
    assert result.id == "mesh" and result.patches_after < bubble.patches


@pytest.mark.parametrize(
    "kind, options, words",
    [
        ("png", {"id": "cap"}, "'png'"),
        ("hemesh", {"id": "cap", "subdivide": 0}, "1 to 32"),
        ("hemesh", {"id": "cap", "metric": "taste"}, "'taste'"),
        ("hemesh", {"id": "cap", "resolution": 3}, "resolution"),
    ],
)
def test_python_refuses_what_is_no_conversion(kind, options, words):
    path = SAMPLES / "two.svg"
    document = gradmesh.load(path)
    with pytest.raises(ValueError, match=words) as told:
        gradmesh.convert(document, kind, **options)
    assert not isinstance(told.value, gradmesh.InputError)
    assert document.to_bytes() == path.read_bytes()


@pytest.mark.parametrize(
    "name, words",
    [("two", "there are 2 meshes, choose one with --id"), ("opacity", "has opacities, which .hemesh cannot hold")],
)
def test_what_cannot_become_the_other_kind_is_left(tmp_path, name, words):
    assert words in refused("simplify", SAMPLES / f"{name}.svg", "-o", tmp_path / "out.hemesh")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("model", ["bilinear", "bicubic"])
@pytest.mark.full(all_but=1)
def test_svg_may_be_simplified_to_hemesh(tmp_path, model):
    out = tmp_path / "out.hemesh"
    options = ["--color-model", model] if model == "bicubic" else []
    told = simplified(FRUIT, out, 0.01, *options)
    assert told["patches_after"] == len(elements(out)["faces"]) < 132
    assert 0 < told["error"] <= 0.01
    # The outline may have moved a little, and by that one mesh is laid on the other.
    assert error(FRUIT, out) == pytest.approx(told["error"], abs=0.01)


def test_hemesh_may_be_simplified_to_svg(shape, tmp_path):
    ring, out = shape("ring"), tmp_path / "out.svg"
    told = simplified(ring, out, 0.05)
    assert told["id"] == "mesh" and told["patches_after"] < 128
    assert f"{told['patches_after']} patches" in printed("info", out)
    # What the conversion costs is in it.
    assert told["error"] <= 0.05
    assert error(ring, out) == pytest.approx(told["error"], abs=1e-3)


# --- simplify --original, render --framed-as ---


def error_in_frame_of(original, path):
    """How far the pictures are apart, both painted in the frame of the original."""
    a, b = gradmesh.load(original), gradmesh.load(path)
    return gradmesh.compare(gradmesh.render(a), gradmesh.render(b, framed_as=a))


def simplified(source, out, epsilon, *options):
    """What the report says of the one mesh."""
    (told,) = reported(source, out, "--method", "motorcycle", "--epsilon", epsilon, *options)
    return told


def test_two_runs_against_one_original_keep_one_budget(tmp_path):
    original, first, second = (tmp_path / name for name in ("o.hemesh", "1.hemesh", "2.hemesh"))
    original.write_text(grid(8, 9, surface=Curved()))
    once = simplified(original, first, 0.005)
    again = simplified(first, second, 0.01, "--original", original)
    assert once["original"] is None and again["original"] == str(original)
    assert once["patches_after"] > again["patches_after"]
    assert 0.005 < again["error"] <= 0.01
    assert error_in_frame_of(original, second) == pytest.approx(again["error"], abs=1e-5)
    # Measured against what the first has left, errors add up.
    alone = simplified(first, tmp_path / "alone.hemesh", 0.01)
    assert error_in_frame_of(original, tmp_path / "alone.hemesh") > alone["error"]
    # What is above epsilon already is left as it is, as where it is remembered.
    nothing = simplified(second, tmp_path / "nothing.hemesh", 0.001, "--original", original)
    assert nothing["stopped"] == "nothing to merge" and nothing["error"] > 0.001


def test_an_original_of_the_other_kind_is_laid_on_the_mesh(tmp_path):
    original, svg, out = (tmp_path / name for name in ("o.hemesh", "o.svg", "out.svg"))
    original.write_text(grid(4, 5))
    printed("convert", original, svg, "--subdivide", 4)
    told = simplified(svg, out, 0.04, "--original", original, "--whole-mesh")
    assert told["patches_after"] < told["patches_before"]
    assert error(original, out) == pytest.approx(told["error"], abs=5e-4)


def test_a_given_original_counts_instead_of_what_is_remembered(tmp_path):
    once, again, back = (tmp_path / name for name in ("1.svg", "2.svg", "3.svg"))
    simplified(FRUIT, once, 0.005)
    given = simplified(once, again, 0.01, "--original", once)
    assert error_in_frame_of(once, again) == pytest.approx(given["error"], abs=1e-5)
    # From then on it is remembered: against what was first simplified the error is another one.
    assert simplified(again, back, given["error"])["error"] == pytest.approx(given["error"], abs=1e-6)
    assert abs(simplified(once, again, 0.01)["error"] - given["error"]) > 1e-4
    # An object with a transform, written in other coordinates than those it was read in.
    leaf = SAMPLES / "transformed.svg"
    told = simplified(leaf, once, 0.01)
    same = simplified(once, back, 0.01, "--original", leaf)
    assert same["error"] == pytest.approx(told["error"], abs=1e-4)


def test_originals_are_found_by_their_ids(tmp_path):
    two, out = SAMPLES / "two.svg", tmp_path / "out.svg"
    printed("simplify", two, "-o", out, "--method", "grid", "--original", two)
    said = refused("simplify", two, "-o", tmp_path / "no.svg", "--original", FRUIT)
    assert str(FRUIT) in said and str(two) in said and not (tmp_path / "no.svg").exists()
    assert "cannot be read" in refused("simplify", two, "-o", out, "--original", tmp_path / "gone.svg")
    document = gradmesh.load(out)
    results = gradmesh.simplify(document, original=gradmesh.load(two), method="random", preview=True)
    assert len(results) == 2
    with pytest.raises(gradmesh.InputError, match="stalk|cap"):
        gradmesh.simplify(document, original=gradmesh.load(FRUIT))


@pytest.mark.full
def test_prices_belong_to_the_original(tmp_path):
    once, prices, out = tmp_path / "1.svg", tmp_path / "prices.json", tmp_path / "out.svg"
    simplified(FRUIT, once, 0.005)
    printed("analyze", once, "-o", prices, "--original", once, "--epsilon", 0.01)
    printed("simplify", once, "-o", out, "--original", once, "--load-analysis", prices)
    assert "another mesh" in refused("simplify", once, "-o", out, "--load-analysis", prices)


def test_pictures_before_and_after_can_be_laid_on_each_other(tmp_path):
    original, part, out = tmp_path / "o.hemesh", tmp_path / "part.hemesh", tmp_path / "out.png"
    original.write_text(grid(4, 4))
    part.write_text(grid(4, 4, without=[(i, 3) for i in range(4)]))
    a, b = gradmesh.load(original), gradmesh.load(part)
    whole, framed = gradmesh.render(a), gradmesh.render(b, framed_as=a)
    assert whole.shape == framed.shape != gradmesh.render(b).shape
    painted = (framed < 255).any(axis=2)
    assert painted.mean() > 0.3
    assert np.abs(whole.astype(int) - framed)[painted].max() <= 1
    printed("render", part, "-o", out, "--framed-as", original)
    assert "cannot be read" in refused("render", part, "-o", out, "--framed-as", tmp_path / "gone.svg")
    two = SAMPLES / "two.svg"
    printed("render", two, "-o", out, "--framed-as", two, "--id", "cap", "--like-inkscape")
    assert str(two) in refused("render", FRUIT, "-o", out, "--framed-as", two)


def test_svg_cannot_hold_bicubic_colors(tmp_path):
    out = tmp_path / "out.svg"
    said = refused("simplify", FRUIT, "-o", out, "--color-model", "bicubic")
    assert str(FRUIT) in said and "bicubic" in said and "convert" in said
    assert not out.exists()
    with pytest.raises(gradmesh.InputError, match="bicubic"):
        gradmesh.simplify(gradmesh.load(FRUIT), color_model="bicubic")
    assert "--id" in refused("simplify", SAMPLES / "two.svg", "-o", tmp_path / "out.hemesh")


def test_python_converts_and_then_measures_against_what_was_converted(shape):
    ring = gradmesh.load(shape("ring"))
    options = {"method": "gqe", "resolution": 200}
    converted = gradmesh.convert(ring, "svg", epsilon=0.045, resolution=200)
    (result,) = gradmesh.simplify(converted.document, original=ring, epsilon=0.05, **options)
    # What the conversion costs is in it.
    assert 0.5 * converted.error < result.error <= 0.05 and result.changed
    assert ring.to_bytes() == shape("ring").read_bytes()


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.full(all_but=1)
def test_inkscape_shows_the_same(inkscape, shape, tmp_path, name):
    pictures = pytest.importorskip("pictures", reason="Debian package python3-pil is absent")
    out, png = tmp_path / "out.svg", tmp_path / "ours.png"
    converted(shape(name), out, "--subdivide", 4)
    printed("render", out, "-o", png, "--like-inkscape")
    root = ET.parse(out).getroot()
    width, height = float(root.get("width")), float(root.get("height"))
    # The mesh is 600 pixels wide with 20 around it; our picture has 9 around it.
    area = (11, 11, width - 11, height - 11)
    theirs = inkscape.export_png(out, tmp_path / "theirs.png", dpi=96 * 700 / 618, area=area)
    with pictures.Image.open(png) as picture:
        ours = np.array(picture, int)
    with pictures.Image.open(pictures.on_white(theirs)) as picture:
        shown = np.pad(picture, ((0, 40), (0, 40), (0, 0)), constant_values=255)
    shown = shown[: ours.shape[0], : ours.shape[1]].astype(int)
    # Along the outline Inkscape smooths edges.
    assert (abs(ours - shown).max(axis=2) > 8).mean() < 0.02
    assert (ours < 250).any(axis=2).mean() > 0.5


@of_the_authors
@pytest.mark.parametrize(
    "name, patches, one_piece",
    [
        ("teardrop", 25, True),
        ("global-refinement", 36, True),
        ("apple", 80, False),
        ("global-tulips", 102, False),
        ("L", 3, False),
        ("U", 4, False),
        ("sharp-color-transition", 4, False),
        ("local-refinement", 16, False),
    ],
)
@pytest.mark.full(all_but=1)
def test_the_authors_meshes(tmp_path, name, patches, one_piece):
    mesh, out, back = SHARED / f"{name}.hemesh", tmp_path / "out.svg", tmp_path / "back.hemesh"
    made, told = converted(mesh, out, "--subdivide", 4)
    assert made == 16 * patches and 0 < told < 0.1
    assert error(mesh, out) == pytest.approx(told, abs=1e-3)
    assert ("simplified" not in printed("info", out)) == one_piece
    check_elements(elements(out))
    # In a .hemesh file two colours along one curve share their slopes, and a bar that ends in a
    # colour of its own takes them from its parent.
    inexact = name in ("sharp-color-transition", "local-refinement")
    assert converted(out, back) == (made, pytest.approx(0, abs=0.02 if inexact else 1e-3))


@of_the_authors
@pytest.mark.full
def test_an_authors_mesh_in_fewer_patches_than_evenly_split(tmp_path):
    """The duck has 3,680 patches where each is split into 4 x 4, at FLIP 0.024."""
    duck, out = SHARED / "global_duck.hemesh", tmp_path / "out.svg"
    patches, told = converted(duck, out, "--epsilon", 0.02)
    assert told <= 0.02 and patches <= 900
    assert error(duck, out) == pytest.approx(told, abs=1e-3)
