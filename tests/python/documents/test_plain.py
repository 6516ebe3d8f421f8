"""Whatever is simplest leaves the object as it is, painted by one mesh gradient with few handles."""

import re
import xml.etree.ElementTree as ET
from typing import NamedTuple

import pytest

pytest.importorskip("numpy")

import inkscape_harness
from built import SAMPLES, gradmesh as run
from sample_meshes import OBJECTS, PAINTED, mesh_of
from svg_meshes import GRADMESH, SVG

import gradmesh

NAMES = ("fruit", "face", "ellipse", "two", "transformed")
PAINTED_BY = [(sample, painted) for sample, painted in OBJECTS if sample in NAMES]
EPSILON = 0.01
#: The whole mesh is measured, so that its picture has the error that is told.
OPTIONS = {"resolution": 300, "epsilon": EPSILON, "visible_only": False}
PAGE = 0.002  # the page has other pixels than the mesh was measured at
PAINTS = ("fill", "stroke")
REASON = inkscape_harness.missing()


class Simplified(NamedTuple):
    before: bytes
    after: bytes
    results: dict  #: by the id of the object

    def roots(self):
        return ET.fromstring(self.before), ET.fromstring(self.after)


@pytest.fixture(scope="module")
def plain():
    """What becomes of a sample by default."""
    found = {}

    def simplify(sample):
        if sample not in found:
            document = gradmesh.load(SAMPLES / f"{sample}.svg")
            before = document.to_bytes()
            results = gradmesh.simplify(document, **OPTIONS)
            by_id = {result.id: result for result in results}
            found[sample] = Simplified(before, document.to_bytes(), by_id)
        return found[sample]

    return simplify


def declarations(element):
    """What an element that is painted by a mesh gradient declares in its style or, of its paints,
    in attributes, whatever the name of the gradient is."""
    parts = [part.split(":", 1) for part in element.get("style", "").split(";") if part.strip()]
    found = {name: element.get(name) for name in PAINTS if element.get(name)}
    found |= {name.strip(): value.strip() for name, value in parts}
    return {name: re.sub(r"url\(#[^)]*\)", "url()", value) for name, value in found.items()}


def all_but_meshes(root):
    """All elements in their order, with their depths, texts and attributes, without mesh gradients.
    Of an object that is painted by one the name of the gradient does not count, nor whether the
    paint is in its style, nor what it remembers."""
    found = []
    meshes = {e.get("id") for e in root.iter(SVG + "meshgradient")}

    def walk(node, depth):
        if node.tag == SVG + "meshgradient":
            return
        attributes, declared = dict(node.attrib), None
        if any(f"url(#{mesh})" in value for mesh in meshes for value in attributes.values()):
            declared = declarations(node)
            for name in ("style", *PAINTS):
                attributes.pop(name, None)
        attributes = {name: v for name, v in attributes.items() if not name.startswith(GRADMESH)}
        text = (node.text or "").strip(), (node.tail or "").strip()
        found.append((depth, node.tag, attributes, declared, text))
        for child in node:
            walk(child, depth + 1)

    walk(root, 0)
    return found


def sides(gradient):
    """The letters of the sides that are written: each side of the grid once."""
    return [stop.get("path")[0] for stop in gradient.iter(SVG + "stop")]


@pytest.mark.parametrize("sample", NAMES)
def test_only_the_mesh_gradients_are_others(plain, sample):
    before, after = plain(sample).roots()
    assert all_but_meshes(after) == all_but_meshes(before)
    # Of the rows that are taken from another gradient (href) each mesh has its own now.
    assert len(list(after.iter(SVG + "meshgradient"))) == len(PAINTED[sample])


@pytest.mark.parametrize("sample, painted", PAINTED_BY)
def test_one_object_with_fewer_handles_is_left(plain, sample, painted):
    result = plain(sample).results[painted]
    assert (result.method, result.objects, result.changed) == ("plain", 1, True)
    assert result.patches_before == PAINTED[sample][painted] >= result.patches_after
    assert result.handles_after < result.handles_before
    assert 0 < result.error <= EPSILON
    (mesh,) = [mesh for mesh in gradmesh.loads(plain(sample).after).meshes if mesh.id == painted]
    assert not mesh.simplified and mesh.patches == result.patches_after


