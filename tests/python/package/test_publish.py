"""Published documents: pictures, colours and linear gradients in the place of mesh gradients."""

import base64
import io
import math
import os
import random
import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest

from bad_documents import RAGGED
from built import SAMPLES, gradmesh as run
from hemesh_files import grid
from lattices import BLUE, DOCUMENT, FILLED, GREEN, MANY, RED, SHAPE, document, gradient, lattice
from sample_meshes import OBJECTS, PAINTED

import gradmesh
import svg_meshes
from meshgrid import colour, mix
from pictures import fit_frame
from svg_meshes import GRADMESH, HREF, LABEL, SVG, all_but, declared

Image = pytest.importorskip("PIL.Image")

TRANSLUCENT = ("opacity", "smooth")  # samples
ONE_COLOUR, LINE, SECOND = [[RED] * 2] * 2, [[RED, BLUE]] * 2, [[BLUE, RED], [GREEN, RED]]
LINEAR = SHAPE.format('style="fill:url(#m)"')
PLACE = ("x", "y", "width", "height")


class Copy:
    """A document after it was published, with what was told of each mesh. Nothing of meshes is left,
    unless something is `left` as it cannot be read; nothing names what is gone, and no id is there twice."""

    def __init__(self, text, left=False, **options):
        document = gradmesh.loads(text)
        self.told = gradmesh.publish(document, **options)
        self.bytes = document.to_bytes()
        self.root = ET.fromstring(self.bytes)
        self.by_id = {e.get("id"): e for e in self.root.iter() if e.get("id")}
        self.images = list(self.root.iter(SVG + "image"))
        self.known = {e.get("id") for e in ET.fromstring(text).iter()}
        assert left or not [e.tag for e in self.root.iter() if "mesh" in str(e.tag)]
        assert b"urn:gradmesh" not in self.bytes
        values = [value for e in self.root.iter() for value in [*e.attrib.values(), e.text or ""]]
        names = {name for value in values for name in re.findall(r"url\(['\"]?#([^)'\"]+)", value)}
        names |= {e.get(HREF)[1:] for e in self.root.iter() if e.get(HREF, "").startswith("#")}
        assert names <= set(self.by_id)
        assert len(self.by_id) == len([e for e in self.root.iter() if e.get("id")])
        for told in self.told:
            assert told.shown_as == "picture" or (told.width, told.height, told.bytes) == (0, 0, 0)

    @property
    def only(self):
        (told,) = self.told
        return told

    @property
    def image(self):
        (image,) = self.images
        return image

    def named(self, element, attribute):
        """The element that url(#...) in an attribute names."""
        return self.by_id[re.fullmatch(r"url\(#(.+)\)", element.get(attribute))[1]]

    @property
    def drawing(self):
        """What is told of the meshes, and all that is drawn, in one line."""
        sizes = {mesh: f" {mesh.width} x {mesh.height}" if mesh.width else "" for mesh in self.told}
        told = ", ".join(f"{mesh.id} {mesh.shown_as}{size}" for mesh, size in sizes.items())
        return f"{told}: " + ", ".join(self._outline(e) for e in self.root if e.get("id") != "defs")

    def _outline(self, element):
        """An element: its tag, its id where that is no new one, the colour of a picture's first pixel,
        its place (of a path the corners of its box), other attributes, with what new ids name, and what
        is in it."""
        name, tag = element.get("id"), element.tag.removeprefix(SVG)
        words = [f"{tag}#{name}" if name and name in self.known else tag]
        if tag == "image":
            words.append("#" + "".join(f"{level:02x}" for level in pixels(element)[0, 0]))
        rest = {key: value for key, value in element.attrib.items() if key not in ("id", "preserveAspectRatio", HREF)}
        if all(side in rest for side in PLACE):
            words += [rest.pop(side) for side in PLACE]
        if "d" in rest:
            numbers = svg_meshes.numbers(rest.pop("d"))
            words += [f"{end(numbers[i::2]):g}" for end in (min, max) for i in (0, 1)]
        for key, value in rest.items():
            found = re.fullmatch(r"url\(#(.+)\)", value)
            if found and found[1] not in self.known:
                (inside,) = self.by_id[found[1]]
                value = f"<{self._outline(inside)}>"
            words.append(f"{key}={value}")
        words += [element.get(HREF)] if tag == "use" else []
        words += [repr(element.text)] if (element.text or "").strip() else []
        inside = ", ".join(map(self._outline, element))
        return " ".join(words) + (f" [{inside}]" if inside else "")


