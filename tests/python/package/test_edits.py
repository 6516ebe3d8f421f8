"""Edits of single patches: merging chosen blocks, refining in one place."""

import itertools
import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest

from built import SAMPLES
from hemesh_files import SHARED, grid

import gradmesh

FACE = "{urn:gradmesh}face"
LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
SMALL = {"resolution": 200}
#: A group of blocks, whatever is simplest.
BLOCKS = {"method": "best", **SMALL}


@pytest.fixture
def simplified():
    """The fruit, with few patches left. What its outline hides counts too, as it is in the pictures
    that are compared here."""
    document = gradmesh.loads((SAMPLES / "fruit.svg").read_bytes())
    gradmesh.simplify(document, epsilon=0.02, visible_only=False, **BLOCKS)
    return document


def elements(document):
    root = ET.fromstring(document.to_bytes())
    return {element.get("id"): element for element in root.iter() if element.get("id")}


def blocks(document, mesh="pear"):
    """Ids of the blocks of a mesh and the numbers of their first patches."""
    return {e.get("id"): int(e.get(FACE)) for e in elements(document)[mesh] if e.get(FACE)}


def mergeable(document):
    """Two blocks that can become one patch, and two that cannot."""
    pair, others = None, None
    names = list(blocks(document))
    before = document.to_bytes()
    for first in names:
        for second in names:
            if first == second or (pair and others):
                continue
            trial = gradmesh.loads(before)
            try:
                gradmesh.merge(trial, [first, second], **SMALL)
                pair = pair or (first, second)
            except gradmesh.InputError as error:
                others = others or (first, second, str(error))
        if pair and others:
            break
    return pair, others


def counts(edit, when):
    return getattr(edit, f"handles_{when}"), getattr(edit, f"patches_{when}")


def expect_counted(edit, document):
    """What is told is what the document has."""
    (mesh,) = document.meshes
    assert counts(edit, "after") == (mesh.handles, mesh.patches)
    assert edit.objects == mesh.objects


def test_blocks_become_one_patch(simplified):
    pair, _ = mergeable(simplified)
    assert pair, "no two blocks of the sample can be merged"
    before = simplified.meshes[0]
    edit = gradmesh.merge(simplified, pair, **SMALL)
    assert edit.id == "pear" and counts(edit, "before") == (before.handles, before.patches)
    assert edit.patches_after < before.patches
    expect_counted(edit, simplified)
    label = elements(simplified)["pear"].get(LABEL)
    assert label == (
        f"Gradient mesh: {simplified.meshes[0].handles} of 660 handles, {edit.patches_after} of 132 patches, "
        f"FLIP {edit.error:.4f}"
    )
    # The error is that of what is written, against the mesh before it was simplified.
    original = gradmesh.load(SAMPLES / "fruit.svg")
    same = np.array_equal(gradmesh.render(original, **SMALL), gradmesh.render(simplified, **SMALL))
    assert not same and 0 < edit.error < 0.2


def tensors(document, block):
    """How many patches of a block have a tensor."""
    gradient = re.search(r"url\(#([^)]*)\)", elements(document)[block].get("style")).group(1)
    return ET.tostring(elements(document)[gradient]).count(b"tensor=")


def test_what_is_merged_stays_plain():
    document = gradmesh.load(SAMPLES / "fruit.svg")
    gradmesh.simplify(document, method="best", count="handles", **SMALL)
    plain = [block for block in blocks(document) if not tensors(document, block)]
    merges = 0
    for first, second in itertools.combinations(plain, 2):
        merged = gradmesh.loads(document.to_bytes())
        try:
            gradmesh.merge(merged, [first, second], **SMALL)
        except gradmesh.InputError:
            continue
        merges += 1
        assert merged.to_bytes().count(b"tensor=") == document.to_bytes().count(b"tensor=")
    assert merges > 0


def test_what_cannot_be_merged_is_told_why(simplified):
    _, (first, second, said) = mergeable(simplified)
    before = simplified.to_bytes()
    with pytest.raises(gradmesh.InputError) as refused:
        gradmesh.merge(simplified, [first, second], **SMALL)
    assert str(refused.value) == said
    assert re.fullmatch(r"document: pear: these patches cannot become one, because .+\.", said)
    assert simplified.to_bytes() == before


def test_blocks_of_two_meshes():
    document = gradmesh.load(SAMPLES / "two.svg")
    gradmesh.simplify(document, method="best", epsilon=0.02, resolution=100)
    chosen = [next(iter(blocks(document, mesh))) for mesh in ("cap", "stalk")]
    with pytest.raises(gradmesh.InputError, match="of different meshes"):
        gradmesh.merge(document, chosen)


