"""Update after editing: blocks that a person has moved or recoloured fit together again."""

import pytest

np = pytest.importorskip("numpy")

import svg_meshes
from built import SAMPLES
from edited_blocks import group, update  # noqa: F401
from program import error, printed
from svg_meshes import GRADMESH, LABEL, SVG

import gradmesh

FRUIT = SAMPLES / "fruit.svg"
ROUNDING = 1e-6


@pytest.fixture(scope="module")
def simplified(tmp_path_factory):
    path = tmp_path_factory.mktemp("update") / "fruit.svg"
    document = gradmesh.load(FRUIT)
    gradmesh.simplify(document, method="motorcycle", visible_only=False)
    gradmesh.save(document, path)
    return path


@pytest.fixture
def edited(group):
    """The group with a corner of three blocks moved in one of them."""
    corner = group.shared_corner(3)
    group.move(group.owners(corner)[0], corner, 4 + 3j)
    return group


def label(group, patches):
    """What a label begins with: the handles are those that the mesh tool finds in the file."""
    (mesh,) = gradmesh.load(group.path).meshes
    return f"Gradient mesh: {mesh.handles} of 660 handles, {patches} of 132 patches"


def update_of(group, changed):
    """What is told of the only mesh, which is what the document has."""
    (mesh,) = gradmesh.load(group.path).meshes
    assert mesh.objects == len(group.paths())
    return gradmesh.Update(mesh.id, mesh.handles, mesh.patches, mesh.objects, changed)


def corners_near(group, place):
    """In how many blocks there is a corner at this place, to the digits that are written."""
    return sum((abs(net[::3, ::3] - place) < ROUNDING).any() for net in group.blocks.values())


def test_nothing_edited_changes_no_byte(group):
    before = group.path.read_bytes()
    result = update(group)
    assert result == update_of(group, False) and (result.id, result.patches) == ("pear", 64)
    assert group.path.read_bytes() == before


def test_a_point_moved_in_one_block_moves_in_all(group):
    corner = group.shared_corner(3)
    others = {p for p in group.corners() if p != corner}
    first = group.owners(corner)[1]
    group.move(first, corner, 4 + 3j)
    assert corners_near(group, corner) == 2 and corners_near(group, corner + 4 + 3j) == 1
    assert update(group) == update_of(group, True)
    assert corners_near(group, corner) == 0 and corners_near(group, corner + 4 + 3j) == 3
    # All that is not a T-junction of a curve from there is where it was.
    stayed = [p for p in others if corners_near(group, p)]
    assert len(stayed) > 0.9 * len(others)
    assert update(group).changed is False


def test_blocks_keep_their_ids(edited):
    """So what was selected stays selected."""
    nets = edited.blocks
    before = {block: edited.gradient(block).get("id") for block in nets}
    assert update(edited).changed
    assert {block: edited.gradient(block).get("id") for block in edited.blocks} == before
    assert len(before) > 10
    for block, net in nets.items():
        assert edited.blocks[block].shape == net.shape
        assert abs(edited.blocks[block] - net).max() <= 6


def test_without_memory_a_block_that_was_cut_or_removed_is_refused(group):
    second = group.paths()[1]
    face = int(second.get(GRADMESH + "face"))
    assert face > 1
    del group.node.attrib[GRADMESH + "written"]
    for number, sentence in ((face - 1, "more rows or columns"), (face + 1, "undo what removed it")):
        second.set(GRADMESH + "face", str(number))
        group.save()
        second = group.paths()[1]
        with pytest.raises(gradmesh.InputError, match=sentence):
            update(group)


def test_the_label_counts_from_the_first_mesh_and_the_memory_is_the_edited_one(edited):
    original = edited.node.get(GRADMESH + "original")
    update(edited)
    assert edited.node.get(LABEL) == label(edited, 64) + f", FLIP {error(FRUIT, edited.path):.4f}"
    assert edited.node.get(GRADMESH + "handles-before") == "660"
    assert edited.node.get(GRADMESH + "patches-before") == "132"
    assert edited.node.get(GRADMESH + "original") not in (None, original)
    document = gradmesh.load(edited.path)
    (result,) = gradmesh.simplify(document, method="random", epsilon=0.005)
    assert result.patches_before == 64 and 0 < result.error <= 0.005
    gradmesh.save(document, edited.path)
    edited.read()
    assert edited.node.get(LABEL).startswith(label(edited, result.patches_after))


