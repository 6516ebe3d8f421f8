"""Documents of the kind .hemesh: whatever works for SVG documents works for them too."""

from dataclasses import astuple

import pytest

from built import SAMPLES
from elements import by_id, check_elements, elements
from hemesh_files import SHARED, grid, of_the_authors
from program import error, listed, printed, refused, simplified

import gradmesh

NUMBERS = {"apple": 80, "teardrop": 25, "global_duck": 230, "local-refinement": 16, "save_1": 12}


@pytest.fixture
def leaf(tmp_path):
    """A file of 5 x 4 patches that are exact parts of one, in a folder that is empty otherwise."""
    path = tmp_path / "leaf.hemesh"
    path.write_text(grid(5, 4))
    return path


def test_info_lists_counts_and_all_elements(leaf):
    assert printed("info", leaf) == "mesh: 128 handles, 20 patches, 1 object, 30 points, 0 T-junctions\n"
    said = listed(leaf)
    assert (said["file"], said["kind"]) == (str(leaf), "hemesh")
    (mesh,) = said["meshes"]
    assert (mesh["id"], mesh["role"], mesh["simplified"]) == ("mesh", None, False)
    assert (mesh["color_model"], mesh["patches"]) == ("bicubic", 20)
    found = mesh["elements"]
    check_elements(found)
    counts = {kind: len(members) for kind, members in found.items()}
    assert counts == {"points": 30, "handles": 98, "faces": 20, "halfedges": 80}
    assert len(found["handles"][0]["tangent"]) == 6
    assert gradmesh.info(gradmesh.load(leaf))["meshes"][0]["elements"] == found


def test_info_lists_t_junctions(tmp_path):
    out = tmp_path / "out.svg"
    printed("simplify", SAMPLES / "fruit.svg", "-o", out, "--method", "grid")
    found = elements(out)
    check_elements(found)
    parents = [edge for edge in found["halfedges"] if edge["children"]]
    stems = [point for point in found["points"] if point["stem"] is not None]
    assert parents and stems
    for parent in parents:
        children = [by_id(found["halfedges"])[child] for child in parent["children"]]
        assert len(children) % 2 == 1
        ends = [child["interval"] for child in children]
        assert ends[0][0] == 0 and ends[-1][1] == 1
        assert all(before[1] == after[0] for before, after in zip(ends, ends[1:]))
    assert {len(handle["tangent"]) for handle in found["handles"]} == {2}


def test_render(leaf, tmp_path):
    image, numpy = pytest.importorskip("PIL.Image"), pytest.importorskip("numpy")
    png = tmp_path / "leaf.png"
    printed("render", leaf, "-o", png, "--resolution", 300)
    picture = gradmesh.render(gradmesh.load(leaf), resolution=300)
    with image.open(png) as written:
        assert (numpy.array(written) == picture).all()
    # 2.2 x 1.05 units and 0.03 on every side.
    assert picture.shape == (int(300 * (1.05 + 0.06) / 2.26), 300, 3)
    assert picture[2, 2].tolist() == [255, 255, 255]
    colors = [picture[row, 150].astype(float) for row in (20, 120)]
    assert colors[0][0] < 40 and colors[1][0] > 200  # red grows downwards
    assert error(leaf, png) == 0 == error(png, leaf)


def test_inkscape_paints_no_such_colors(leaf, tmp_path):
    said = refused("render", leaf, "-o", tmp_path / "out.png", "--like-inkscape")
    assert str(leaf) in said and "gradmesh convert" in said


@pytest.mark.parametrize("method", ["grid", "gqe"])
def test_exact_parts_become_one_patch_again(leaf, tmp_path, method):
    out, before = tmp_path / "out.hemesh", leaf.read_bytes()
    (told,) = simplified(leaf, out, "--epsilon", 0.004, "--method", method)
    assert (told["id"], told["handles_before"], told["handles_after"]) == ("mesh", 128, 12)
    assert (told["patches_before"], told["patches_after"]) == (20, 1)
    assert out.read_text().startswith("HEMESH\n4 8 1 4\n")
    assert leaf.read_bytes() == before
    assert error(leaf, out) == pytest.approx(told["error"], abs=1e-6)


