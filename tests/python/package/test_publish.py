"""Published documents: pictures, colours and linear gradients in the place of mesh gradients."""

import base64
import copy
import io
import math
import os
import random
import re
import subprocess
import sys
import xml.etree.ElementTree as ET

import numpy as np
import pytest

from bad_documents import BELOW, FIRST, NEXT, row
from built import PACKAGES, SAMPLES
from hemesh_files import grid
from sample_meshes import OBJECTS, PAINTED

import gradmesh
import random_meshes  # noqa: F401, which knows where meshgrid is
import svg_meshes
from meshgrid import Mesh, colour, meshgradient, mix
from pictures import fit_frame
from svg_meshes import GRADMESH, HREF, SVG

Image = pytest.importorskip("PIL.Image")

LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
TRANSLUCENT = ("opacity", "smooth")  # samples
BOX = (10, 10, 40, 20)  # where meshes here lie: x, y, width, height
DOCUMENT = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
  xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" width="100" height="80">
<defs id="defs">{defs}</defs>
{body}
</svg>
"""
SHAPE = '<rect id="box" x="12" y="12" width="36" height="16" {}/>'
FILLED = SHAPE.format('fill="url(#m)"')
#: Four colours that no line has in common, so that only a picture shows them.
MANY = [["#203040", "#d0c050"], ["#806020", "#40b0c0"]]
RED, GREEN, BLUE = "#c02010", "#10a030", "#2030b0"


def lattice(colours, box=BOX, turn=1):
    """A mesh of equal rectangles, turned about 0, with these colours at its corners: texts, or pairs
    of a text and an opacity."""
    x, y, width, height = box
    rows, columns = len(colours) - 1, len(colours[0]) - 1
    corners = [
        [turn * complex(x + width * j / columns, y + height * i / rows) for j in range(columns + 1)]
        for i in range(rows + 1)
    ]
    return Mesh(corners, [[colour(*([c] if isinstance(c, str) else c)) for c in line] for line in colours])


def gradient(mesh, name="m", more=""):
    return meshgradient(mesh, name, f'gradientUnits="userSpaceOnUse" {more}')


def document(mesh, body=FILLED, defs=""):
    """A document whose gradient `m` is this mesh, or a lattice of these colours."""
    mesh = mesh if isinstance(mesh, Mesh) else lattice(mesh)
    return DOCUMENT.format(defs=gradient(mesh) + defs, body=body)


class Copy:
    """A document after it was published, with what was told of each mesh."""

    def __init__(self, text, **options):
        document = gradmesh.loads(text)
        self.told = gradmesh.publish(document, **options)
        self.bytes = document.to_bytes()
        self.root = ET.fromstring(self.bytes)
        self.by_id = {e.get("id"): e for e in self.root.iter() if e.get("id")}
        self.images = list(self.root.iter(SVG + "image"))

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


def style(element):
    """What the style of an element declares."""
    return dict(part.split(":", 1) for part in element.get("style", "").split(";") if part)


def file_of(image):
    """The bytes of a picture's file."""
    kind, _, text = image.get(HREF).partition(",")
    assert kind == "data:image/png;base64"
    return base64.b64decode(text, validate=True)


def pixels(image):
    with Image.open(io.BytesIO(file_of(image))) as picture:
        return np.array(picture, int)


def area(image):
    """Where a picture lies in the user space of its object: x, y, width, height."""
    return [float(image.get(name)) for name in ("x", "y", "width", "height")]


def expect_no_meshes(copy):
    """Nothing of meshes is left, nothing names what is gone, and no id is there twice."""
    assert not [e.tag for e in copy.root.iter() if "mesh" in str(e.tag)]
    assert b"urn:gradmesh" not in copy.bytes
    values = [value for e in copy.root.iter() for value in [*e.attrib.values(), e.text or ""]]
    names = {name for value in values for name in re.findall(r"url\(['\"]?#([^)'\"]+)", value)}
    names |= {e.get(HREF)[1:] for e in copy.root.iter() if e.get(HREF, "").startswith("#")}
    assert names <= set(copy.by_id)
    assert len(copy.by_id) == len([e for e in copy.root.iter() if e.get("id")])