@pytest.mark.parametrize("name", ["original", "handles-before"])
def test_the_label_says_nothing_that_the_group_has_not_remembered(edited, name):
    del edited.node.attrib[GRADMESH + name]
    edited.save()
    update(edited)
    if name == "original":
        assert edited.node.get(LABEL) == label(edited, 64)
    else:  # a group of an older gradmesh has not counted its handles
        assert edited.node.get(LABEL).startswith(label(edited, 64).replace(" of 660", ""))
    assert edited.node.get(GRADMESH + name) is None


def test_paths_grow_with_the_mesh(group):
    """Beyond its path a block would paint nothing."""
    corner = max(group.corners(), key=lambda p: p.real)
    for block in group.owners(corner):
        group.move(block, corner, 60)
    assert update(group).changed
    (block,) = [b for b in group.owners(corner + 60)][:1]
    numbers = svg_meshes.numbers(group.document.by_id[block].get("d"))
    assert max(numbers[::2]) > (corner + 60).real


def test_a_colour_changed_in_one_block_changes_in_all(group):
    # The first corner of a block, whose colour its first stop gives.
    block = next(
        name for name, net in group.blocks.items() if group.corners()[net[0, 0]] == 3
    )
    stop = next(group.gradient(block).iter(SVG + "stop"))
    before = stop.get("stop-color")
    count = group.path.read_text().count(before)
    stop.set("style", "stop-color:#00ff7f;stop-opacity:1")
    group.save()
    assert group.path.read_text().count("#00ff7f") == 1
    assert update(group).changed
    assert group.path.read_text().count("#00ff7f") == 3
    assert group.path.read_text().count(before) == count - 3


@pytest.mark.parametrize("where", ["path", "gradient"])
def test_a_block_moved_as_a_whole_takes_its_corners_along(group, where):
    block = min(group.blocks, key=lambda name: group.blocks[name].size)
    net = group.blocks[block]
    element = group.document.by_id[block] if where == "path" else group.gradient(block)
    element.set("transform" if where == "path" else "gradientTransform", "translate(6, 2)")
    group.save()
    free = [p for p in net[::3, ::3].ravel() if group.corners()[p] > 1]
    assert update(group).changed
    assert "translate(6" not in group.path.read_text()
    assert any(corners_near(group, p + 6 + 2j) > 1 for p in free)


def test_a_group_moved_as_a_whole_needs_nothing(group):
    group.node.set("transform", "rotate(12) scale(2)")
    group.save()
    assert not update(group).changed


def test_without_memory_an_edit_is_mended_too(group):
    corner = group.shared_corner(3)
    del group.node.attrib[GRADMESH + "written"]
    group.move(group.owners(corner)[-1], corner, 4 + 3j)
    assert update(group).changed
    assert corners_near(group, corner) + corners_near(group, corner + 4 + 3j) == 3
    assert update(group).changed is False


def test_simplifying_an_edited_group_measures_against_the_edited_mesh(group):
    corner = group.shared_corner(3)
    group.move(group.owners(corner)[0], corner, 9 + 9j)
    edited = gradmesh.load(group.path)
    picture = gradmesh.render(edited).astype(int)
    (result,) = gradmesh.simplify(edited, method="random", seed=2, epsilon=0.005)
    assert result.patches_after < 64 and result.error <= 0.005
    gradmesh.save(edited, group.path)
    group.read()
    assert group.node.get(LABEL).startswith(label(group, result.patches_after))
    # The very picture that it started from is what it remembers.
    again = gradmesh.load(group.path)
    (result,) = gradmesh.simplify(again, method="random", epsilon=0.005)
    assert result.error <= 0.005
    assert abs(gradmesh.render(again).astype(int) - picture).mean() < 1


def test_other_meshes_are_left_alone(simplified, tmp_path):
    document = gradmesh.load(SAMPLES / "two.svg")
    gradmesh.simplify(document, "cap", method="grid")
    assert [found.id for found in gradmesh.update(document)] == ["cap"]
    with pytest.raises(gradmesh.InputError, match="needs no update"):
        gradmesh.update(document, "stalk")
    with pytest.raises(gradmesh.InputError, match='"gone"'):
        gradmesh.update(document, ["gone"])
    with pytest.raises(gradmesh.InputError, match="in an SVG document"):
        gradmesh.update(gradmesh.convert(document, "hemesh", "stalk").document)


def test_on_the_command_line(edited, tmp_path):
    out, again = tmp_path / "out.svg", tmp_path / "again.svg"
    said = printed("update", edited.path, "-o", out)
    (mesh,) = gradmesh.load(out).meshes
    counts = f"pear: {mesh.handles} handles, 64 patches, {len(edited.paths())} objects"
    assert said == f"{counts}, updated\n"
    assert printed("update", out, "-o", again) == f"{counts}, not edited\n"
    assert again.read_bytes() == out.read_bytes()
