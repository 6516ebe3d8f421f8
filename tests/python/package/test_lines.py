"""The method lines in documents, and smooth meshes, of which it takes whole lines."""

import re
import xml.etree.ElementTree as ET

import pytest

from built import SAMPLES
from in_inkscape import inkscape  # noqa: F401
from program import error, meshes, printed, refused, simplified as reported

import gradmesh

EPSILON = 0.02
SMALL = ("--resolution", 300)
VASE = SAMPLES / "smooth.svg"

pytestmark = pytest.mark.module_only


@pytest.fixture(scope="module")
def simplified(tmp_path_factory):
    """Samples with lines taken out, and what was told of each object."""
    folder = tmp_path_factory.mktemp("lines")
    files, told = {}, {}
    for sample in ("fruit", "smooth", "transformed"):
        files[sample] = folder / f"{sample}.svg"
        options = ("--method", "lines", "--whole-mesh", "--epsilon", EPSILON, *SMALL)
        found = reported(SAMPLES / f"{sample}.svg", files[sample], *options)
        told |= {mesh["id"]: mesh for mesh in found}
    return files, told


def test_from_python_as_from_the_command_line(simplified):
    files, told = simplified
    document = gradmesh.load(SAMPLES / "fruit.svg")
    assert [mesh.smooth for mesh in document.meshes] == [False]
    (result,) = gradmesh.simplify(document, method="lines", epsilon=EPSILON, resolution=300, visible_only=False)
    assert (result.method, result.error) == ("lines", told["pear"]["error"])
    assert document.to_bytes() == files["fruit"].read_bytes()
    (mesh,) = document.meshes
    assert not mesh.simplified and mesh.patches == result.patches_after


def test_again_it_starts_from_what_is_there(simplified, tmp_path):
    out = tmp_path / "out.svg"
    printed("simplify", simplified[0]["fruit"], "-o", out, "--method", "lines", "--epsilon", EPSILON, *SMALL)
    (pear,) = gradmesh.load(out).meshes
    assert pear.patches <= simplified[1]["pear"]["patches_after"]


def test_a_group_of_blocks_that_is_one_rectangle_stays_a_group(tmp_path):
    group, out = tmp_path / "group.svg", tmp_path / "out.svg"
    # Everything merged: one block.
    printed("simplify", SAMPLES / "tensor.svg", "-o", group, "--method", "grid", "--epsilon", 1)
    (silk,) = gradmesh.load(group).meshes
    assert silk.simplified and silk.patches == 1
    printed("simplify", group, "-o", out, "--method", "lines", "--epsilon", 0.02)
    assert out.read_bytes() == group.read_bytes()


def test_a_mesh_with_T_junctions_is_refused(tmp_path):
    group, out = tmp_path / "group.svg", tmp_path / "out.svg"
    printed("simplify", SAMPLES / "fruit.svg", "-o", group, "--method", "best", "--resolution", 100)
    said = refused("simplify", group, "-o", out, "--method", "lines")
    assert str(group) in said and "pear" in said and "one rectangle of patches" in said
    assert not out.exists()


# --- smooth meshes, type="bicubic" ---


def test_a_smooth_mesh_loses_lines_whatever_method_is_asked_for(tmp_path, simplified):
    out = tmp_path / "out.svg"
    for method in ("gqe", "motorcycle", "random"):
        (told,) = reported(VASE, out, "--method", method, "--epsilon", EPSILON, *SMALL)
        assert told["method"] == "lines"
        assert out.read_bytes() == simplified[0]["smooth"].read_bytes()


def test_what_needs_single_patches_says_that_it_cannot(tmp_path):
    out = tmp_path / "out"
    for command, *options in (
        ["simplify", "--method", "manual", "--edges", 5],
        ["analyze"],
        ["draw", "--show", "errors"],
        ["draw", "--show", "motorcycle"],
        ["draw", "--show", "regions"],
    ):
        said = refused(command, VASE, "-o", out, *options)
        assert str(VASE) in said and '"vase"' in said and "whole lines" in said
        assert not out.exists()


