"""Update after Inkscape's mesh tool has cut rows and columns of blocks, or blocks were removed."""

import random

import pytest

np = pytest.importorskip("numpy")

from built import SAMPLES
from edited_blocks import Group, read_mesh, update
from svg_meshes import GRADMESH, SVG

import gradmesh

METHODS = {"fruit": ("motorcycle", "best"), "opacity": ("best",), "stroke": ("best",)}
KINDS = [(sample, method) for sample, methods in METHODS.items() for method in methods]


@pytest.fixture(scope="module", params=KINDS, ids=" ".join)
def simplified(request, tmp_path_factory):
    sample, method = request.param
    path = tmp_path_factory.mktemp("cut") / "mesh.svg"
    document = gradmesh.load(SAMPLES / f"{sample}.svg")
    gradmesh.simplify(document, method=method, epsilon=0.02, visible_only=False)
    gradmesh.save(document, path)
    return path


@pytest.fixture
def group(simplified, tmp_path):
    path = tmp_path / "mesh.svg"
    path.write_bytes(simplified.read_bytes())
    group = Group(path)
    group.sample = simplified
    return group


def in_face_order(group):
    return [
        path.get("id") for path in sorted(group.paths(), key=lambda p: int(p.get(GRADMESH + "face")))
    ]


def picture(group):
    """Painted in the frame of the sample, however the mesh has changed."""
    document = gradmesh.load(group.path)
    return gradmesh.render(document, framed_as=gradmesh.load(group.sample)).astype(int)


def expect_same_picture(before, after):
    difference = abs(before - after).max(axis=2)
    assert difference.mean() < 0.3
    # At the outline a pixel may fall to either side.
    assert (difference > 3).sum() <= 0.0001 * difference.size


def cut_at_random(group, chance):
    """Cuts a third of the blocks, the last among them; the number of patches that are new."""
    blocks, new = in_face_order(group), 0
    for block in blocks:
        if block != blocks[-1] and chance.random() > 0.3:
            continue
        mesh = read_mesh(group.gradient(block))
        before = mesh.rows * mesh.columns
        rows = [(chance.randrange(mesh.rows), chance.uniform(0.2, 0.8))]
        columns = [(chance.randrange(mesh.columns), chance.uniform(0.2, 0.8))]
        kind = chance.choice(("row", "column", "both"))
        group.cut(block, rows if kind != "column" else (), columns if kind != "row" else ())
        mesh = read_mesh(group.gradient(block))
        new += mesh.rows * mesh.columns - before
    return new


@pytest.mark.parametrize("seed", range(3))
def test_cuts_at_random_change_no_picture(group, seed):
    before, old = picture(group), in_face_order(group)
    patches = update(group).patches
    new = cut_at_random(group, random.Random(seed))
    result = update(group)
    assert result.changed and result.patches == patches + new
    expect_same_picture(before, picture(group))
    assert update(group).changed is False
    # Most blocks are those of before, which keep their ids.
    assert len(set(in_face_order(group)) & set(old)) >= 0.7 * len(old)
    assert len(group.paths()) <= len(old) + 2


def test_a_cut_block_whose_corner_was_moved_since(group):
    before = picture(group)
    block = in_face_order(group)[-1]
    group.cut(block, rows=[(0, 0.4)], columns=[(0, 0.6)])
    # The crossing of both lines is in no other block.
    place = group.blocks[block][3, 3]
    patches = [e for e in group.gradient(block).iter(SVG + "meshpatch")]
    assert len(patches) >= 4
    moved = 0.02 * abs(np.ptp(group.blocks[block].real) + 1j * np.ptp(group.blocks[block].imag))
    group.move(block, read_mesh(group.gradient(block)).points[3][3], moved)
    assert update(group).changed
    here = [abs(net[::3, ::3] - place - moved).min() for net in group.blocks.values()]
    assert min(here) < 1 and abs(picture(group) - before).mean() < 2
    assert update(group).changed is False


def test_a_removed_block_is_a_hole(group):
    before, blocks = picture(group), in_face_order(group)
    patches = update(group).patches
    smallest = min(blocks, key=lambda name: group.blocks[name].size)
    net = group.blocks[smallest]
    group.remove(smallest)
    result = update(group)
    assert result.changed and result.patches >= patches - (len(net) // 3) * (len(net[0]) // 3)
    after = picture(group)
    assert (abs(before - after).max(axis=2) > 3).any()
    assert update(group).changed is False
    # The rest can be simplified, merged and cut as any mesh.
    document = gradmesh.load(group.path)
    gradmesh.simplify(document, method="random", epsilon=0.005)
    gradmesh.save(document, group.path)
    assert abs(picture(group) - after).mean() < 2


def test_an_edited_group_is_read_as_it_is(group):
    """Also without Update, where blocks are chosen by their ids."""
    block = in_face_order(group)[0]
    group.cut(block, rows=[(0, 0.5)])
    document = gradmesh.load(group.path)
    patches = document.meshes[0].patches
    gradmesh.refine(document, in_face_order(group)[-1], row=1, column=1, direction="rows")
    assert document.meshes[0].patches == patches + 1


def scale_about(group, block, factor):
    """Scales a block as the selector does, by its path's transform."""
    center = group.blocks[block].mean()
    x, y = ((1 - factor) * part for part in (center.real, center.imag))
    matrix = f"matrix({factor} 0 0 {factor} {x!r} {y!r})"
    group.document.by_id[block].set("transform", matrix)
    group.save()


@pytest.mark.parametrize("cut_first", [True, False])
@pytest.mark.parametrize("factor", [0.7, 1.15])
def test_a_block_that_was_scaled_as_well_as_cut(group, factor, cut_first):
    block = in_face_order(group)[0]
    before = update(group).patches
    old = group.blocks[block].shape
    if not cut_first:
        scale_about(group, block, factor)
    group.cut(block, rows=[(0, 0.4)], columns=[(0, 0.6)])
    if cut_first:
        scale_about(group, block, factor)
    net = group.blocks[block]
    rows, columns = ((size - 1) // 3 for size in net.shape)
    new = rows * columns - (old[0] - 1) // 3 * ((old[1] - 1) // 3)
    result = update(group)
    assert result.changed and result.patches == before + new
    # The crossing of both lines is in no other block.
    assert min(abs(other[::3, ::3] - net[3, 3]).min() for other in group.blocks.values()) < 1e-3
    assert update(group).changed is False


def test_what_cannot_be_told_is_refused(group):
    big = max(group.blocks, key=lambda name: group.blocks[name].shape[0])
    rows = [e for e in group.gradient(big).iter(SVG + "meshrow")]
    assert len(rows) > 1
    group.gradient(big).remove(rows[-1])
    group.save()
    with pytest.raises(gradmesh.InputError, match="fewer rows or columns than before") as refused:
        update(group)
    assert f'path "{big}"' in str(refused.value)


def test_what_may_be_either_line_is_refused(group):
    block = max(group.blocks, key=lambda name: group.blocks[name].shape[0])
    group.cut(block, rows=[(0, 0.8)])
    points = read_mesh(group.gradient(block)).points
    for new, old in zip(points[3][::3], points[6][::3]):
        group.move(block, old, old - new)
    with pytest.raises(gradmesh.InputError, match="cannot be told") as refused:
        update(group)
    assert f'"{block}": which of its rows or columns are new' in str(refused.value)