def pixels(image):
    """Those of a picture's file."""
    kind, _, text = image.get(HREF).partition(",")
    assert kind == "data:image/png;base64"
    with Image.open(io.BytesIO(base64.b64decode(text, validate=True))) as picture:
        return np.array(picture, int)


def area(image):
    """Where a picture lies in the user space of its object: x, y, width, height."""
    return [float(image.get(name)) for name in PLACE]


# --- the samples ---


@pytest.fixture(scope="module", params=PAINTED)
def sample(request):
    """The name of a sample, its document, and the published copy."""
    text = (SAMPLES / f"{request.param}.svg").read_text()
    return request.param, ET.fromstring(text), Copy(text)


def test_everything_but_the_painted_objects_stays_as_it_was(sample):
    name, before, after = sample
    gone = {e for mesh in before.iter(SVG + "meshgradient") for e in mesh.iter()}
    stay = {e.get("id") for e in before.iter() if e.get("id") and e not in gone}
    assert gone and len(stay) > 3 and stay <= set(after.by_id)
    known = {e.get("id") for e in before.iter()}

    def is_of_a_mesh(parent, child):
        return child.tag == SVG + "meshgradient" or parent.tag == SVG + "defs" and child.get("id") not in known

    expected, found = (all_but(root, is_of_a_mesh, PAINTED[name]) for root in (before, after.root))
    assert found == expected
    # Something else is there, and the objects themselves.
    assert expected.count(" id=") > 3 and expected.count("place") >= len(PAINTED[name])


def test_what_is_told_is_what_is_there(sample):
    name, _, after = sample
    assert {told.id for told in after.told} == set(PAINTED[name])
    for told in after.told:
        assert (told.shown_as, told.refused) == ("picture", None)
        (image,) = after.by_id[told.id].iter(SVG + "image")
        height, width, channels = pixels(image).shape
        assert (told.width, told.height, channels) == (width, height, 4 if name in TRANSLUCENT else 3)
        assert told.bytes == len(base64.b64decode(image.get(HREF).partition(",")[2]))


@pytest.mark.parametrize("name, painted", [pair for pair in OBJECTS if pair[0] not in TRANSLUCENT])
def test_a_picture_shows_what_the_mesh_shows_there(name, painted):
    """Each pixel of gradmesh's own picture is found in the published one, of about as many pixels."""
    file = SAMPLES / f"{name}.svg"
    source = svg_meshes.Document(file)
    place = source.to_document(source.by_id[painted])
    net = source.net(source.by_id[painted])
    frame = fit_frame([svg_meshes.apply(place, net)], 700)
    expected = gradmesh.render(gradmesh.load(file), painted, 700, like_inkscape=True).astype(int)
    assert expected.shape[:2] == (frame.height, frame.width)
    (image,) = Copy(file.read_text(), scale=2).by_id[painted].iter(SVG + "image")
    found, (x, y, width, height) = pixels(image), area(image)

    scale, _, _, _, left, top = frame.matrix
    page = (np.arange(frame.width) + 0.5 - left) / scale
    page = page + 1j * (np.arange(frame.height)[:, None] + 0.5 - top) / scale
    a, b, c, d, e, f = place
    inverse = np.linalg.inv([[a, c, e], [b, d, f], [0, 0, 1]])
    user = svg_meshes.apply((*inverse[:2, :2].T.ravel(), *inverse[:2, 2]), page)
    column = np.floor((user.real - x) / width * found.shape[1]).astype(int)
    line = np.floor((user.imag - y) / height * found.shape[0]).astype(int)
    inside = (column >= 0) & (line >= 0) & (column < found.shape[1]) & (line < found.shape[0])
    painted_there = inside & (expected < 255).any(axis=2)
    assert painted_there.mean() > 0.2
    levels = np.abs(found[line[painted_there], column[painted_there]] - expected[painted_there]).max(axis=1)
    assert np.median(levels) <= 2 and (levels > 16).mean() <= 0.02


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


# --- simplified meshes ---

SMALL = {"resolution": 200, "epsilon": 0.02}