def test_python(leaf, tmp_path):
    document = gradmesh.load(leaf)
    assert document.ids == ["mesh"]
    assert [astuple(mesh) for mesh in document.meshes] == [("mesh", None, False, 128, 20, 1, False, None)]
    assert gradmesh.loads(leaf.read_text()).to_bytes() == leaf.read_bytes()
    (result,) = gradmesh.simplify(document, "mesh", epsilon=0.004)
    assert (result.id, result.patches_after) == ("mesh", 1)
    gradmesh.save(document, tmp_path / "out.hemesh")
    assert (tmp_path / "out.hemesh").read_bytes() == document.to_bytes()
    assert gradmesh.info(gradmesh.loads(document.to_bytes()))["meshes"] == (
        gradmesh.info(document)["meshes"]
    )


def test_nothing_to_merge_keeps_every_byte(tmp_path):
    path, out = tmp_path / "one.hemesh", tmp_path / "out.hemesh"
    path.write_text(grid(1, 1) + "\n  \n")
    assert "nothing to merge" in printed("simplify", path, "-o", out)
    assert out.read_bytes() == path.read_bytes()


def test_the_only_mesh_is_called_mesh(leaf, tmp_path):
    assert printed("render", leaf, "-o", tmp_path / "out.png", "--id", "mesh") == ""
    said = refused("simplify", leaf, "-o", tmp_path / "out.hemesh", "--id", "pear")
    assert str(leaf) in said and '"pear"' in said
    with pytest.raises(gradmesh.InputError, match='"pear"'):
        gradmesh.render(gradmesh.load(leaf), "pear")


def test_the_content_says_what_a_file_is_and_the_name_what_it_becomes(leaf, tmp_path):
    svg, hemesh, out = (tmp_path / name for name in ("leaf.svg", "fruit.hemesh", "out.svg"))
    svg.write_bytes(leaf.read_bytes())
    hemesh.write_bytes((SAMPLES / "fruit.svg").read_bytes())
    assert printed("info", svg) == printed("info", leaf)
    assert printed("info", hemesh).startswith("pear (fill)")
    with pytest.raises(gradmesh.InputError, match="gradmesh convert"):
        gradmesh.save(gradmesh.load(leaf), out)
    assert not out.exists()


@pytest.mark.parametrize(
    "text, words", [("", "HEMESH"), ("no mesh\n", "HEMESH"), ("HEMESH\n4 8", "line 2")]
)
def test_bad_files(tmp_path, text, words):
    path = tmp_path / "bad.hemesh"
    path.write_text(text)
    said = refused("info", path)
    assert str(path) in said and words in said
    assert refused("render", path, "-o", tmp_path / "out.png") == said
    assert refused("simplify", path, "-o", path) == said
    with pytest.raises(gradmesh.InputError, match=words):
        gradmesh.load(path)
    assert [file.name for file in tmp_path.iterdir()] == ["bad.hemesh"]


def test_colors_may_be_made_bilinear(leaf, tmp_path):
    out, bilinear = tmp_path / "out.hemesh", ("--color-model", "bilinear")
    said = refused("simplify", leaf, "-o", out, *bilinear, "--epsilon", 0.001)
    assert str(leaf) in said and "bilinear" in said and not out.exists()
    (told,) = simplified(leaf, out, *bilinear, "--epsilon", 0.1)
    assert (told["color_model"], told["patches_before"]) == ("bilinear", 20)
    assert 1 < told["patches_after"] < 20 and 0.001 < told["error"] <= 0.1
    assert error(leaf, out) == pytest.approx(told["error"], abs=1e-6)


@of_the_authors
@pytest.mark.parametrize("name", NUMBERS)
@pytest.mark.full(all_but=1)
def test_the_authors_meshes(tmp_path, name):
    path, out = SHARED / f"{name}.hemesh", tmp_path / "out.hemesh"
    assert f" handles, {NUMBERS[name]} patches, 1 object, " in printed("info", path)
    check_elements(elements(path))
    said = printed("simplify", path, "-o", out, "--resolution", 200, "--method", "motorcycle")
    check_elements(elements(out))
    left = len(elements(out)["faces"])
    assert said.startswith("mesh: ") and f" handles, {left} of {NUMBERS[name]} patches left" in said
    assert 0 < left < NUMBERS[name] or name == "save_1"  # which the authors have merged already
