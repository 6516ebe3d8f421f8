"""Pages look in Inkscape as before when their meshes are simplified, and when they are published.

The environment variable GRADMESH_RANDOM_DOCUMENTS says how many random documents there are,
GRADMESH_RANDOM_FIRST with which seed they begin.
"""

import os
import re
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import NamedTuple

import pytest

import random_documents
from built import ROOT
from in_inkscape import inkscape, needs  # noqa: F401

np = pytest.importorskip("numpy")
Image = pytest.importorskip("PIL.Image")
gradmesh = pytest.importorskip("gradmesh", reason="the compiled package is not there")

from pictures import on_white

pytestmark = needs()

#: The largest FLIP of a page, by what was done to its meshes.
SIMPLIFIED, PUBLISHED = "simplified", "published"
LIMITS = {SIMPLIFIED: 0.012, PUBLISHED: 0.02}
#: Along the longer side of what Inkscape paints. It paints edges of meshes in whole pixels, so that pictures of half
#: that side are compared.
PIXELS = 600
#: So far off is what is only rounded in another way. FLIP charges 0.03 for a single level everywhere.
LEVELS = 2
#: Inkscape takes ten seconds and more to paint one page of these.
EXPENSIVE = ("oxygen-juk", "oxygen-kdebugsettings")
SHARED = ROOT.parent / "shared"
FIRST = int(os.environ.get("GRADMESH_RANDOM_FIRST", 0))
SEEDS = range(FIRST, FIRST + int(os.environ.get("GRADMESH_RANDOM_DOCUMENTS", 40)))

PAGE = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
  width="100" height="100" viewBox="0 0 100 100">
