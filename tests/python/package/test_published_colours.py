"""Which colours and gradients published documents have in the place of a mesh, and which pictures."""

import math
import random
import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest

from built import SAMPLES, gradmesh as run
from lattices import BLUE, FILLED, GREEN, MANY, RED, SHAPE, document, lattice
from published_copy import Copy, area, pixels

import svg_meshes
from meshgrid import colour, mix
from svg_meshes import SVG, declared

LINEAR = SHAPE.format('style="fill:url(#m)"')

pytestmark = pytest.mark.module_only


# --- colours and linear gradients ---


@pytest.mark.parametrize("opacity", [1, 0.5])
@pytest.mark.parametrize("own", ["", "fill-opacity:0.5;"])
def test_one_colour_is_a_colour_on_the_same_element(opacity, own):
    body = SHAPE.format(f'rx="2" class="a" style="opacity:0.75;fill:url(#m);{own}stroke:none"')
    after = Copy(document([[(RED, opacity)] * 3] * 2, body))
    assert (after.only.id, after.only.shown_as, after.images) == ("box", "colour", [])
    box, was = after.by_id["box"], ET.fromstring(body).attrib
    assert box.tag == SVG + "rect" and {**box.attrib, "style": ""} == {**was, "style": ""}
    style = declared(box)
    expected = round(255 * opacity) / 255 * (0.5 if own else 1)
    assert float(style.pop("fill-opacity", 1)) == pytest.approx(expected, abs=0.003)
    assert style == {"opacity": "0.75", "fill": RED, "stroke": "none"}


def shown_linear(after):
    """The linear gradient of the box: its start, its way, and its stops as (offset, colour)."""
    assert after.only.shown_as == "linear gradient" and not after.images
    box = after.by_id["box"]
    found = after.by_id[re.fullmatch(r"url\(#(.+)\)", declared(box)["fill"])[1]]
    assert box.tag == SVG + "rect"
    assert found.tag == SVG + "linearGradient" and found.get("gradientUnits") == "userSpaceOnUse"
    x1, y1, x2, y2 = (float(found.get(name)) for name in ("x1", "y1", "x2", "y2"))
    stops = [(float(stop.get("offset")), declared(stop)["stop-color"]) for stop in found]
    assert all(float(declared(stop)["stop-opacity"]) == 1 for stop in found)
    return complex(x1, y1), complex(x2 - x1, y2 - y1), stops


def share(point, start, way):
    """Where a point is along a linear gradient, from 0 to 1."""
    return ((point - start) * way.conjugate()).real / abs(way) ** 2


@pytest.mark.parametrize("turn", [1, 0.96 + 0.28j, -1j])
@pytest.mark.parametrize("lines", ["rows", "columns"])
def test_colours_along_one_line_are_a_linear_gradient(lines, turn):
    colours = [RED, GREEN, BLUE, GREEN, RED]
    colours = [colours] * 3 if lines == "rows" else [[c] * 3 for c in colours]
    mesh = lattice(colours, (-20, -10, 40, 20), turn)
    look = 'style="fill:url(#m)" transform="translate(40 40)"'
    after = Copy(document(mesh, f'<rect id="box" x="-4" y="-4" width="8" height="8" {look}/>'))
    start, way, stops = shown_linear(after)
    assert stops == [(0, RED), (0.25, GREEN), (0.5, BLUE), (0.75, GREEN), (1, RED)]
    # The colours of the corners are where the corners are.
    for i in range(mesh.rows + 1):
        for j in range(mesh.columns + 1):
            expected = (j if lines == "rows" else i) / 4
            assert share(mesh.corner(i, j), start, way) == pytest.approx(expected, abs=1e-4)
    assert declared(after.by_id["box"])["fill-opacity"] == "1"


def test_a_sheared_mesh_is_a_linear_gradient_across_its_lines():
    mesh = lattice([[RED, GREEN, BLUE]] * 2)
    mesh.points = [[p + 0.5 * (p.imag - 20) for p in line] for line in mesh.points]
    body = LINEAR.replace('x="12"', 'x="17"').replace('"36"', '"26"')
    start, way, stops = shown_linear(Copy(document(mesh, body)))
    assert [c for _, c in stops] == [RED, GREEN, BLUE]
    assert way.real == pytest.approx(-2 * way.imag, abs=1e-3)
    for line in mesh.points[::3]:
        assert [share(p, start, way) for p in line[::3]] == pytest.approx([0, 0.5, 1], abs=1e-4)


