"""Small pages of which more or less was once read than is seen, each with what is right of it."""

import re
import xml.etree.ElementTree as ET
from typing import NamedTuple

import pytest

from built import ROOT

gradmesh = pytest.importorskip("gradmesh", reason="the compiled package is not there")

FAULTS = ROOT.parent / "shared" / "faults5"
pytestmark = pytest.mark.skipif(not FAULTS.is_dir(), reason="no documents in ../shared/faults5")
SVG = "{http://www.w3.org/2000/svg}"


class Right(NamedTuple):
    """What is right of a page."""

    patches: tuple = ()  #: of each mesh
    told: str = ""  #: what is told, as a pattern
    all_layers: int = 1  #: how many meshes there are if layers that are off are read


#: By the name of the fault.
PAGES = {
    "alpha-mask-is-ignored-without-a-word": Right((1,)),
    "cells-of-four-triangles-are-no-grid": Right((6,)),
    "clip-by-text-is-ignored-without-a-word": Right((1,), "mesh 1: it is seen through text whose letters"),
    "colour-space-named-in-resources-refused": Right((1,)),
    "folded-patch-of-a-pdf-is-cut-by-its-own-outline": Right((1,)),
    "form-of-a-layer-that-is-off-is-read-as-if-shown": Right((1,), "layers that are off .* 1 of its", 2),
    "layer-that-is-off-is-read-as-if-shown": Right((1,), "layers that are off .* 1 of its", 2),
    "limit-that-the-sentence-names-is-not-enough": Right((), "39204 patches.*patches=39204 raises", 0),
    "mesh-in-a-tiling-pattern-is-told-as-no-mesh": Right((1,), "a pattern repeats it"),
    "separation-none-is-painted": Right((), "its colorant is None", 0),
    "text-filled-by-mesh-is-told-as-no-mesh": Right((1,), "mesh 1: it is seen through text whose letters"),
}


def read(name, **options):
    """The document, and what is told, also where that is all."""
    try:
        document = gradmesh.load(FAULTS / f"{name}.pdf", **options)
    except gradmesh.InputError as error:
        if "was built without PDF" in str(error):
            pytest.skip(str(error))
        return None, [str(error)]
    return document, [str(each) for each in document.left_out]


@pytest.mark.parametrize("name", PAGES)
def test_is_read_as_it_is_seen_or_told(name):
    right = PAGES[name]
    document, told = read(name)
    found = [mesh["found"]["patches"] for mesh in gradmesh.info(document)["meshes"]] if document else []
    assert tuple(found) == right.patches
    assert bool(told) == bool(right.told)
    assert re.search(right.told, " ".join(told))


@pytest.mark.parametrize("name", PAGES)
def test_layers_that_are_off_are_read_where_that_is_asked(name):
    document, _ = read(name, all_layers=True)
    assert (len(document.meshes) if document else 0) == PAGES[name].all_layers


def shape(name):
    """The path that the one mesh of a page fills, as its numbers."""
    document, _ = read(name)
    (path,) = [e for e in ET.fromstring(document.to_bytes()).iter(f"{SVG}path") if "url(#" in str(e.attrib)]
    return [float(number) for number in re.findall(r"-?[\d.]+", path.get("d"))]


def test_an_alpha_mask_is_the_shape():
    x, y = (shape("alpha-mask-is-ignored-without-a-word")[k::2] for k in (0, 1))
    pixels = 96 / 72
    assert (min(x), max(x)) == pytest.approx((20 * pixels, 100 * pixels))
    assert (min(y), max(y)) == pytest.approx((20 * pixels, 180 * pixels))


def test_a_folded_patch_lies_in_a_convex_shape():
    numbers = shape("folded-patch-of-a-pdf-is-cut-by-its-own-outline")
    corners = list(zip(numbers[::2], numbers[1::2]))
    turns = []
    for n in range(len(corners)):
        (ax, ay), (bx, by), (cx, cy) = (corners[(n + k) % len(corners)] for k in range(3))
        turns.append((bx - ax) * (cy - by) - (by - ay) * (cx - bx))
    assert all(turn > 0 for turn in turns)


def test_postscript_is_known_behind_a_blank_line():
    path = FAULTS / "blank-line-before-postscript-is-told-as-svg.eps"
    try:
        assert len(gradmesh.load(path).meshes) == 1
    except gradmesh.InputError as error:
        assert "Ghostscript is installed" in str(error) or "was built without PDF" in str(error)
