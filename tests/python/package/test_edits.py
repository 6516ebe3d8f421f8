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
SVG = "{http://www.w3.org/2000/svg}"
LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
SMALL = {"resolution": 200}
#: A group of blocks, whatever is simplest.
BLOCKS = {"method": "best", **SMALL}


@pytest.fixture(scope="module")
def written():
    """The fruit, with few patches left. What its outline hides counts too, as it is in the pictures
    that are compared here."""
    document = gradmesh.loads((SAMPLES / "fruit.svg").read_bytes())
    gradmesh.simplify(document, epsilon=0.02, visible_only=False, **BLOCKS)
    return document.to_bytes()


@pytest.fixture
def simplified(written):
    return gradmesh.loads(written)


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


@pytest.mark.module_only
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
    assert re.fullmatch(r'document: group "pear": these patches cannot become one, because .+\.', said)
    assert simplified.to_bytes() == before


@pytest.mark.module_only
@pytest.mark.full
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


@pytest.mark.module_only
@pytest.mark.parametrize("whole", [False, True])
@pytest.mark.parametrize("direction", ["rows", "columns", "both"])
@pytest.mark.full(all_but=1)
def test_refining_a_block_changes_nothing_that_is_seen(simplified, direction, whole):
    before = gradmesh.loads(simplified.to_bytes())
    for name in list(blocks(simplified))[:3]:
        refined = gradmesh.loads(simplified.to_bytes())
        edit = gradmesh.refine(refined, name, direction=direction, place=0.4, whole=whole)
        assert edit.patches_after == refined.meshes[0].patches > edit.patches_before
        assert look_the_same(before, refined)


@pytest.mark.module_only
def test_refining_here_leaves_the_other_patches_alone(simplified):
    name = list(blocks(simplified))[0]
    local, whole = (gradmesh.loads(simplified.to_bytes()) for _ in range(2))
    here = gradmesh.refine(local, name, row=1, column=1)
    assert here.patches_after == here.patches_before + 3
    across = gradmesh.refine(whole, name, row=1, column=1, whole=True)
    assert across.patches_after > here.patches_after


@pytest.mark.module_only
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


@pytest.mark.module_only
def test_a_refined_mesh_merges_back(simplified):
    name = list(blocks(simplified))[0]
    patches = simplified.meshes[0].patches
    gradmesh.refine(simplified, name, row=1, column=1, place=0.3)
    (result,) = gradmesh.simplify(simplified, epsilon=0.02, **SMALL)
    assert result.patches_after <= patches + 3