# --- the samples ---


@pytest.fixture(scope="module", params=PAINTED)
def sample(request):
    """The name of a sample, its document, and the published copy."""
    text = (SAMPLES / f"{request.param}.svg").read_text()
    return request.param, ET.fromstring(text), Copy(text)


def test_nothing_of_meshes_is_left(sample):
    _, before, after = sample
    assert [e for e in before.iter() if "mesh" in e.tag]
    expect_no_meshes(after)


def without(root, painted, known):
    """The document with the painted objects as empty places, without mesh gradients and without
    elements in definitions that are not `known`, as a text that is the same for equal documents."""
    root = copy.deepcopy(root)
    for parent in list(root.iter()):
        for child in list(parent):
            in_defs = parent.tag == SVG + "defs"
            if child.tag == SVG + "meshgradient" or in_defs and child.get("id") not in known:
                parent.remove(child)
            elif child.get("id") in painted:
                place = ET.Element("place", id=child.get("id"))
                place.tail = child.tail
                parent[list(parent).index(child)] = place
    return ET.canonicalize(ET.tostring(root), strip_text=True, rewrite_prefixes=True)


def test_everything_else_stays_as_it_was(sample):
    name, before, after = sample
    known = {e.get("id") for e in before.iter()}
    expected = without(before, PAINTED[name], known)
    assert without(after.root, PAINTED[name], known) == expected
    # Something else is there, and the objects themselves.
    assert expected.count(" id=") > 3 and expected.count("place") >= len(PAINTED[name])


def test_ids_stay(sample):
    _, before, after = sample
    gone = {e for mesh in before.iter(SVG + "meshgradient") for e in mesh.iter()}
    stay = {e.get("id") for e in before.iter() if e.get("id") and e not in gone}
    assert len(stay) > 3 and stay <= set(after.by_id)


def test_what_is_told_is_what_is_there(sample):
    name, _, after = sample
    assert {told.id for told in after.told} == set(PAINTED[name])
    for told in after.told:
        assert (told.shown_as, told.refused) == ("picture", None)
        (image,) = after.by_id[told.id].iter(SVG + "image")
        file = file_of(image)
        with Image.open(io.BytesIO(file)) as picture:
            assert (*picture.size, len(file)) == (told.width, told.height, told.bytes)
            assert picture.mode == ("RGBA" if name in TRANSLUCENT else "RGB")
            picture.load()


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
    told = after.only
    assert (told.id, told.shown_as, told.width, told.height, told.bytes) == ("box", "colour", 0, 0, 0)
    assert not after.images
    box = after.by_id["box"]
    was = ET.fromstring(body).attrib
    assert box.tag == SVG + "rect" and {**box.attrib, "style": ""} == {**was, "style": ""}
    declared = style(box)
    expected = round(255 * opacity) / 255 * (0.5 if own else 1)
    assert float(declared.pop("fill-opacity", 1)) == pytest.approx(expected, abs=0.003)
    assert declared == {"opacity": "0.75", "fill": RED, "stroke": "none"}
    expect_no_meshes(after)


def shown_linear(after, shape="box"):
    """The linear gradient of a shape: its start, its way, and its stops as (offset, colour)."""
    assert after.only.shown_as == "linear gradient" and not after.images
    assert (after.only.width, after.only.height, after.only.bytes) == (0, 0, 0)
    assert after.by_id[shape].tag == SVG + "rect"
    found = after.by_id[re.fullmatch(r"url\(#(.+)\)", style(after.by_id[shape])["fill"])[1]]
    assert found.tag == SVG + "linearGradient" and found.get("gradientUnits") == "userSpaceOnUse"
    x1, y1, x2, y2 = (float(found.get(name)) for name in ("x1", "y1", "x2", "y2"))
    stops = [(float(stop.get("offset")), style(stop)["stop-color"]) for stop in found]
    assert all(float(style(stop)["stop-opacity"]) == 1 for stop in found)
    expect_no_meshes(after)
    return complex(x1, y1), complex(x2 - x1, y2 - y1), stops


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
            place = ((mesh.corner(i, j) - start) * way.conjugate()).real / abs(way) ** 2
            assert place == pytest.approx((j if lines == "rows" else i) / 4, abs=1e-4)
    assert style(after.by_id["box"])["fill-opacity"] == "1"


