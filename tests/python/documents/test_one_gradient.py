"""Whatever is simplest leaves the object as it is, painted by one mesh gradient with few handles, and
so does the method lines."""

import io
import re
import xml.etree.ElementTree as ET
from typing import NamedTuple

import pytest

np = pytest.importorskip("numpy")

import svg_meshes
from built import SAMPLES
from in_inkscape import inkscape  # noqa: F401
from program import error
from sample_meshes import OBJECTS, PAINTED, mesh_of
from svg_meshes import GRADMESH, SVG, declared

import gradmesh

NAMES = ("fruit", "face", "ellipse", "two", "transformed")
EPSILON = 0.01
#: The whole mesh is measured, so that its picture has the error that is told.
OPTIONS = {"resolution": 300, "epsilon": EPSILON, "visible_only": False}
RUNS = {"plain": OPTIONS, "lines": {"resolution": 700, "epsilon": 0.02, "visible_only": False, "method": "lines"}}
#: By which method a sample is simplified, the name of its object too.
BY = [("plain", sample) for sample in NAMES] + [("lines", sample) for sample in PAINTED]
OBJECTS_BY = [(method, *pair) for method, sample in BY for pair in OBJECTS if pair[0] == sample]
PAGE = 0.002  # the page has other pixels than the mesh was measured at
PAINTS = ("fill", "stroke")


class Simplified(NamedTuple):
    before: bytes
    after: bytes
    results: dict  #: by the id of the object

    def roots(self):
        return ET.fromstring(self.before), ET.fromstring(self.after)


@pytest.fixture(scope="module")
def simplified():
    """What becomes of a sample by default, or by the method lines."""
    found = {}

    def simplify(method, sample):
        if (method, sample) not in found:
            document = gradmesh.load(SAMPLES / f"{sample}.svg")
            before = document.to_bytes()
            by_id = {result.id: result for result in gradmesh.simplify(document, **RUNS[method])}
            found[method, sample] = Simplified(before, document.to_bytes(), by_id)
        return found[method, sample]

    return simplify


def declarations(element):
    """What an element that is painted by a mesh gradient declares in its style or, of its paints,
    in attributes, whatever the name of the gradient is."""
    found = {name: element.get(name) for name in PAINTS if element.get(name)} | declared(element)
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


@pytest.mark.parametrize("method, sample", BY)
@pytest.mark.full(all_but=1)
def test_only_the_mesh_gradients_are_others(simplified, method, sample):
    before, after = simplified(method, sample).roots()
    assert all_but_meshes(after) == all_but_meshes(before)
    # Of the rows that are taken from another gradient (href) each mesh has its own now.
    assert len(list(after.iter(SVG + "meshgradient"))) == len(PAINTED[sample])


@pytest.mark.parametrize("method, sample, painted", OBJECTS_BY)
@pytest.mark.full(all_but=2)
def test_one_object_with_fewer_handles_or_patches_is_left(simplified, method, sample, painted):
    found = simplified(method, sample)
    result = found.results[painted]
    assert (result.method, result.objects, result.changed) == (method, 1, True)
    assert result.patches_before == PAINTED[sample][painted] >= result.patches_after
    fewer = "handles" if method == "plain" else "patches"
    assert getattr(result, f"{fewer}_after") < getattr(result, f"{fewer}_before")
    assert 0 < result.error <= RUNS[method]["epsilon"]
    (mesh,) = [mesh for mesh in gradmesh.loads(found.after).meshes if mesh.id == painted]
    assert not mesh.simplified and mesh.patches == result.patches_after
    gradient = mesh_of(found.roots()[1], painted)
    rows = [list(row.iter(SVG + "meshpatch")) for row in gradient.iter(SVG + "meshrow")]
    assert {len(row) for row in rows} == {result.patches_after / len(rows)}


@pytest.mark.parametrize("sample, painted", [pair for pair in OBJECTS if pair[0] in NAMES])
@pytest.mark.full(all_but=1)
def test_straight_sides_are_lines_and_all_is_counted_in_the_file(simplified, sample, painted):
    result = simplified("plain", sample).results[painted]
    gradient = mesh_of(simplified("plain", sample).roots()[1], painted)
    rows = [list(row.iter(SVG + "meshpatch")) for row in gradient.iter(SVG + "meshrow")]
    assert not [patch for row in rows for patch in row if patch.get("tensor")]
    letters = "".join(sides(gradient)).upper()
    lines, columns = len(rows), len(rows[0])
    assert len(letters) == lines * (columns + 1) + columns * (lines + 1)
    assert set(letters) <= {"L", "C"} and "L" in letters
    assert result.handles_after == (lines + 1) * (columns + 1) + 2 * letters.count("C")