@pytest.mark.parametrize("sample, painted", PAINTED_BY)
def test_straight_sides_are_lines_and_all_is_counted_in_the_file(plain, sample, painted):
    result, gradient = plain(sample).results[painted], mesh_of(plain(sample).roots()[1], painted)
    rows = [list(row.iter(SVG + "meshpatch")) for row in gradient.iter(SVG + "meshrow")]
    assert len({len(row) for row in rows}) == 1
    assert not [patch for row in rows for patch in row if patch.get("tensor")]
    letters = "".join(sides(gradient)).upper()
    lines, columns = len(rows), len(rows[0])
    assert len(letters) == lines * (columns + 1) + columns * (lines + 1)
    assert set(letters) <= {"L", "C"} and "L" in letters
    assert result.handles_after == (lines + 1) * (columns + 1) + 2 * letters.count("C")
    assert result.patches_after == lines * columns


@pytest.mark.parametrize("sample, painted", PAINTED_BY)
def test_what_is_told_is_found_again(plain, sample, painted):
    result = plain(sample).results[painted]
    before, after = (gradmesh.loads(data) for data in plain(sample)[:2])
    frame = {"id": painted, "resolution": OPTIONS["resolution"]}
    pictures = gradmesh.render(before, **frame), gradmesh.render(after, framed_as=before, **frame)
    assert gradmesh.compare(*pictures) == pytest.approx(result.error, abs=2e-4)
    # Without an error allowed nothing more is taken out, and what there is, is measured.
    options = {**OPTIONS, "epsilon": 0, "original": before, "preview": True}
    (again,) = gradmesh.simplify(after, painted, **options)
    assert not again.changed
    assert again.handles_before == again.handles_after == result.handles_after
    assert again.patches_before == result.patches_after
    assert again.error == pytest.approx(result.error, abs=1e-5)
    assert again.local_error == pytest.approx(result.local_error, abs=1e-3)


@pytest.mark.parametrize("sample", NAMES)
def test_small_parts_keep_to_their_bound(plain, sample):
    free = plain(sample).results
    bound = max(result.local_error for result in free.values()) / 2
    document, before = (gradmesh.load(SAMPLES / f"{sample}.svg") for _ in range(2))
    for result in gradmesh.simplify(document, max_local_error=bound, **OPTIONS):
        assert result.local_error <= bound and result.error <= EPSILON
        assert result.handles_after <= result.handles_before
        options = {**OPTIONS, "epsilon": 0, "original": before, "preview": True}
        (found,) = gradmesh.simplify(document, result.id, **options)
        assert found.local_error == pytest.approx(result.local_error, abs=1e-3)


@pytest.mark.parametrize("sample", NAMES)
def test_a_second_run_only_takes_more_out(plain, sample):
    document = gradmesh.loads(plain(sample).after)
    results = gradmesh.simplify(document, **OPTIONS)
    for result in results:
        first = plain(sample).results[result.id]
        assert (result.handles_before, result.patches_before) == (first.handles_after, first.patches_after)
        assert (result.handles_after < result.handles_before) == result.changed
        assert result.patches_after <= result.patches_before
        assert result.objects == 1 and result.error <= EPSILON
    if not any(result.changed for result in results):
        assert document.to_bytes() == plain(sample).after
    before, after = ET.fromstring(plain(sample).before), ET.fromstring(document.to_bytes())
    assert all_but_meshes(after) == all_but_meshes(before)


def test_nothing_changed_is_byte_for_byte_the_same():
    document = gradmesh.load(SAMPLES / "fruit.svg")
    (result,) = gradmesh.simplify(document, resolution=300, epsilon=0)
    assert (result.changed, result.stopped, result.objects) == (False, "nothing to merge", 1)
    assert (result.error, result.handles_after) == (0, result.handles_before)
    assert document.to_bytes() == (SAMPLES / "fruit.svg").read_bytes()


@pytest.fixture(scope="module")
def inkscape():
    with inkscape_harness.Inkscape() as running:
        yield running


@pytest.mark.skipif(bool(REASON), reason=REASON or "nothing is missing")
@pytest.mark.parametrize("sample", NAMES)
def test_inkscape_paints_the_same(plain, inkscape, tmp_path, sample):
    pictures = []
    for when, data in zip(("before", "after"), plain(sample)):
        svg = tmp_path / f"{when}.svg"
        svg.write_bytes(data)
        pictures.append(inkscape.export_png(svg, tmp_path / f"{when}.png", width=700))
    assert float(run("compare", *pictures).stdout) <= EPSILON + PAGE