<defs><meshgradient id="m" gradientUnits="userSpaceOnUse" x="0" y="0"><meshrow>
<meshpatch><stop path="l 50,0" stop-color="#00f"/><stop path="l 0,100" stop-color="#800080"/>
<stop path="l -50,0" stop-color="#80d500"/><stop path="l 0,-100" stop-color="#0a0"/></meshpatch>
<meshpatch><stop path="l 50,0"/><stop path="l 0,100" stop-color="#f00"/>
<stop path="l -50,0" stop-color="#ff0"/></meshpatch></meshrow></meshgradient></defs>
{}
</svg>
"""
SQUARE = '<rect id="r" x="20" y="20" width="40" height="40" {}/>'
MESH = 'fill="url(#m)"'
#: What random documents have found, by its least.
FOUND = {
    "filled": SQUARE.format(MESH),
    "clone outside of the group": f'<g {MESH}>{SQUARE.format("")}</g><use xlink:href="#r" x="30" y="30"/>',
    "percent in an inner svg": (
        f'<svg x="10" y="10" width="80" height="80" viewBox="0 0 50 50"><rect x="30%" y="30%" width="60%"'
        f' height="60%" {MESH}/></svg>'
    ),
    "marker without a stroke": (
        '<marker id="k" overflow="visible" markerUnits="userSpaceOnUse"><rect width="30" height="30" fill="#840"/>'
        f'</marker><path d="M 20,30 H 80 V 60 Z" marker-start="url(#k)" {MESH}/>'
    ),
    "rule for all": f"<style>* {{ opacity: 0.6 }}</style>{SQUARE.format(MESH)}",
    "rule for second children": (
        f"<style>rect:nth-child(2) {{ stroke: #000; stroke-width: 8 }}</style><g>{SQUARE.format(MESH)}</g>"
    ),
}
#: What is seen of documents that are wrong today, by document and what was done.
KNOWN = {
    "faults/publish-cuts-folded-mesh published": "Inkscape paints meshes to whole pixels and one beyond: 0.027",
}


def of_others(folder):
    """The lines of a folder of documents that others made."""
    paths = sorted(path for path in (SHARED / folder).glob("*.svg") if path.stem not in EXPENSIVE)
    absent = pytest.param(None, id=folder, marks=pytest.mark.skip(reason=f"no documents in ../shared/{folder}"))
    return [pytest.param(path, id=f"{folder}/{path.stem}") for path in paths] or [absent]


def of_seeds():
    return [pytest.param(seed, id=f"random/{seed}") for seed in SEEDS]


def of_found():
    return [pytest.param(PAGE.format(body).encode(), id=f"found/{name}") for name, body in FOUND.items()]


DOCUMENTS = [*of_others("faults"), *of_others("wild4"), *of_others("real"), *of_found(), *of_seeds()]


def bytes_of(document):
    (of,) = document.values
    if isinstance(of, Path):
        return of.read_bytes()
    return random_documents.document(of) if isinstance(of, int) else of


def lines():
    """A line for each document and what is done, with the marks of those that are known to be wrong."""
    for document in DOCUMENTS:
        for done in LIMITS:
            name = f"{document.id} {done}"
            known = [pytest.mark.xfail(strict=True, reason=KNOWN[name])] if name in KNOWN else []
            yield pytest.param(document.id, done, id=name, marks=[*document.marks, *known])


class Page(NamedTuple):
    before: Path  #: pictures
    after: Path


CHANGES = {SIMPLIFIED: gradmesh.simplify, PUBLISHED: gradmesh.publish}
PIXELS_OF = {"": 1, "px": 1, "pt": 4 / 3, "pc": 16, "mm": 96 / 25.4, "cm": 96 / 2.54, "in": 96}


def dots_per_inch(document):
    """With which the page of a document is as large as it is painted here."""
    root = ET.fromstring(document)
    box = [float(number) for number in re.split(r"[\s,]+", root.get("viewBox", "").strip()) if number]
    sides = box[2:] or [100.0, 100.0]
    for name in ("width", "height"):
        number = re.fullmatch(r"\s*([-+.\deE]*[.\d])\s*([a-z]*)\s*", root.get(name, ""))
        if number and number[2] in PIXELS_OF:
            sides.append(float(number[1]) * PIXELS_OF[number[2]])
    return 96 * PIXELS / max(sides[2:] or sides)


@pytest.fixture(scope="module")
def pages(request, inkscape, tmp_path_factory):
    """Of each document that a test asks for what became of it, painted by one Inkscape, or what was raised; and
    why Inkscape wrote no picture, for each one that it did not write."""
    folder = tmp_path_factory.mktemp("pages")
    lines = [item.callspec.params for item in request.session.items if hasattr(item, "callspec")]
    asked = {line.get("name") for line in lines}
    found, pictures, dpi = {}, {}, {}

    def painted(data, number, kind):
        path = folder / f"{number}-{kind}.svg"
        path.write_bytes(data)
        pictures[path], dpi[path] = path.with_suffix(".png"), dots_per_inch(data)
        return pictures[path]

    for number, document in enumerate(DOCUMENTS):
        if document.id not in asked or document.values == (None,):
            continue
        data, before = bytes_of(document), None
        for kind, change in CHANGES.items():
            try:
                read = gradmesh.loads(data, document.id)
                change(read)
            except Exception as error:  # of this document alone
                found[document.id, kind] = error
                continue
            before = before or painted(data, number, "before")
            found[document.id, kind] = Page(before, painted(read.to_bytes(), number, kind))
    missing = inkscape.export_pages(pictures, dpi, timeout=300)
    return found, {pictures[path]: reason for path, reason in missing.items()}


def pixels(png):
    with Image.open(on_white(png)) as picture:
        return np.array(picture.convert("RGB").reduce(2))


def difference(before, after):
    """The mean FLIP, but for rounding."""
    off = np.abs(before.astype(int) - after).max(axis=2, keepdims=True)
    return gradmesh.compare(before, np.where(off <= LEVELS, before, after))


@pytest.mark.parametrize("name, done", lines())
@pytest.mark.full
def test_the_page_looks_the_same(pages, name, done):
    found, missing = pages
    page = found[name, done]
    if isinstance(page, gradmesh.InputError):
        assert str(page).endswith(".") and "\n" not in str(page)
        return
    if isinstance(page, Exception):
        raise page
    if page.before in missing:
        pytest.skip(f"{missing[page.before]} of the document as it was")
    assert page.after not in missing, missing[page.after]
    before, after = pixels(page.before), pixels(page.after)
    assert before.shape == after.shape
    assert difference(before, after) <= LIMITS[done]


def test_a_seed_gives_the_same_document():
    documents = [random_documents.document(seed) for seed in range(20)]
    assert documents == [random_documents.document(seed) for seed in range(20)]
    assert len(set(documents)) == 20