@pytest.mark.parametrize("sample, painted", OBJECTS)
@pytest.mark.full(all_but=1)
def test_without_lines_a_gradient_is_where_it_was_and_of_its_kind(simplified, sample, painted):
    found = simplified("lines", sample)
    before, after = (svg_meshes.Document(io.BytesIO(data)) for data in found[:2])
    elements = [document.by_id[painted] for document in (before, after)]
    old, new = (document.paint(element) for document, element in zip((before, after), elements))
    assert old.get("id") not in after.by_id
    assert re.search(r"url\(#[^)]*\) .", " ".join(elements[0].attrib.values()))  # the fallback colour
    for attribute in ("gradientTransform", "type"):
        assert new.get(attribute) == old.get(attribute)
    # The corners of the whole mesh have not moved.
    nets = [document.net(element) for document, element in zip((before, after), elements)]
    corners = [net[np.ix_((0, -1), (0, -1))] for net in nets]
    assert abs(corners[0] - corners[1]).max() <= 1e-7 * abs(corners[0]).max()


@pytest.mark.parametrize("method, sample, painted", OBJECTS_BY)
@pytest.mark.full(all_but=1)
def test_what_is_told_is_found_again(simplified, method, sample, painted):
    result = simplified(method, sample).results[painted]
    before, after = (gradmesh.loads(data) for data in simplified(method, sample)[:2])
    frame = {"id": painted, "resolution": RUNS[method]["resolution"]}
    pictures = gradmesh.render(before, **frame), gradmesh.render(after, framed_as=before, **frame)
    near = 2e-4 if method == "plain" else 2e-5
    assert gradmesh.compare(*pictures) == pytest.approx(result.error, abs=near)
    if method == "lines":
        return
    # Without an error allowed nothing more is taken out, and what there is, is measured.
    options = {**OPTIONS, "epsilon": 0, "original": before, "preview": True}
    (again,) = gradmesh.simplify(after, painted, **options)
    assert not again.changed
    assert again.handles_before == again.handles_after == result.handles_after
    assert again.patches_before == result.patches_after
    assert again.error == pytest.approx(result.error, abs=1e-5)
    assert again.local_error == pytest.approx(result.local_error, abs=1e-3)


@pytest.mark.parametrize("sample", NAMES)
@pytest.mark.full(all_but=1)
def test_small_parts_keep_to_their_bound(simplified, sample):
    free = simplified("plain", sample).results
    bound = max(result.local_error for result in free.values()) / 2
    document, before = (gradmesh.load(SAMPLES / f"{sample}.svg") for _ in range(2))
    for result in gradmesh.simplify(document, max_local_error=bound, **OPTIONS):
        assert result.local_error <= bound and result.error <= EPSILON
        assert result.handles_after <= result.handles_before
        options = {**OPTIONS, "epsilon": 0, "original": before, "preview": True}
        (found,) = gradmesh.simplify(document, result.id, **options)
        assert found.local_error == pytest.approx(result.local_error, abs=1e-3)


@pytest.mark.parametrize("sample", NAMES)
@pytest.mark.full(all_but=1)
def test_a_second_run_only_takes_more_out(simplified, sample):
    document = gradmesh.loads(simplified("plain", sample).after)
    results = gradmesh.simplify(document, **OPTIONS)
    for result in results:
        first = simplified("plain", sample).results[result.id]
        assert (result.handles_before, result.patches_before) == (first.handles_after, first.patches_after)
        assert (result.handles_after < result.handles_before) == result.changed
        assert result.patches_after <= result.patches_before
        assert result.objects == 1 and result.error <= EPSILON
    if not any(result.changed for result in results):
        assert document.to_bytes() == simplified("plain", sample).after
    before, after = ET.fromstring(simplified("plain", sample).before), ET.fromstring(document.to_bytes())
    assert all_but_meshes(after) == all_but_meshes(before)


def test_nothing_changed_is_byte_for_byte_the_same():
    document = gradmesh.load(SAMPLES / "fruit.svg")
    (result,) = gradmesh.simplify(document, resolution=300, epsilon=0)
    assert (result.changed, result.stopped, result.objects) == (False, "nothing to merge", 1)
    assert (result.error, result.handles_after) == (0, result.handles_before)
    assert document.to_bytes() == (SAMPLES / "fruit.svg").read_bytes()


@pytest.mark.parametrize("sample", NAMES)
@pytest.mark.full(all_but=1)
def test_inkscape_paints_the_same(simplified, inkscape, tmp_path, sample):
    pictures = []
    for when, data in zip(("before", "after"), simplified("plain", sample)):
        svg = tmp_path / f"{when}.svg"
        svg.write_bytes(data)
        pictures.append(inkscape.export_png(svg, tmp_path / f"{when}.png", width=700))
    assert error(*pictures) <= EPSILON + PAGE