@pytest.fixture(scope="module")
def simplified():
    """The fruit as a group of blocks, with the hidden original beside it."""
    document = gradmesh.load(SAMPLES / "fruit.svg")
    gradmesh.simplify(document, method="best", keep_original=True, **SMALL)
    assert document.meshes[0].simplified
    return document.to_bytes().decode()


def test_blocks_are_one_picture_which_is_that_of_the_mesh(simplified):
    before = ET.fromstring(simplified)
    blocks = {e.get("id") for e in before.iter() if e.get(GRADMESH + "face")}
    assert len(blocks) > 1 and [e for e in before.iter() if e.get(GRADMESH + "kept-for")]
    after = Copy(simplified)
    assert (after.only.id, after.only.shown_as) == ("pear", "picture")
    pear = after.by_id["pear"]
    assert [e.tag for e in pear] == [SVG + "image"] and list(pear) == after.images
    assert pear.get(LABEL) is None and b"Gradient mesh:" not in after.bytes
    assert not {*blocks, "pear-original"} & set(after.by_id)
    assert {"layer1", "background", "shadow", "stem", "leaf", "title1"} <= set(after.by_id)

    images = Copy((SAMPLES / "fruit.svg").read_text()).image, after.image
    assert area(images[0]) == area(images[1])
    assert 0 < np.abs(pixels(images[0]) - pixels(images[1])).mean() < 8


def test_a_persons_own_label_stays(simplified):
    label = re.search(r'inkscape:label="(Gradient mesh: [^"]*)"', simplified)[0]
    assert simplified.count(label) == 1
    after = Copy(simplified.replace(label, 'inkscape:label="My pear"'))
    assert after.by_id["pear"].get(LABEL) == "My pear"


def test_of_a_mesh_that_stays_one_gradient_goes_what_it_remembers():
    document = gradmesh.load(SAMPLES / "fruit.svg")
    gradmesh.simplify(document, method="plain", keep_original=True, **SMALL)
    assert not document.meshes[0].simplified and b"gradmesh:" in document.to_bytes()
    assert Copy(document.to_bytes().decode()).image is not None


@pytest.mark.parametrize("name", ["opacity", "stroke", "two", "transformed"])
def test_blocks_of_other_samples(name):
    document = gradmesh.load(SAMPLES / f"{name}.svg")
    gradmesh.simplify(document, method="best", **SMALL)
    assert all(mesh.simplified for mesh in document.meshes)
    before = ET.fromstring(document.to_bytes())
    after = Copy(document.to_bytes().decode())
    assert {told.id for told in after.told} == set(PAINTED[name])
    for painted in PAINTED[name]:
        assert len(list(after.by_id[painted].iter(SVG + "image"))) == 1
        assert not list(after.by_id[painted].iter(SVG + "path"))
    # What masked each block's opacity is in the picture.
    masks = [len(list(root.iter(SVG + "mask"))) for root in (before, after.root)]
    assert masks[1] == masks[0] - (name == "opacity")


def test_a_converted_mesh():
    converted = gradmesh.convert(gradmesh.loads(grid(3, 3), "grid.hemesh"), "svg").document
    assert converted.meshes[0].simplified
    after = Copy(converted.to_bytes().decode())
    assert after.only.shown_as == "picture" and len(after.images) == 1


# --- what else paints, and how ---

#: Beside the gradient `m`, of many colours: gradients of one colour, of colours along a line, and of
#: many again, one that has its rows from `m`, and what objects have beside their paint.
DEFS = gradient(ONE_COLOUR, "one") + gradient(LINE, "line") + gradient(SECOND, "n")
DEFS += """<meshgradient id="linked" x="10" y="10" xlink:href="#m" gradientUnits="userSpaceOnUse"/>
<filter id="blur"><feGaussianBlur stdDeviation="1"/></filter>
<clipPath id="clip"><circle cx="30" cy="20" r="9"/></clipPath>
<clipPath id="part"><rect x="20" y="14" width="8" height="8"/></clipPath>
<mask id="mask"><circle cx="30" cy="20" r="9" fill="#fff"/></mask>
<style>.painted { fill: url(#m); opacity: 0.5 }</style>
"""
TAKEN = ["box-picture1", "box-shape2", "box-outline1", "box-gradient1", "box-picture", "box-shape"]