@pytest.mark.parametrize(
    "edit, chosen, options, words",
    [
        (gradmesh.merge, [], {}, "no patches are chosen"),
        (gradmesh.merge, ["pear"], {}, "made of blocks; choose one of them"),
        (gradmesh.merge, None, {"rows": 99}, "no row 99"),
        (gradmesh.merge, None, {"rows": (2, 1)}, "from the first to the last"),
        (gradmesh.merge, None, {"rows": (1, 2, 3)}, "rows must be"),
        (gradmesh.merge, "pear", {"patches": [0], "rows": 1}, "by numbers, or by rows"),
        (gradmesh.merge, "pear", {"patches": [0, 999]}, "no patch 999"),
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


def test_a_part_of_a_block_becomes_one_patch(simplified):
    """Of the block with the most patches a column or a row."""
    name, shape = max(shapes(simplified).items(), key=lambda item: item[1][0] * item[1][1])
    part = {"columns": 1} if shape[0] > 1 else {"rows": (1, 1)}
    edit = gradmesh.merge(simplified, name, **part, **SMALL)
    assert edit.patches_after == edit.patches_before - (shape[0] if shape[0] > 1 else shape[1]) + 1
    expect_counted(edit, simplified)


def shapes(document):
    """How many rows and columns each block has."""
    found = elements(document)
    result = {}
    for block in blocks(document):
        gradient = found[re.search(r"url\(#([^)]*)\)", found[block].get("style")).group(1)]
        rows = [row for row in gradient if row.tag == SVG + "meshrow"]
        result[block] = len(rows), len(rows[0])
    return result


def test_rows_are_those_of_one_block(simplified):
    before = simplified.to_bytes()
    with pytest.raises(gradmesh.InputError, match="those of one block; choose one"):
        gradmesh.merge(simplified, list(blocks(simplified))[:2], rows=1)
    assert simplified.to_bytes() == before


def test_patches_of_an_object_are_merged_by_rows_and_columns():
    document = gradmesh.load(SAMPLES / "fruit.svg")
    edit = gradmesh.merge(document, "pear", rows=(2, 3), columns=4, **SMALL)
    assert edit.patches_after == 131 and edit.objects > 1
    expect_counted(edit, document)


@pytest.mark.parametrize("seed", range(4))
def test_a_hemesh_file_is_refined_recoloured_and_merged(seed):
    """Random edits of single patches and points; the file can be read, and what was one is one again."""
    random = np.random.default_rng(seed)
    document = gradmesh.loads(grid(2, 2), "grid.hemesh")

    def some(what):
        return int(random.integers(gradmesh.info(document)["meshes"][0][what]))

    edits = [
        lambda: gradmesh.refine(document, patches=[some("patches")], **SMALL),
        lambda: gradmesh.recolor(document, some("points"), "#00f", **SMALL),
        lambda: gradmesh.join_colors(document, some("points"), **SMALL),
    ]
    for which in random.integers(len(edits), size=8):
        edit = edits[which]()
        expect_counted(edit, document)
        read = gradmesh.loads(document.to_bytes(), "grid.hemesh")
        assert read.to_bytes() == document.to_bytes()
        assert np.array_equal(gradmesh.render(read, **SMALL), gradmesh.render(document, **SMALL))
    with_junctions = document.to_bytes()
    if document.meshes[0].patches > 4:
        (edit,) = gradmesh.to_one_mesh(document, **SMALL)
        assert edit.error < 0.01 and gradmesh.info(document)["meshes"][0]["t_junctions"] == 0
        assert document.to_bytes() != with_junctions


def sharp_points(document):
    """How many points have patches with several colours around them."""
    (mesh,) = gradmesh.info(document)["meshes"]
    colors = {}
    for h in mesh["elements"]["halfedges"]:
        if h["face"] is not None:
            colors.setdefault(h["origin"], set()).add(tuple(round(255 * c) for c in h["color"]))
    return sum(len(found) > 1 for found in colors.values())


def test_sharp_colors_of_a_mesh_gradient_are_written_as_blocks_and_read_back():
    document = gradmesh.load(SAMPLES / "fruit.svg")
    edit = gradmesh.recolor(document, 60, "#102030", patches=[43, 44], **SMALL)
    assert edit.objects > 1 and document.meshes[0].simplified and sharp_points(document) == 1
    read = gradmesh.loads(document.to_bytes())
    assert gradmesh.info(read)["meshes"][0]["elements"] == gradmesh.info(document)["meshes"][0]["elements"]
    assert np.array_equal(gradmesh.render(read, **SMALL), gradmesh.render(document, **SMALL))
    with pytest.raises(gradmesh.InputError, match="several colours at one point"):
        gradmesh.to_one_mesh(read)


def test_a_recoloured_mesh_is_the_original_of_later_runs(simplified):
    assert gradmesh.info(simplified)["meshes"][0]["remembers"]
    edit = gradmesh.recolor(simplified, 20, "#000", **SMALL)
    assert edit.error > 0.02 and not gradmesh.info(simplified)["meshes"][0]["remembers"]
    black = gradmesh.render(simplified, **SMALL)
    (result,) = gradmesh.simplify(simplified, epsilon=0.01, **BLOCKS)
    assert result.error <= 0.01
    assert gradmesh.compare(black, gradmesh.render(simplified, **SMALL)) < 0.02


def test_one_color_for_all_patches_leaves_one_mesh_gradient():
    document = gradmesh.load(SAMPLES / "fruit.svg")
    edit = gradmesh.recolor(document, 60, "#102030", **SMALL)
    assert edit.objects == 1 and not document.meshes[0].simplified and sharp_points(document) == 0
    assert document.to_bytes().count(b"#102030") == 1


@pytest.mark.parametrize("color", ["taste", "", "#12", "rgba(1, 2, 3, .5)"])
def test_what_is_no_color_is_a_value_error(color):
    document = gradmesh.loads(grid(2, 2), "grid.hemesh")
    with pytest.raises(ValueError, match="is no colour"):
        gradmesh.recolor(document, 0, color)


@pytest.mark.module_only
@pytest.mark.parametrize("sample", ["fruit", "transformed", "stroke", "two", "face", "opacity"])
@pytest.mark.full(all_but=1)
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
@pytest.mark.full(all_but=1)
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


@pytest.mark.module_only
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


@pytest.mark.module_only
def test_what_was_forgotten_stays_forgotten():
    document = gradmesh.load(SAMPLES / "fruit.svg")
    gradmesh.simplify(document, epsilon=0.02, remember_original=False, **BLOCKS)
    gradmesh.refine(document, list(blocks(document))[0], row=1, column=1)
    assert elements(document)["pear"].get("{urn:gradmesh}original") is None
