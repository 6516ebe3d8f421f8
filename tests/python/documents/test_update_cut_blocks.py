"""Update after Inkscape's mesh tool has cut rows and columns of blocks, or blocks were removed."""

import random

import pytest

np = pytest.importorskip("numpy")

from built import SAMPLES
from edited_blocks import group, read_mesh, update  # noqa: F401
from svg_meshes import SVG

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


def picture(group, simplified):
    """Painted in the frame of the sample, however the mesh has changed."""
    document = gradmesh.load(group.path)
    return gradmesh.render(document, framed_as=gradmesh.load(simplified)).astype(int)


def cut_at_random(group, chance):
    """Cuts a third of the blocks, the last among them; the number of patches that are new."""
    blocks, new = group.in_face_order(), 0
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
@pytest.mark.full(all_but=1)
def test_cuts_at_random_change_no_picture(group, simplified, seed):
    before, old = picture(group, simplified), group.in_face_order()
    patches = update(group).patches
    new = cut_at_random(group, random.Random(seed))
    result = update(group)
    assert result.changed and result.patches == patches + new
    difference = abs(before - picture(group, simplified)).max(axis=2)
    assert difference.mean() < 0.3
    # At the outline a pixel may fall to either side.
    assert (difference > 3).sum() <= 0.0001 * difference.size
    assert update(group).changed is False
    # Most blocks are those of before, which keep their ids.
    assert len(set(group.in_face_order()) & set(old)) >= 0.7 * len(old)
    assert len(group.paths()) <= len(old) + 2


@pytest.mark.full(all_but=1)
def test_a_cut_block_whose_corner_was_moved_since(group, simplified):
    before = picture(group, simplified)
    block = group.in_face_order()[-1]
    group.cut(block, rows=[(0, 0.4)], columns=[(0, 0.6)])
    # The crossing of both lines is in no other block.
    place = group.blocks[block][3, 3]
    patches = [e for e in group.gradient(block).iter(SVG + "meshpatch")]
    assert len(patches) >= 4
    moved = 0.02 * abs(np.ptp(group.blocks[block].real) + 1j * np.ptp(group.blocks[block].imag))
    group.move(block, read_mesh(group.gradient(block)).points[3][3], moved)
    assert update(group).changed
    here = [abs(net[::3, ::3] - place - moved).min() for net in group.blocks.values()]
    assert min(here) < 1 and abs(picture(group, simplified) - before).mean() < 2
    assert update(group).changed is False


@pytest.mark.full(all_but=1)
def test_a_removed_block_is_a_hole(group, simplified):
    before, blocks = picture(group, simplified), group.in_face_order()
    patches = update(group).patches
    smallest = min(blocks, key=lambda name: group.blocks[name].size)
    net = group.blocks[smallest]
    group.remove(smallest)
    result = update(group)
    assert result.changed and result.patches >= patches - (len(net) // 3) * (len(net[0]) // 3)
    after = picture(group, simplified)
    assert (abs(before - after).max(axis=2) > 3).any()
    assert update(group).changed is False
    # The rest can be simplified, merged and cut as any mesh.
    document = gradmesh.load(group.path)
    gradmesh.simplify(document, method="random", epsilon=0.005)
    gradmesh.save(document, group.path)
    assert abs(picture(group, simplified) - after).mean() < 2


@pytest.mark.full(all_but=1)
def test_an_edited_group_is_read_as_it_is(group):
    """Also without Update, where blocks are chosen by their ids."""
    block = group.in_face_order()[0]
    group.cut(block, rows=[(0, 0.5)])
    document = gradmesh.load(group.path)
    patches = document.meshes[0].patches
    gradmesh.refine(document, group.in_face_order()[-1], row=1, column=1, direction="rows")
    assert document.meshes[0].patches == patches + 1


def scale_about(group, block, factor):
    """Scales a block as the selector does, by its path's transform."""
    center = group.blocks[block].mean()
    x, y = ((1 - factor) * part for part in (center.real, center.imag))
    matrix = f"matrix({factor} 0 0 {factor} {float(x)!r} {float(y)!r})"
    group.document.by_id[block].set("transform", matrix)
    group.save()


@pytest.mark.parametrize("cut_first", [True, False])
@pytest.mark.parametrize("factor", [0.7, 1.15])
@pytest.mark.full(all_but=1)
def test_a_block_that_was_scaled_as_well_as_cut(group, factor, cut_first):
    block = group.in_face_order()[0]
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


@pytest.mark.full(all_but=1)
def test_a_block_that_has_lost_a_row_is_refused(group):
    big = max(group.blocks, key=lambda name: group.blocks[name].shape[0])
    rows = [e for e in group.gradient(big).iter(SVG + "meshrow")]
    assert len(rows) > 1
    group.gradient(big).remove(rows[-1])
    group.save()
    with pytest.raises(gradmesh.InputError, match=f'path "{big}".* fewer rows or columns than before'):
        update(group)


@pytest.mark.full(all_but=1)
def test_what_may_be_either_line_is_refused(group):
    block = max(group.blocks, key=lambda name: group.blocks[name].shape[0])
    group.cut(block, rows=[(0, 0.8)])
    points = read_mesh(group.gradient(block)).points
    for new, old in zip(points[3][::3], points[6][::3]):
        group.move(block, old, old - new)
    sentence = f'"{block}": gradmesh cannot tell which of its rows or columns are new'
    with pytest.raises(gradmesh.InputError, match=sentence):
        update(group)