#: Drawings in which nothing but the shape cuts, or the mesh too.
IMAGE = "[image #2b373f 11 11 38 18]"
CUT = "[image #22323f 9 9 42 22 clip-path=<path 10 10 50 30>]"
TEXT = "text x=12 y=28 font-size=18 style=font-size:18"
RECT = "clip-path=<rect 12 12 36 16>"
WHOLE, BOX_IMAGE = "box picture 76 x 36: ", f"g#box {RECT} {IMAGE}"
DOT_IMAGE = "g#dot clip-path=<circle cx=30 cy=20 r=4> [image #646d4c 25 15 10 10]"

#: By what they show: objects, and what becomes of them.
CASES = {
    "a stroke is masked by itself": (
        SHAPE.format('style="fill:none;stroke:url(#m);stroke-width:3;stroke-dasharray:4 2"'),
        "box picture 84 x 44: g#box "
        f"mask=<rect 12 12 36 16 style=fill:none;stroke:#ffffff;stroke-dasharray:4 2;stroke-width:3> {CUT}",
    ),
    "text cuts": (
        '<text id="box" x="12" y="28" font-size="18" fill="url(#m)">ab<tspan id="t">c</tspan></text>',
        f"box picture 84 x 44: g#box clip-path=<{TEXT} 'ab' [tspan#t 'c']> {CUT}",
    ),
    "where letters are is not known, so the outline of a mesh of one colour cuts too": (
        '<text id="box" x="12" y="28" font-size="18" fill="url(#one)">abc</text>',
        f"box picture 84 x 44: g#box clip-path=<{TEXT} 'abc'> {CUT.replace('#22323f', RED)}",
    ),
    "a stroke is above the fill": (
        SHAPE.format('style="fill:url(#m);stroke:url(#n);stroke-width:4"'),
        f"box picture 76 x 36, box picture 84 x 44: g#box [g {RECT} {IMAGE}, "
        f"g mask=<rect 12 12 36 16 style=fill:none;stroke:#ffffff;stroke-width:4> {CUT.replace('#22323f', '#2131ad')}]",
    ),
    "a plain stroke stays a stroke": (
        SHAPE.format('style="fill:url(#m);stroke:#112233;stroke-width:4;paint-order:normal"'),
        f"{WHOLE}g#box [g {RECT} {IMAGE}, rect 12 12 36 16 "
        "style=fill:none;paint-order:normal;stroke:#112233;stroke-width:4]",
    ),
    "a plain stroke below stays there": (
        SHAPE.format('style="fill:url(#m);stroke:#112233;stroke-width:4;paint-order:stroke"'),
        f"{WHOLE}g#box [rect 12 12 36 16 style=fill:none;paint-order:stroke;stroke:#112233;stroke-width:4, "
        f"g {RECT} {IMAGE}]",
    ),
    "of what copies show nothing is known but the shape": (
        f'<defs>{FILLED}</defs><use id="u" xlink:href="#box" x="3"/><use id="v" xlink:href="#box" y="30"/>',
        f"{WHOLE}defs [{BOX_IMAGE}], use#u x=3 #box, use#v y=30 #box",
    ),
    "a symbol": (
        f'<symbol id="s">{FILLED}</symbol><use id="u" xlink:href="#s"/>',
        f"{WHOLE}symbol#s [{BOX_IMAGE}], use#u #s",
    ),
    "a group hands the mesh on": (
        f"""<g id="g" fill="url(#m)">{SHAPE.format("")}<circle id="dot" cx="30" cy="20" r="4"/>
        <path id="plain" d="M 1,1 9,9 1,9" fill="red"/></g>""",
        f"box picture 76 x 36, dot picture 20 x 20: g#g style=fill:none [{BOX_IMAGE}, {DOT_IMAGE}, "
        "path#plain 1 1 9 9 fill=red]",
    ),
    "a group hands one colour on": (
        f'<g id="g" fill="url(#one)">{SHAPE.format("")}</g>',
        f"box colour: g#g style=fill:none [rect#box 12 12 36 16 style=fill:{RED};fill-opacity:1]",
    ),
    "what a style sheet says is said once": (
        SHAPE.format('class="painted"'),
        f"{WHOLE}g#box style=opacity:0.5 {RECT} {IMAGE}",
    ),
    "a transform stays with the object": (
        SHAPE.format('fill="url(#m)" transform="rotate(20 30 20)"'),
        f"{WHOLE}g#box transform=rotate(20 30 20) {RECT} {IMAGE}",
    ),
    "an opacity stays with the object": (
        SHAPE.format('fill="url(#m)" opacity="0.5"'),
        f"{WHOLE}g#box style=opacity:0.5 {RECT} {IMAGE}",
    ),
    "a filter stays with the object": (
        SHAPE.format('fill="url(#m)" filter="url(#blur)"'),
        f"{WHOLE}g#box style=filter:url(#blur) [g {RECT} {IMAGE}]",
    ),
    "another clip path stays with the object": (
        SHAPE.format('fill="url(#m)" clip-path="url(#clip)"'),
        f"box picture 40 x 36: g#box clip-path=url(#clip) [g {RECT} [image #4f5744 20 11 20 18]]",
    ),
    "a mask stays with the object": (
        SHAPE.format('fill="url(#m)" mask="url(#mask)"'),
        f"box picture 40 x 36: g#box mask=url(#mask) [g {RECT} [image #4f5744 20 11 20 18]]",
    ),
    "all of these stay with the object": (
        SHAPE.format(
            'fill="url(#m)" transform="rotate(20 30 20)" opacity="0.5" filter="url(#blur)" '
            'clip-path="url(#clip)" mask="url(#mask)"'
        ),
        "box picture 40 x 36: g#box transform=rotate(20 30 20) clip-path=url(#clip) mask=url(#mask) "
        f"style=filter:url(#blur);opacity:0.5 [g {RECT} [image #4f5744 20 11 20 18]]",
    ),
    "the opacity of a fill is that of the group": (
        SHAPE.format('style="fill:url(#m);fill-opacity:0.5;opacity:0.5"'),
        f"{WHOLE}g#box style=opacity:0.25 {RECT} {IMAGE}",
    ),
    "a title stays": (
        '<rect id="box" width="40" height="30" fill="url(#m)"><title id="t">A box</title></rect>',
        "box picture 64 x 44: g#box clip-path=<rect width=40 height=30> [title#t 'A box', "
        "image #22323f 9 9 32 22 clip-path=<path 10 10 50 30>]",
    ),
    "an object without an id gets one": (
        '<rect width="40" height="30" fill="url(#m)"/>',
        "rect1 picture 64 x 44: g clip-path=<rect width=40 height=30> "
        "[image #22323f 9 9 32 22 clip-path=<path 10 10 50 30>]",
    ),
    "one mesh on two objects": (
        FILLED + '<circle id="dot" cx="30" cy="20" r="4" fill="url(#m)"/>',
        f"box picture 76 x 36, dot picture 20 x 20: {BOX_IMAGE}, {DOT_IMAGE}",
    ),
    "rows from another gradient": (SHAPE.format('fill="url(#linked)"'), WHOLE + BOX_IMAGE),
    "what names a mesh and is not seen gets the colour for programs without meshes": (
        f"""{FILLED}<g id="group" fill="url(#n) #abcdef"><rect id="inner" x="1" fill="red"/></g>
        <g id="empty" style="stroke:url(#n)"/>""",
        f"{WHOLE}{BOX_IMAGE}, g#group style=fill:#abcdef [rect#inner x=1 fill=red], g#empty style=stroke:none",
    ),
    "scripts of Inkscape that paint meshes go and others stay": (
        f"""{FILLED}<script id="mesh_polyfill">1</script><script id="mesh_polyfill2">2</script>
        <script id="mine">3</script>""",
        f"{WHOLE}{BOX_IMAGE}, script#mine '3'",
    ),
    "ids that are taken stay": (
        FILLED + "".join(f'<rect id="{name}"/>' for name in TAKEN),
        WHOLE + ", ".join([BOX_IMAGE, *(f"rect#{name}" for name in TAKEN)]),
    ),
    "what is clipped away is not in the picture": (
        f'<g id="g" clip-path="url(#part)">{FILLED}</g>',
        f"box picture 20 x 20: g#g clip-path=url(#part) [g#box {RECT} [image #505744 19 13 10 10]]",
    ),
}
for name, first, corner in (("one", RED, RED), ("line", "#bb2015", "#bf2011"), ("m", "#2b373f", "#22323f")):
    # Where the mesh is not Inkscape shows nothing: so its outline cuts.
    CASES[f"a shape that reaches beyond the mesh {name}"] = (
        f'<rect id="box" x="12" y="12" width="60" height="16" fill="url(#{name})"/>',
        "box picture 80 x 36: g#box clip-path=<rect 12 12 60 16> "
        f"[image {first} 11 11 40 18 clip-path=<path 10 10 50 30>]",
    )
    for x, y in ((70, 50), (20, 32), (51.5, 12)):
        CASES[f"a shape at {x}, {y} beside the mesh {name} shows nothing"] = (
            f'<rect id="box" x="{x}" y="{y}" width="9" height="9" fill="url(#{name})"/>',
            f"box picture 4 x 4: g#box clip-path=<rect {x} {y} 9 9> "
            f"[image {corner} 9 9 2 2 clip-path=<path 10 10 50 30>]",
        )