def test_its_patches_are_not_edited_one_by_one():
    vase = gradmesh.load(VASE)
    with pytest.raises(gradmesh.InputError, match='"vase".*bicubic'):
        gradmesh.refine(vase, "vase")
    assert vase.to_bytes() == VASE.read_bytes()


def test_a_smooth_mesh_is_listed_drawn_and_reported(tmp_path, simplified):
    (mesh,) = meshes(VASE)
    assert (mesh["smooth"], mesh["patches"], mesh["t_junctions"]) == (True, 88, 0)
    assert gradmesh.load(VASE).meshes[0].smooth
    for show in ("edges", "faces"):
        printed("draw", VASE, "-o", tmp_path / "out.svg", "--show", show)
        ET.parse(tmp_path / "out.svg")
    page = tmp_path / "out.html"
    printed("report", VASE, simplified[0]["smooth"], "-o", page)
    assert page.read_text().startswith("<!DOCTYPE html>")


def test_converted_its_colours_are_bicubic(tmp_path):
    opaque, out = tmp_path / "opaque.svg", tmp_path / "vase.hemesh"
    assert "opacity is lost" in printed("convert", VASE, out)
    opaque.write_text(re.sub(r"stop-opacity:[\d.]+", "stop-opacity:1", VASE.read_text()))
    said = printed("convert", opaque, out)
    # Only the eight parts each way in which Inkscape paints make a difference, a level here and
    # there, for which FLIP charges 0.03.
    assert float(re.search(r"FLIP ([\d.]+)", said)[1]) <= 0.006
    assert gradmesh.load(out).meshes[0].patches == 88


@pytest.mark.full
def test_the_limit_counts_the_patches_of_the_document_not_those_that_are_painted(tmp_path):
    smooth, out = tmp_path / "photo.svg", tmp_path / "out.svg"
    text = (SAMPLES / "photo.svg").read_text()
    smooth.write_text(text.replace("<meshgradient ", '<meshgradient type="bicubic" '))
    assert gradmesh.load(smooth).meshes[0].smooth
    printed("simplify", smooth, "-o", out, "--resolution", 100, "--epsilon", 0.02, "--method", "lines")
    assert gradmesh.load(out).meshes[0].patches < 400
    printed("render", smooth, "-o", tmp_path / "out.png")
    printed("compare", smooth, out)


@pytest.mark.full
def test_what_the_outline_hides_need_not_count_for_a_smooth_mesh_either():
    """Its mesh has other units than the object; a corner of the vase shows all that there is."""
    text = VASE.read_text()
    corner = re.sub(r'(<path id="vase" d=")[^"]*"', r'\1M 40,480 H 200 V 600 H 40 Z"', text)
    assert corner != text
    (all_counts,) = gradmesh.simplify(gradmesh.loads(text), epsilon=0.01, resolution=300, visible_only=True)
    (little,) = gradmesh.simplify(gradmesh.loads(corner), epsilon=0.01, resolution=300, visible_only=True)
    assert little.handles_after < all_counts.handles_after < 482


@pytest.mark.parametrize("type", ["coons", "bicubic"])
@pytest.mark.full(all_but=1)
def test_inkscape_saves_the_same_mesh_again(inkscape, simplified, tmp_path, type):
    sample, painted = ("smooth", "vase") if type == "bicubic" else ("transformed", "leaf")
    source, saved = simplified[0][sample], tmp_path / "saved.svg"
    inkscape.run_actions(source, [f"export-filename:{saved}", "export-plain-svg", "export-do"])
    (before,), (after,) = (gradmesh.load(path).meshes for path in (source, saved))
    assert (before.patches, before.smooth) == (after.patches, after.smooth)
    pictures = [tmp_path / "before.png", tmp_path / "after.png"]
    for path, png in zip((source, saved), pictures):
        printed("render", path, "--id", painted, "-o", png)
    assert error(*pictures) <= 0.0005
