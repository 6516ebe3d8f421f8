"""How few pixels the pictures of published documents have, and what is shown of them."""

import base64
import io
import xml.etree.ElementTree as ET

import numpy as np
import pytest

from built import SAMPLES
from lattices import FILLED, MANY, document, lattice
from sample_meshes import PAINTED

import gradmesh
from meshgrid import Mesh, colour
from svg_meshes import HREF, SVG

Image = pytest.importorskip("PIL.Image")

#: Points of a line of 15 patches, and where they are.
EDGES = range(0, 46, 3), [10 + 5 * ((i + 1) // 2) for i in range(16)]

pytestmark = pytest.mark.module_only


def published(text, **options):
    """What is told of the meshes, the images, and the bytes of the copy."""
    copy = gradmesh.loads(text)
    told = gradmesh.publish(copy, **options)
    return told, list(ET.fromstring(copy.to_bytes()).iter(SVG + "image")), copy.to_bytes()


def pixels(image):
    with Image.open(io.BytesIO(base64.b64decode(image.get(HREF).partition(",")[2]))) as picture:
        return np.array(picture, int)


def enlarged(picture, factor):
    """What programs show of a picture with `factor` times as many pixels along each side."""

    def along(levels):
        last = len(levels) - 1
        place = np.clip((np.arange(factor * len(levels)) + 0.5) / factor - 0.5, 0, last)
        first = np.minimum(place.astype(int), last - 1)
        share = (place - first)[:, None, None]
        return levels[first] * (1 - share) + levels[first + 1] * share

    return np.floor(along(along(picture).swapaxes(0, 1)).swapaxes(0, 1) + 1e-9)


@pytest.mark.full
def test_the_samples_are_small():
    """0.3 MB as meshes, 2.3 MB as exact pictures."""
    copies = {name: published((SAMPLES / f"{name}.svg").read_text())[2] for name in PAINTED}
    assert sum(map(len, copies.values())) <= 800_000


@pytest.mark.full
def test_a_large_page_of_few_patches_is_small():
    """Its exact picture takes 2.1 MB."""
    corners = [[0, 1980, 3840], [1020j, 2100 + 1140j, 3840 + 960j], [2160j, 1850 + 2160j, 3840 + 2160j]]
    colours = [["#1b2a6b", "#7a3f9d", "#f08a5d"], ["#2f6f9f", "#c06c9c", "#ffd27f"], ["#0d1b2a", "#3a506b", "#e0b0a0"]]
    mesh = Mesh(corners, [[colour(c) for c in line] for line in colours])
    body = '<rect id="box" width="3840" height="2160" fill="url(#m)"/>'
    text = document(mesh, body).replace('width="100" height="80"', 'width="3840" height="2160"')
    (told,), (image,), copy = published(text)
    assert len(copy) <= 200_000 and told.width < 1000
    assert [float(image.get(side)) for side in ("width", "height")] == pytest.approx([3840, 2160], abs=4)


@pytest.mark.parametrize("opacity", [1, 0.7])
@pytest.mark.full(all_but=1)
def test_an_enlarged_picture_shows_the_exact_one(opacity):
    """Of one patch, whose colours are known at each place."""
    colours = [[(c, opacity) for c in line] for line in MANY]
    body = '<rect id="box" x="10" y="10" width="80" height="60" fill="url(#m)"/>'
    text = document(lattice(colours, (0, 0, 100, 80)), body)
    (told,), (image,), _ = published(text, scale=16)
    small, factor = pixels(image), 4
    assert told.width * 2 <= 16 * float(image.get("width")) and small.shape[2] == (3 if opacity == 1 else 4)
    if opacity < 1:
        small = (small[:, :, :3] * small[:, :, 3:] + 127) // 255
    shown = enlarged(small, factor)
    x, y, width, height = (float(image.get(name)) for name in ("x", "y", "width", "height"))
    u = ((x + (np.arange(shown.shape[1]) + 0.5) * width / shown.shape[1]) / 100)[None, :, None]
    v = ((y + (np.arange(shown.shape[0]) + 0.5) * height / shown.shape[0]) / 80)[:, None, None]
    (a, b), (c, d) = (np.array([colour(text)[:3] for text in line]) for line in MANY)
    expected = 255 * opacity * ((1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * c + u * d))
    # What lies around is not seen.
    inside = np.s_[8 * factor : -8 * factor, 8 * factor : -8 * factor]
    difference = (shown - expected)[inside]
    assert np.abs(difference).max() <= 2 and np.abs(difference.mean((0, 1))).max() <= 0.3


def test_sharp_edges_keep_their_pixels():
    """A mesh every other column of which has no width."""
    mesh = lattice([["#203040", "#d0c050"] * 8] * 2)
    for line in mesh.points:
        line[:] = [complex(x, p.imag) for x, p in zip(np.interp(range(46), *EDGES), line)]
    (told,), (image,), _ = published(document(mesh), scale=16)
    assert (told.width, told.height) == tuple(round(16 * float(image.get(side))) for side in ("width", "height"))
    smooth, _, _ = published(document(MANY), scale=16)
    assert smooth[0].width * 2 <= told.width


def test_small_documents_keep_their_pixels():
    """All pictures of a document together decide."""
    (told,), (image,), _ = published(document(MANY), scale=4)
    assert told.width == pytest.approx(4 * float(image.get("width")), abs=0.01)
    many = "".join(FILLED.replace("box", f"box{i}") for i in range(20))
    assert all(2 * other.width <= told.width + 1 for other in published(document(MANY, many), scale=4)[0])