def look_the_same(a, b):
    """Whether pictures differ by one level at most, from colours rounded at new corners. A pixel
    on the outline of the mesh may be painted in one alone."""
    first, second = (gradmesh.render(document, framed_as=a).astype(int) for document in (a, b))
    painted = (first < 255).any(axis=2) & (second < 255).any(axis=2)
    missed = ((first < 255).any(axis=2) != (second < 255).any(axis=2)).mean()
    return np.abs(first - second)[painted].max() <= 1 and missed < 1e-3


@pytest.mark.parametrize("whole", [False, True])
@pytest.mark.parametrize("direction", ["rows", "columns", "both"])
def test_refining_a_block_changes_nothing_that_is_seen(simplified, direction, whole):
    before = gradmesh.loads(simplified.to_bytes())
    for name in list(blocks(simplified))[:3]:
        refined = gradmesh.loads(simplified.to_bytes())
        edit = gradmesh.refine(refined, name, direction=direction, place=0.4, whole=whole)
        assert edit.patches_after == refined.meshes[0].patches > edit.patches_before
        assert look_the_same(before, refined)


def test_refining_here_leaves_the_other_patches_alone(simplified):
    name = list(blocks(simplified))[0]
    local, whole = (gradmesh.loads(simplified.to_bytes()) for _ in range(2))
    here = gradmesh.refine(local, name, row=1, column=1)
    assert here.patches_after == here.patches_before + 3
    across = gradmesh.refine(whole, name, row=1, column=1, whole=True)
    assert across.patches_after > here.patches_after


@pytest.mark.skipif(not SHARED.exists(), reason="the authors' meshes are not here")
@pytest.mark.parametrize("direction", ["rows", "columns"])
def test_refining_beside_a_recoloured_junction(direction):
    demo = gradmesh.load(SHARED / "junction-recolor-demo.hemesh")
    before = gradmesh.convert(demo, "svg", subdivide=1).document
    chosen = blocks(before, "mesh")
    assert len(chosen) > 1
    for name in chosen:
        refined = gradmesh.loads(before.to_bytes())
        gradmesh.refine(refined, name, direction=direction, place=0.4)
        assert look_the_same(before, refined)


def test_refining_an_object(tmp_path):
    document = gradmesh.load(SAMPLES / "fruit.svg")
    edit = gradmesh.refine(document, "pear", row=2, column=3, direction="columns")
    assert counts(edit, "before") == (660, 132) and edit.patches_after == 133
    expect_counted(edit, document)
    assert look_the_same(gradmesh.load(SAMPLES / "fruit.svg"), document)


def test_a_refined_mesh_merges_back(simplified):
    name = list(blocks(simplified))[0]
    patches = simplified.meshes[0].patches
    gradmesh.refine(simplified, name, row=1, column=1, place=0.3)
    (result,) = gradmesh.simplify(simplified, epsilon=0.02, **SMALL)
    assert result.patches_after <= patches + 3


@pytest.mark.parametrize(
    "edit, chosen, options, words",
    [
        (gradmesh.merge, [], {}, "no blocks are chosen"),
        (gradmesh.merge, ["pear"], {}, "no block of a simplified mesh"),
        (gradmesh.merge, ["gone"], {}, "no object with the id"),
        (gradmesh.refine, "pear", {}, "made of blocks; choose one of them"),
        (gradmesh.refine, None, {"place": 0}, "place of a split"),
        (gradmesh.refine, None, {"place": 1}, "place of a split"),
        (gradmesh.refine, None, {"direction": "up"}, "'up'"),
        (gradmesh.refine, None, {"row": 99}, "no row 99"),
        (gradmesh.refine, None, {"column": -1}, "no column -1"),
        (gradmesh.refine, None, {"resolution": 3}, "resolution"),
    ],
)
def test_what_cannot_be_edited_is_left(simplified, edit, chosen, options, words):
    before = simplified.to_bytes()
    with pytest.raises(ValueError, match=words) as refused:
        edit(simplified, list(blocks(simplified))[0] if chosen is None else chosen, **options)
    assert options or isinstance(refused.value, gradmesh.InputError)
    assert simplified.to_bytes() == before


def test_hemesh_files_have_no_blocks(tmp_path):
    document = gradmesh.loads(grid(2, 2), "grid.hemesh")
    for edit in (lambda: gradmesh.merge(document, ["a"]), lambda: gradmesh.refine(document, "mesh")):
        with pytest.raises(gradmesh.InputError, match="SVG documents only"):
            edit()


SVG = "{http://www.w3.org/2000/svg}"