@pytest.mark.parametrize("width", [0.4, 0])
def test_a_narrow_column_is_two_near_stops_and_one_without_width_a_sharp_edge(width):
    mesh = lattice([[RED, GREEN, BLUE, RED]] * 2)
    ends = 10, 30 - width / 2, 30 + width / 2, 50
    for line in mesh.points:
        for k in range(10):
            a, b = ends[min(k // 3, 2)], ends[min(k // 3, 2) + 1]
            line[k] = complex(mix(a, b, k / 3 - min(k // 3, 2)), line[k].imag)
    after = Copy(document(mesh, LINEAR))
    if width:
        _, _, stops = shown_linear(after)
        assert [c for _, c in stops] == [RED, GREEN, BLUE, RED]
        assert [place for place, _ in stops] == pytest.approx([0, 0.495, 0.505, 1], abs=1e-4)
        return
    x, _, width, _ = area(after.image)
    shown = pixels(after.image)
    edge = round((30 - x) * shown.shape[1] / width)
    middle = shown[shown.shape[0] // 2]
    for column, expected in ((edge - 2, GREEN), (edge + 1, BLUE)):
        assert abs(middle[column] - 255 * np.array(colour(expected)[:3])).max() <= 16


def test_one_opacity_of_all_is_that_of_the_fill():
    colours = [[(RED, 0.6), (GREEN, 0.6)]] * 2
    after = Copy(document(colours, SHAPE.format('style="fill:url(#m);fill-opacity:0.5"')))
    _, _, stops = shown_linear(after)
    assert stops == [(0, RED), (1, GREEN)]
    assert float(declared(after.by_id["box"])["fill-opacity"]) == pytest.approx(0.3, abs=0.002)


def with_moved(mesh, lines, column, by):
    for line in mesh.points[lines]:
        line[column] += by
    return mesh


NOT_LINEAR = {
    "curved line": (with_moved(lattice([[RED, GREEN, BLUE]] * 2), slice(1, 3), 3, 2), ""),
    "uneven": (with_moved(lattice([[RED, GREEN, BLUE]] * 2), slice(None), 1, 3), ""),
    "smooth": ([[RED, GREEN, BLUE]] * 2, 'type="bicubic"'),
    "colours along a line": ([[RED, GREEN, BLUE], [RED, BLUE, BLUE]], ""),
    "opacities": ([[RED, (RED, 0.5), RED]] * 2, ""),
    "opacities of colours": ([[RED, (GREEN, 0.5), BLUE]] * 2, ""),
    "both directions": (MANY, ""),
}


@pytest.mark.parametrize("case", NOT_LINEAR)
def test_other_colours_are_a_picture(case):
    """The shape lies inside the mesh, so nothing but the shape cuts."""
    mesh, more = NOT_LINEAR[case]
    after = Copy(document(mesh, more=more))
    picture = r"g#box clip-path=<rect 12 12 36 16> \[image #\w+ 11 11 38 18\]"
    assert re.fullmatch("box picture 76 x 36: " + picture, after.drawing)
    assert not list(after.root.iter(SVG + "linearGradient"))


def test_an_outline_is_where_the_gradient_is():
    """With a transform of the gradient's own, which the outline has too."""
    body = '<rect id="box" width="99" height="79" fill="url(#m)"/>'
    after = Copy(document(MANY, body, more='gradientTransform="matrix(0.8 0.1 0 1.5 3 -4)"'))
    (outline,) = after.named(after.image, "clip-path")
    matrix = svg_meshes.parse_transform(outline.get("transform"))
    points = svg_meshes.numbers(outline.get("d"))
    found = svg_meshes.apply(matrix, np.array(points[::2]) + 1j * np.array(points[1::2]))
    for corner in (10 + 10j, 50 + 10j, 50 + 30j, 10 + 30j):
        expected = complex(0.8 * corner.real + 3, 0.1 * corner.real + 1.5 * corner.imag - 4)
        assert np.abs(found - expected).min() < 1e-6


# --- how large pictures are ---


def expect_around(image, box, most):
    """The picture covers a box and ends not more than `most` beside it."""
    x, y, width, height = area(image)
    beside = box[0] - x, box[1] - y, x + width - box[0] - box[2], y + height - box[1] - box[3]
    assert min(beside) >= 0 and max(beside) <= most, beside


def test_a_small_shape_in_a_large_mesh_has_a_small_picture():
    mesh = lattice(MANY, (-300, -300, 700, 700))
    after = Copy(document(mesh, '<circle id="box" cx="50" cy="40.3" r="5" fill="url(#m)"/>'))
    expect_around(after.image, (45, 35.3, 10, 10), 2)
    assert after.only.width <= 28 and after.only.height <= 28


def test_gradients_in_the_box_of_the_object():
    text = (SAMPLES / "ellipse.svg").read_text()
    assert 'gradientUnits="objectBoundingBox"' in text.partition("<meshgradient")[2].partition(">")[0]
    expect_around(Copy(text).image, (80, 72, 400, 376), 2)


@pytest.mark.parametrize("scale", [0.4, 1, 2, 3.7, 7])
def test_the_scale_is_pixels_for_each_of_the_document(scale):
    after = Copy(document(MANY), scale=scale)
    width, height = area(after.image)[2:]
    assert (after.only.width, after.only.height) == pytest.approx((width * scale, height * scale), abs=0.01)
    expect_around(after.image, (12, 12, 36, 16), 1 + math.ceil(2 / scale) + 1 / scale)


@pytest.mark.parametrize(
    "size, transform, pixel",
    [
        ('viewBox="0 0 50 40"', "", 2),
        ('viewBox="0 0 200 160"', "", 0.5),
        ('viewBox="0 0 200 40"', "", 0.5),
        ('viewBox="0 0 100 40" preserveAspectRatio="xMidYMax slice"', "", 2),
        ("", "scale(3)", 3),
        ("", "rotate(30)", 1),
        ("", "translate(0.25 0.5)", 1),
        ("", "matrix(0 2 -2 0 90 0)", 2),
        ('viewBox="0 0 50 40"', "scale(-3 3) translate(-50 0)", 6),
    ],
)
def test_pixels_are_those_that_the_document_has_when_it_is_shown(size, transform, pixel):
    """However many units of the object's user space these are."""
    text = document(MANY, f'<g transform="{transform}">{FILLED}</g>')
    after = Copy(text.replace('height="80">', f'height="80" {size}>', 1))
    width, height = area(after.image)[2:]
    expected = 2 * pixel * width, 2 * pixel * height
    assert (after.only.width, after.only.height) == pytest.approx(expected, abs=0.01)
    expect_around(after.image, (12, 12, 36, 16), 2 / pixel + 1e-6)


def test_the_limit_on_resolution_bounds_a_picture(tmp_path):
    limits, file = {"GRADMESH_LIMITS": "resolution=100"}, tmp_path / "copy.svg"
    told = run("publish", SAMPLES / "fruit.svg", "-o", file, "--scale", 16, env=limits).stdout
    (image,) = ET.parse(file).iter(SVG + "image")
    shown = pixels(image)
    assert 95 <= max(shown.shape[:2]) <= 100
    assert told.startswith(f"pear: picture, {shown.shape[1]} x {shown.shape[0]} pixels, ")
    # It lies where it did, but for a pixel.
    x, y, width, height = area(image)
    pixel = height / shown.shape[0]
    assert width / shown.shape[1] == pytest.approx(pixel)
    expect_around(image, (96, 116, 288, 400), 2 * pixel + 2)


# --- the pixels ---


def expected_pixels(image, mesh, box):
    """What the bilinear formula says for the middle of each pixel, and whether the mesh is there."""
    x, y, width, height = area(image)
    shape = pixels(image).shape
    u = (x + (np.arange(shape[1]) + 0.5) * width / shape[1] - box[0]) / box[2]
    v = (y + (np.arange(shape[0]) + 0.5) * height / shape[0] - box[1]) / box[3]
    inside = ((u > 0) & (u < 1))[None, :] & ((v > 0) & (v < 1))[:, None]
    u, v = u[None, :, None], v[:, None, None]
    (a, b), (c, d) = np.array(mesh.colours)
    return 255 * ((1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * c + u * d)), inside


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("translucent", [False, True])
@pytest.mark.full(all_but=1)
def test_a_patch_has_its_colours_and_opacities(translucent, seed):
    """Within a level: Inkscape rounds down, and takes another point of a pixel than the middle."""
    chance = random.Random(seed)
    box = (5, 5, chance.uniform(60, 90), chance.uniform(50, 70))
    base = [chance.randint(0, 195) for _ in range(4)]

    def corner():
        levels = [level + chance.randint(0, 60) for level in base]
        text = "#" + "".join(f"{level:02x}" for level in levels[:3])
        return (text, round(levels[3] / 255, 3)) if translucent else text

    mesh = lattice([[corner(), corner()], [corner(), corner()]], box)
    body = f'<rect id="box" x="5" y="5" width="{box[2]}" height="{box[3]}" fill="url(#m)"/>'
    after = Copy(document(mesh, body), scale=4)
    found = pixels(after.image)
    assert found.shape[2] == (4 if translucent else 3)
    expected, inside = expected_pixels(after.image, mesh, box)
    levels = np.abs(found - expected[:, :, : found.shape[2]]).max(axis=2)
    # A colour is first rounded to eight bits.
    assert inside.mean() > 0.8 and levels[inside].max() <= 1.6
    # Around the mesh its colours go on: no edge shows where a picture is scaled.
    assert levels.max() <= 4