def test_a_sheared_mesh_is_a_linear_gradient_across_its_lines():
    mesh = lattice([[RED, GREEN, BLUE]] * 2)
    mesh.points = [[p + 0.5 * (p.imag - 20) for p in line] for line in mesh.points]
    body = SHAPE.format('style="fill:url(#m)"').replace('x="12"', 'x="17"').replace('"36"', '"26"')
    start, way, stops = shown_linear(Copy(document(mesh, body)))
    assert [c for _, c in stops] == [RED, GREEN, BLUE]
    assert way.real == pytest.approx(-2 * way.imag, abs=1e-3)
    for line in mesh.points[::3]:
        places = [((p - start) * way.conjugate()).real / abs(way) ** 2 for p in line[::3]]
        assert places == pytest.approx([0, 0.5, 1], abs=1e-4)


def narrow(width):
    """Red to green, and blue to red, with so wide a column of patches between."""
    mesh = lattice([[RED, GREEN, BLUE, RED]] * 2)
    ends = 10, 30 - width / 2, 30 + width / 2, 50
    for line in mesh.points:
        for k in range(10):
            a, b = ends[min(k // 3, 2)], ends[min(k // 3, 2) + 1]
            line[k] = complex(mix(a, b, k / 3 - min(k // 3, 2)), line[k].imag)
    return mesh


def test_a_narrow_column_is_two_near_stops():
    _, _, stops = shown_linear(Copy(document(narrow(0.4), SHAPE.format('style="fill:url(#m)"'))))
    assert [c for _, c in stops] == [RED, GREEN, BLUE, RED]
    assert [place for place, _ in stops] == pytest.approx([0, 0.495, 0.505, 1], abs=1e-4)


def test_a_column_without_width_is_a_sharp_edge():
    after = Copy(document(narrow(0), SHAPE.format('style="fill:url(#m)"')))
    if after.only.shown_as == "linear gradient":
        _, _, stops = shown_linear(after)
        assert stops == [(0, RED), (0.5, GREEN), (0.5, BLUE), (1, RED)]
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
    assert float(style(after.by_id["box"])["fill-opacity"]) == pytest.approx(0.3, abs=0.002)


def curved(mesh):
    for line in mesh.points[1:3]:
        line[3] += 2


def uneven(mesh):
    """Colours that do not change evenly on the way."""
    for line in mesh.points:
        line[1] += 3


def smooth(mesh):
    return 'type="bicubic"'


NOT_LINEAR = {
    "curved line": ([[RED, GREEN, BLUE]] * 2, curved),
    "uneven": ([[RED, GREEN, BLUE]] * 2, uneven),
    "smooth": ([[RED, GREEN, BLUE]] * 2, smooth),
    "colours along a line": ([[RED, GREEN, BLUE], [RED, BLUE, BLUE]], None),
    "opacities": ([[RED, (RED, 0.5), RED]] * 2, None),
    "opacities of colours": ([[RED, (GREEN, 0.5), BLUE]] * 2, None),
    "both directions": (MANY, None),
}


@pytest.mark.parametrize("case", NOT_LINEAR)
def test_other_colours_are_a_picture(case):
    colours, change = NOT_LINEAR[case]
    mesh = lattice(colours)
    more = change(mesh) if change else None
    after = Copy(DOCUMENT.format(defs=gradient(mesh, more=more or ""), body=FILLED))
    assert after.only.shown_as == "picture"
    assert not list(after.root.iter(SVG + "linearGradient"))
    # The shape lies inside the mesh, so nothing but the shape cuts.
    assert after.image.get("clip-path") is None
    group = after.by_id["box"]
    assert group.tag == SVG + "g" and after.image in list(group)
    (path,) = after.named(group, "clip-path")
    assert path.tag == SVG + "rect" and path.get("width") == "36" and path.get("id") is None
    expect_no_meshes(after)


@pytest.mark.parametrize("colours", [[[RED] * 2] * 2, [[RED, BLUE]] * 2, MANY])
def test_a_shape_that_reaches_beyond_the_mesh(colours):
    """There Inkscape shows nothing: so the outline of the mesh cuts."""
    body = FILLED.replace('width="36"', 'width="60"')
    after = Copy(document(colours, body))
    assert after.only.shown_as == "picture"
    (outline,) = after.named(after.image, "clip-path")
    x, y, width, height = BOX
    points = svg_meshes.numbers(outline.get("d"))
    assert (min(points[::2]), max(points[::2])) == (x, x + width)
    assert (min(points[1::2]), max(points[1::2])) == (y, y + height)
    expect_no_meshes(after)


def test_an_outline_is_where_the_gradient_is():
    """With a transform of the gradient's own, which the outline has too."""
    defs = gradient(lattice(MANY), more='gradientTransform="matrix(0.8 0.1 0 1.5 3 -4)"')
    after = Copy(DOCUMENT.format(defs=defs, body='<rect id="box" width="99" height="79" fill="url(#m)"/>'))
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


def test_what_is_clipped_away_is_not_in_the_picture():
    clip = '<clipPath id="c"><rect x="20" y="14" width="8" height="8"/></clipPath>'
    body = f'<g id="g" clip-path="url(#c)">{FILLED}</g>'
    after = Copy(document(MANY, body, clip))
    expect_around(after.image, (20, 14, 8, 8), 2)
    assert after.by_id["g"].get("clip-path") == "url(#c)"


@pytest.mark.parametrize("colours", [[[RED] * 2] * 2, [[RED, BLUE]] * 2, MANY])
@pytest.mark.parametrize("place", ['x="70" y="50"', 'x="20" y="32"', 'x="51.5" y="12"'])
def test_a_shape_beside_the_mesh_shows_nothing(colours, place):
    """In Inkscape it does not either."""
    after = Copy(document(colours, f'<rect id="box" {place} width="9" height="9" fill="url(#m)"/>'))
    expect_no_meshes(after)
    box = after.by_id["box"]
    assert style(box).get("fill", box.get("fill", "none")) == "none"
    for image in after.images:
        # As good as none of it lies in the shape, or the outline of the mesh cuts it off.
        x, y, width, height = area(image)
        left, top = svg_meshes.numbers(place)
        beside = min(x + width - left, y + height - top) <= 0 or left + 9 <= x or top + 9 <= y
        assert beside or image.get("clip-path")
        assert after.only.width * after.only.height < 100


@pytest.mark.parametrize("scale", [0.4, 1, 2, 3.7, 16])
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


def in_another_process(program, **env):
    """What a program prints that is run with the package."""
    done = subprocess.run(
        [sys.executable, "-c", program],
        env={**os.environ, "PYTHONPATH": str(PACKAGES), **env},
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_the_limit_on_resolution_bounds_a_picture(tmp_path):
    file = tmp_path / "copy.svg"
    program = f"""
import gradmesh
document = gradmesh.load({str(SAMPLES / "fruit.svg")!r})
(told,) = gradmesh.publish(document, scale=16)
gradmesh.save(document, {str(file)!r})
print(told.width, told.height)"""
    told = in_another_process(program, GRADMESH_LIMITS="resolution=100")
    root = ET.parse(file)
    (image,) = root.iter(SVG + "image")
    shown = pixels(image)
    assert 95 <= max(shown.shape[:2]) <= 100
    assert told.split() == [str(shown.shape[1]), str(shown.shape[0])]
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


def test_blocks_are_one_picture(simplified):
    before = ET.fromstring(simplified)
    blocks = {e.get("id") for e in before.iter() if e.get(GRADMESH + "face")}
    assert len(blocks) > 1 and [e for e in before.iter() if e.get(GRADMESH + "kept-for")]
    after = Copy(simplified)
    assert (after.only.id, after.only.shown_as) == ("pear", "picture")
    pear = after.by_id["pear"]
    assert [e.tag for e in pear] == [SVG + "image"] and list(pear) == after.images
    assert pear.get(LABEL) is None and b"Gradient mesh:" not in after.bytes
    assert not blocks & set(after.by_id)
    assert "pear-original" not in after.by_id
    others = {"layer1", "background", "shadow", "stem", "leaf", "title1"}
    assert others <= set(after.by_id)
    expect_no_meshes(after)


def test_a_simplified_mesh_has_the_picture_of_the_mesh(simplified):
    before, after = Copy((SAMPLES / "fruit.svg").read_text()), Copy(simplified)
    assert area(before.image) == area(after.image)
    first, second = pixels(before.image), pixels(after.image)
    assert 0 < np.abs(first - second).mean() < 8


def test_a_persons_own_label_stays(simplified):
    label = re.search(r'inkscape:label="(Gradient mesh: [^"]*)"', simplified)[0]
    assert simplified.count(label) == 1
    after = Copy(simplified.replace(label, 'inkscape:label="My pear"'))
    assert after.by_id["pear"].get(LABEL) == "My pear"
    expect_no_meshes(after)


def test_a_simplified_mesh_that_stays_one_gradient():
    """What it remembers goes too."""
    document = gradmesh.load(SAMPLES / "fruit.svg")
    gradmesh.simplify(document, method="plain", keep_original=True, **SMALL)
    assert not document.meshes[0].simplified and b"gradmesh:" in document.to_bytes()
    after = Copy(document.to_bytes().decode())
    assert after.only.shown_as == "picture" and len(after.images) == 1
    expect_no_meshes(after)


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
    assert len(list(after.root.iter(SVG + "mask"))) == len(list(before.iter(SVG + "mask"))) - (
        name == "opacity"
    )
    expect_no_meshes(after)


def test_a_converted_mesh():
    converted = gradmesh.convert(gradmesh.loads(grid(3, 3), "grid.hemesh"), "svg").document
    assert converted.meshes[0].simplified
    after = Copy(converted.to_bytes().decode())
    assert after.only.shown_as == "picture" and len(after.images) == 1
    expect_no_meshes(after)


# --- what else paints, and how ---


def test_a_stroke_is_masked_by_itself():
    stroked = SHAPE.format('style="fill:none;stroke:url(#m);stroke-width:3;stroke-dasharray:4 2"')
    after = Copy(document(MANY, stroked))
    assert after.only.shown_as == "picture"
    (white,) = after.named(after.by_id["box"], "mask")
    assert style(white)["stroke"] in ("white", "#fff", "#ffffff") and style(white)["stroke-width"] == "3"
    assert style(white)["stroke-dasharray"] == "4 2"
    expect_around(after.image, (10, 10, 40, 20), 2)
    expect_no_meshes(after)


def test_text():
    text = '<text id="box" x="12" y="28" font-size="18" fill="url(#m)">ab<tspan id="t">c</tspan></text>'
    after = Copy(document(MANY, text))
    assert after.only.shown_as == "picture"
    (letters,) = after.named(after.by_id["box"], "clip-path")
    assert letters.tag == SVG + "text" and "".join(letters.itertext()) == "abc"
    assert letters.get("font-size", style(letters).get("font-size")) in ("18", "18px")
    expect_no_meshes(after)


def test_text_of_one_colour_may_be_cut_by_the_mesh():
    """Where letters are is not known, so the outline of the mesh cuts."""
    text = '<text id="box" x="12" y="28" font-size="18" fill="url(#m)">abc</text>'
    after = Copy(document([[RED] * 2] * 2, text))
    assert after.only.shown_as == "picture" and after.image.get("clip-path")


def test_a_fill_and_a_stroke_of_meshes():
    second = gradient(lattice([[BLUE, RED], [GREEN, RED]]), "n")
    body = SHAPE.format('style="fill:url(#m);stroke:url(#n);stroke-width:4"')
    after = Copy(document(MANY, body, second))
    assert [told.shown_as for told in after.told] == ["picture", "picture"]
    assert len(after.images) == 2
    assert all(image in list(after.by_id["box"].iter()) for image in after.images)
    # The stroke is above the fill.
    order = [pixels(image)[4, 4] for image in after.by_id["box"].iter(SVG + "image")]
    assert np.abs(order[1] - 255 * np.array(colour(BLUE)[:3])).max() <= 32
    expect_no_meshes(after)


@pytest.mark.parametrize("order", ["normal", "stroke"])
def test_a_plain_stroke_stays_a_stroke(order):
    body = SHAPE.format(f'style="fill:url(#m);stroke:#112233;stroke-width:4;paint-order:{order}"')
    after = Copy(document(MANY, body))
    box = after.by_id["box"]
    (rect,) = box.findall(SVG + "rect")
    assert (style(rect)["stroke"], style(rect)["fill"]) == ("#112233", "none")
    places = [SVG + "image" in {e.tag for e in child.iter()} for child in box]
    assert places == ([True, False] if order == "normal" else [False, True])
    expect_no_meshes(after)


def test_an_object_that_use_shows():
    body = '<use id="u" xlink:href="#box" x="3"/><use id="v" xlink:href="#box" y="30"/>'
    after = Copy(document(MANY, body, FILLED))
    assert [after.by_id[name].get(HREF) for name in "uv"] == ["#box", "#box"]
    defs = after.by_id["defs"]
    assert after.by_id["box"] in list(defs) and after.image in list(after.by_id["box"])
    # Nothing is known of what the copies show, but what the object's own shape does.
    expect_around(after.image, (12, 12, 36, 16), 2)
    expect_no_meshes(after)


def test_an_object_of_a_symbol():
    body = '<symbol id="s">' + FILLED + '</symbol><use id="u" xlink:href="#s"/>'
    after = Copy(document(MANY, body))
    assert after.by_id["box"] in list(after.by_id["s"]) and len(after.images) == 1
    expect_no_meshes(after)


def test_a_group_that_hands_the_mesh_on():
    other = '<circle id="dot" cx="30" cy="20" r="4"/><path id="plain" d="M 1,1 9,9 1,9" fill="red"/>'
    after = Copy(document(MANY, f'<g id="g" fill="url(#m)">{SHAPE.format("")}{other}</g>'))
    assert [(told.id, told.shown_as) for told in after.told] == [("box", "picture"), ("dot", "picture")]
    assert len(after.images) == 2
    plain = after.by_id["plain"]
    assert plain.get("fill") == "red" and plain.get("style") is None
    expect_no_meshes(after)


def test_a_group_that_hands_one_colour_on():
    after = Copy(document([[RED] * 2] * 2, f'<g id="g" fill="url(#m)">{SHAPE.format("")}</g>'))
    assert after.only.shown_as == "colour"
    assert style(after.by_id["box"])["fill"] == RED
    expect_no_meshes(after)


def test_a_style_sheet_that_names_the_mesh():
    sheet = "<style>.painted { fill: url(#m); opacity: 0.5 }</style>"
    after = Copy(document(MANY, SHAPE.format('class="painted"'), sheet))
    assert after.only.shown_as == "picture" and len(after.images) == 1
    # Not each of the group and the shape.
    shown = [e for e in after.by_id["box"].iter() if e.get("class") == "painted" or "opacity" in style(e)]
    assert shown == [after.by_id["box"]]
    expect_no_meshes(after)


KEPT = {
    "transform": "rotate(20 30 20)",
    "opacity": "0.5",
    "filter": "url(#blur)",
    "clip-path": "url(#clip)",
    "mask": "url(#mask)",
}
KEPT_DEFS = (
    '<filter id="blur"><feGaussianBlur stdDeviation="1"/></filter>'
    '<clipPath id="clip"><circle cx="30" cy="20" r="9"/></clipPath>'
    '<mask id="mask"><circle cx="30" cy="20" r="9" fill="#fff"/></mask>'
)


@pytest.mark.parametrize("names", [[name] for name in KEPT] + [list(KEPT)], ids=" ".join)
def test_what_else_the_object_has_stays_with_it(names):
    attributes = " ".join(f'{name}="{KEPT[name]}"' for name in names)
    after = Copy(document(MANY, SHAPE.format(f'fill="url(#m)" {attributes}'), KEPT_DEFS))
    box = after.by_id["box"]
    for name in names:
        assert box.get(name, style(box).get(name)) == KEPT[name], name
        inside = [e for e in box.iter() if e is not box and (e.get(name) == KEPT[name])]
        assert not inside, "twice"
    # Another clip path of the object than the shape.
    assert after.image.get("clip-path") is None
    shapes = [after.named(e, "clip-path") for e in box.iter() if e.get("clip-path")]
    assert SVG + "rect" in {shape[0].tag for shape in shapes}
    expect_no_meshes(after)


def test_the_opacity_of_a_fill_is_that_of_the_group():
    after = Copy(document(MANY, SHAPE.format('style="fill:url(#m);fill-opacity:0.5;opacity:0.5"')))
    opacities = [float(style(e).get("opacity", e.get("opacity", 1))) for e in after.by_id["box"].iter()]
    assert math.prod(opacities) == pytest.approx(0.25)
    assert pixels(after.image).shape[2] == 3


def test_title_and_other_children_stay():
    body = '<rect id="box" width="40" height="30" fill="url(#m)"><title id="t">A box</title></rect>'
    after = Copy(document(MANY, body))
    assert after.by_id["t"] in list(after.by_id["box"]) and after.by_id["t"].text == "A box"


def test_gradients_in_the_box_of_the_object():
    text = (SAMPLES / "ellipse.svg").read_text()
    assert 'gradientUnits="objectBoundingBox"' in text.partition("<meshgradient")[2].partition(">")[0]
    after = Copy(text)
    expect_around(after.image, (80, 72, 400, 376), 2)


def test_one_mesh_on_two_objects():
    body = FILLED + '<circle id="dot" cx="30" cy="20" r="4" fill="url(#m)"/>'
    after = Copy(document(MANY, body))
    assert {told.id for told in after.told} == {"box", "dot"}
    widths = {told.id: told.width for told in after.told}
    assert widths["dot"] < widths["box"]
    expect_no_meshes(after)


def test_a_gradient_that_has_its_rows_from_another():
    linked = '<meshgradient id="n" x="10" y="10" xlink:href="#m" gradientUnits="userSpaceOnUse"/>'
    after = Copy(document(MANY, SHAPE.format('fill="url(#n)"'), linked))
    assert after.only.shown_as == "picture"
    expect_no_meshes(after)


def test_gradients_that_nobody_sees_go():
    """What names one gets the colour for programs without meshes."""
    body = (
        FILLED
        + '<g id="group" fill="url(#n) #abcdef"><rect id="inner" width="3" height="3" fill="red"/></g>'
        + '<g id="empty" style="stroke:url(#n)"/>'
    )
    unused = gradient(lattice(MANY), "n") + gradient(lattice(MANY), "o")
    after = Copy(document(MANY, body, unused))
    assert after.only.id == "box"
    group, empty = after.by_id["group"], after.by_id["empty"]
    assert style(group).get("fill", group.get("fill")) == "#abcdef"
    assert style(empty)["stroke"] == "none"
    assert after.by_id["inner"].get("fill") == "red"
    expect_no_meshes(after)


def test_scripts_of_inkscape_that_paint_meshes_go_and_others_stay():
    scripts = '<script id="mesh_polyfill">1</script><script id="mesh_polyfill2">2</script>'
    after = Copy(document(MANY, FILLED + scripts + '<script id="mine">3</script>'))
    assert [e.get("id") for e in after.root.iter(SVG + "script")] == ["mine"]
    assert after.by_id["mine"].text == "3"
    expect_no_meshes(after)


def test_ids_that_are_taken():
    taken = ["box-picture1", "box-shape2", "box-outline1", "box-gradient1", "box-picture", "box-shape"]
    body = FILLED + "".join(f'<rect id="{name}" width="1" height="1"/>' for name in taken)
    after = Copy(document(MANY, body))
    assert all(after.by_id[name].tag == SVG + "rect" for name in taken)
    expect_no_meshes(after)


def test_an_object_without_an_id():
    after = Copy(document(MANY, '<rect width="40" height="30" fill="url(#m)"/>'))
    assert after.only.id in after.by_id and after.image in list(after.by_id[after.only.id].iter())
    expect_no_meshes(after)


# --- refusals ---

BAD_GRADIENT = f'<meshgradient id="n">{row(FIRST, NEXT)}{row(BELOW)}</meshgradient>'
BAD = SHAPE.format('fill="url(#n)"').replace('id="box"', 'id="bad"')


def test_a_mesh_that_cannot_be_read_stays_beside_others():
    text = document(MANY, FILLED + BAD, BAD_GRADIENT)
    after = Copy(text)
    good, bad = sorted(after.told, key=lambda told: told.id == "bad")
    assert (good.id, good.shown_as, good.refused) == ("box", "picture", None)
    assert (bad.id, bad.shown_as, bad.width, bad.height, bad.bytes) == ("bad", "nothing", 0, 0, 0)
    assert isinstance(bad.refused, gradmesh.InputError) and 'meshgradient "n"' in str(bad.refused)
    before = {e.get("id"): e for e in ET.fromstring(text).iter()}
    for name in ("bad", "n"):
        assert ET.tostring(after.by_id[name]).strip() == ET.tostring(before[name]).strip()
    assert "m" not in after.by_id


def refused(text, *words, error=gradmesh.InputError, name="document", **options):
    document = gradmesh.loads(text, name)
    before = document.to_bytes()
    with pytest.raises(error) as raised:
        gradmesh.publish(document, **options)
    sentence = str(raised.value)
    assert all(word in sentence for word in words), sentence
    assert sentence.endswith(".") and "\n" not in sentence
    assert document.to_bytes() == before


def test_only_a_mesh_that_cannot_be_read():
    refused(DOCUMENT.format(defs=BAD_GRADIENT, body=BAD), 'meshgradient "n"')


def test_no_mesh():
    refused(DOCUMENT.format(defs="", body=SHAPE.format('fill="red"')), "no object")


def test_a_published_document_has_no_mesh():
    refused(Copy((SAMPLES / "fruit.svg").read_text()).bytes.decode(), "no object")


def test_hemesh_files():
    refused(grid(2, 2), "grid.hemesh", "only SVG documents", "gradmesh convert", name="grid.hemesh")


@pytest.mark.parametrize("scale", [0, -1, 17, 16.01, math.nan, math.inf])
def test_scales_that_are_none(scale):
    refused(document(MANY), "scale", error=ValueError, scale=scale)


# --- the same again ---


@pytest.mark.parametrize("name", ["fruit", "two"])
def test_the_same_bytes_in_every_run_and_on_any_number_of_cores(tmp_path, name):
    text = (SAMPLES / f"{name}.svg").read_text()
    expected = Copy(text).bytes
    assert Copy(text).bytes == expected
    file = tmp_path / "copy.svg"
    program = f"""
import os
if hasattr(os, "sched_setaffinity"):
    os.sched_setaffinity(0, [min(os.sched_getaffinity(0))])
import gradmesh
document = gradmesh.loads(open({str(SAMPLES / f"{name}.svg")!r}).read())
gradmesh.publish(document)
gradmesh.save(document, {str(file)!r})"""
    in_another_process(program)
    assert file.read_bytes() == expected


def test_a_published_document_is_saved_and_read_again(tmp_path):
    document = gradmesh.load(SAMPLES / "two.svg")
    gradmesh.publish(document)
    for name in ("copy.svg", "copy.svgz"):
        gradmesh.save(document, tmp_path / name)
        assert gradmesh.load(tmp_path / name).to_bytes() == document.to_bytes()