@pytest.mark.parametrize("sample", ["fruit", "transformed", "stroke", "two", "face", "opacity"])
def test_one_mesh_again(sample):
    """Simplified and made one mesh: an ordinary object, that looks like the simplified one."""
    file = SAMPLES / f"{sample}.svg"
    original, document = gradmesh.load(file), gradmesh.load(file)
    gradmesh.simplify(document, epsilon=0.02, **BLOCKS)
    edits = gradmesh.to_one_mesh(document, **SMALL)
    was = elements(original)
    now = elements(document)
    for mesh, edit in zip(document.meshes, edits):
        assert edit.id == mesh.id and edit.patches_after == mesh.patches >= edit.patches_before
        assert (edit.handles_after, edit.objects) == (mesh.handles, mesh.objects) == (mesh.handles, 1)
        assert not mesh.simplified
        assert now[mesh.id].tag == was[mesh.id].tag
        assert now[mesh.id].get("d") == was[mesh.id].get("d")
        assert now[mesh.id].get("transform") == was[mesh.id].get("transform")
        assert edit.error < 0.01
    # What only the groups needed is gone.
    left = [e.tag for e in ET.fromstring(document.to_bytes()).iter()]
    there = [e.tag for e in ET.fromstring(original.to_bytes()).iter()]
    assert left.count(SVG + "meshgradient") == len(edits)
    for tag in ("clipPath", "mask", "g", "path"):
        assert left.count(SVG + tag) == there.count(SVG + tag), tag


STYLED = """<svg xmlns="http://www.w3.org/2000/svg" width="300" height="300">
<style>.soft {{ opacity: 0.8 }}</style>
<defs>{gradient}</defs>
<rect id="box" class="soft" x="10" y="10" width="200" height="200" rx="9" transform="rotate(3)"
  style="fill:url(#m) #abc;fill-opacity:0.5;fill-rule:evenodd;{style}"><title>A box</title></rect>
</svg>"""


@pytest.mark.parametrize("style", ["stroke:none", "stroke:#102030;stroke-width:3"])
def test_styles_come_back(style):
    fruit = (SAMPLES / "fruit.svg").read_text()
    gradient = re.search(r"<meshgradient.*?</meshgradient>", fruit, re.S).group(0)
    gradient = gradient.replace("pear-mesh", "m")
    document = gradmesh.loads(STYLED.format(gradient=gradient, style=style))
    gradmesh.simplify(document, epsilon=0.02, **BLOCKS)
    assert elements(document)["box"].tag == SVG + "g"
    gradmesh.to_one_mesh(document)
    box = elements(document)["box"]
    assert box.tag == SVG + "rect" and box.get("rx") == "9" and box.get("transform") == "rotate(3)"
    declared = dict(part.split(":", 1) for part in box.get("style").split(";"))
    assert re.fullmatch(r"url\(#.+\) #abc", declared["fill"])
    assert [child.text for child in box] == ["A box"]
    if style == "stroke:none":
        assert float(declared["opacity"]) == pytest.approx(0.4)
    else:
        assert float(declared["opacity"]) == pytest.approx(0.8)
        assert float(declared["fill-opacity"]) == pytest.approx(0.5)
        assert declared["stroke"] == "#102030" and declared["stroke-width"] == "3"


def test_a_mesh_that_is_not_simplified_is_none_of_its_business():
    document = gradmesh.load(SAMPLES / "fruit.svg")
    with pytest.raises(gradmesh.InputError, match="only simplified meshes"):
        gradmesh.to_one_mesh(document)


def test_a_fill_and_a_stroke_of_blocks_are_left_as_they_are():
    fruit = (SAMPLES / "fruit.svg").read_text()
    gradient = re.search(r"<meshgradient.*?</meshgradient>", fruit, re.S).group(0)
    gradient = gradient.replace("pear-mesh", "m")
    style = "stroke:url(#m);stroke-width:9"
    document = gradmesh.loads(STYLED.format(gradient=gradient, style=style))
    gradmesh.simplify(document, epsilon=0.02, **BLOCKS)
    assert [mesh.simplified for mesh in document.meshes] == [True, True]
    before = document.to_bytes()
    with pytest.raises(gradmesh.InputError, match="the fill and the stroke"):
        gradmesh.to_one_mesh(document)
    assert document.to_bytes() == before


def test_what_was_forgotten_stays_forgotten():
    document = gradmesh.load(SAMPLES / "fruit.svg")
    gradmesh.simplify(document, epsilon=0.02, remember_original=False, **BLOCKS)
    gradmesh.refine(document, list(blocks(document))[0], row=1, column=1)
    assert elements(document)["pear"].get("{urn:gradmesh}original") is None