@pytest.mark.parametrize("name", CASES)
def test_what_else_paints_and_how(name):
    body, drawing = CASES[name]
    assert Copy(document(MANY, body, DEFS)).drawing == drawing


# --- refusals ---

BAD = '<rect id="bad" x="12" y="12" width="36" height="16" fill="url(#n)"/>'


def test_a_mesh_that_cannot_be_read_stays_beside_others():
    text = document(MANY, FILLED + BAD, RAGGED)
    after = Copy(text, left=True)
    good, bad = sorted(after.told, key=lambda told: told.id == "bad")
    assert (good.id, good.shown_as, good.refused) == ("box", "picture", None)
    assert (bad.id, bad.shown_as) == ("bad", "nothing")
    assert isinstance(bad.refused, gradmesh.InputError) and 'meshgradient "n"' in str(bad.refused)
    before = {e.get("id"): e for e in ET.fromstring(text).iter()}
    for name in ("bad", "n"):
        assert ET.tostring(after.by_id[name]).strip() == ET.tostring(before[name]).strip()
    assert "m" not in after.by_id


@pytest.mark.parametrize(
    "text, words",
    [
        (DOCUMENT.format(defs=RAGGED, body=BAD), ['meshgradient "n"']),
        (DOCUMENT.format(defs="", body=SHAPE.format('fill="red"')), ["no object"]),
        (grid(2, 2), ["grid.hemesh", "only SVG documents", "gradmesh convert"]),
        *((document(MANY), scale) for scale in (0, -1, 17, 16.01, math.nan, math.inf)),
    ],
)
def test_what_is_refused_stays_as_it_was(text, words):
    document = gradmesh.loads(text, "grid.hemesh" if text.startswith("HEMESH") else "document")
    before, is_a_scale = document.to_bytes(), not isinstance(words, list)
    with pytest.raises(ValueError if is_a_scale else gradmesh.InputError) as raised:
        gradmesh.publish(document, **{"scale": words} if is_a_scale else {})
    sentence = str(raised.value)
    assert all(word in sentence for word in (["scale"] if is_a_scale else words)), sentence
    assert sentence.endswith(".") and "\n" not in sentence
    assert document.to_bytes() == before


# --- the same again ---


@pytest.mark.parametrize("name", ["fruit", "two"])
def test_the_same_bytes_in_every_run_and_on_any_number_of_cores(tmp_path, name):
    source, file = SAMPLES / f"{name}.svg", tmp_path / "copy.svg"
    expected = Copy(source.read_text()).bytes
    assert Copy(source.read_text()).bytes == expected

    def on_one_core():
        os.sched_setaffinity(0, [min(os.sched_getaffinity(0))])

    assert run("publish", source, "-o", file, preexec_fn=on_one_core).returncode == 0
    assert file.read_bytes() == expected


def test_a_published_document_is_saved_and_read_again(tmp_path):
    document = gradmesh.load(SAMPLES / "two.svg")
    gradmesh.publish(document)
    for name in ("copy.svg", "copy.svgz"):
        gradmesh.save(document, tmp_path / name)
        assert gradmesh.load(tmp_path / name).to_bytes() == document.to_bytes()
    with pytest.raises(gradmesh.InputError, match="no object"):
        gradmesh.publish(document)
