"""The method lines in documents: a smaller mesh gradient on the same object, all else untouched."""

import json
import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest

import inkscape_harness
import svg_meshes
from built import PROGRAM, SAMPLES, gradmesh as run
from sample_meshes import OBJECTS, PAINTED, mesh_of

import gradmesh

EPSILON = 0.02
VASE = SAMPLES / "smooth.svg"
SVG = "{http://www.w3.org/2000/svg}"
NEEDS_INKSCAPE = inkscape_harness.missing() or ("" if PROGRAM.exists() else "not built")
in_inkscape = pytest.mark.skipif(bool(NEEDS_INKSCAPE), reason=NEEDS_INKSCAPE or "nothing missing")


@pytest.fixture(scope="module")
def simplified(tmp_path_factory):
    """The samples with lines taken out, and what was told of each object."""
    folder = tmp_path_factory.mktemp("lines")
    files, told = {}, {}
    for sample in PAINTED:
        files[sample], report = folder / f"{sample}.svg", folder / "report.json"
        options = ["--method", "lines", "--whole-mesh", "--epsilon", EPSILON, "--report", report]
        done = run("simplify", SAMPLES / f"{sample}.svg", "-o", files[sample], *options)
        assert (done.returncode, done.stderr) == (0, "")
        told |= {mesh["id"]: mesh for mesh in json.loads(report.read_text())["meshes"]}
    return files, told


def paint_of(element):
    """The object's style and attributes, the paint by a mesh by itself, without what is remembered."""
    style = dict(part.split(":", 1) for part in element.get("style", "").split(";") if part)
    attributes = {n: value for n, value in element.attrib.items() if not n.startswith("{urn:gradmesh}")}
    values = {**attributes, **style}
    values.pop("style", None)
    names = [name for name, value in values.items() if re.match(r"url\(#[\w-]*mesh", value)]
    (name,) = [n for n in names if n in ("fill", "stroke")]
    return name, values.pop(name), values


@pytest.mark.parametrize("sample, painted", OBJECTS)
def test_the_object_stays_and_names_one_smaller_gradient(simplified, sample, painted):
    files, told = simplified
    before, after = (
        svg_meshes.Document(path) for path in (SAMPLES / f"{sample}.svg", files[sample])
    )
    assert told[painted]["method"] == "lines"
    assert told[painted]["patches_after"] < told[painted]["patches_before"]
    assert told[painted]["error"] <= EPSILON
    (name, old, rest), (name_after, new, rest_after) = (
        paint_of(document.by_id[painted]) for document in (before, after)
    )
    assert (name_after, rest_after) == (name, rest)
    assert new.split(" ")[1:] == old.split(" ")[1:] != []  # the fallback colour
    assert re.search(r"#([\w-]+)", old)[1] not in after.by_id
    mesh = mesh_of(after.root, painted)
    assert sum(len(row) for row in mesh) == told[painted]["patches_after"]
    assert len({len(row) for row in mesh}) == 1
    gradient, gradient_before = (
        document.paint(document.by_id[painted]) for document in (after, before)
    )
    for attribute in ("gradientTransform", "type"):
        assert gradient.get(attribute) == gradient_before.get(attribute)
    # The corners of the whole mesh have not moved.
    nets = [document.net(document.by_id[painted]) for document in (before, after)]
    corners = [net[np.ix_((0, -1), (0, -1))] for net in nets]
    assert abs(corners[0] - corners[1]).max() <= 1e-7 * abs(corners[0]).max()


@pytest.mark.parametrize("sample", PAINTED)
def test_other_objects_are_untouched(simplified, sample):
    texts = [path.read_text() for path in (SAMPLES / f"{sample}.svg", simplified[0][sample])]
    roots = [ET.fromstring(text) for text in texts]
    for root in roots:
        for parent in list(root.iter()):
            for child in list(parent):
                if child.tag == SVG + "meshgradient" or child.get("id") in PAINTED[sample]:
                    parent.remove(child)
    before, after = (ET.tostring(root).split() for root in roots)
    assert before == after


@pytest.mark.parametrize("sample, painted", OBJECTS)
def test_the_error_is_that_of_what_is_written(simplified, tmp_path, sample, painted):
    files, told = simplified
    pair = [tmp_path / "before.svg", tmp_path / "after.svg"]
    for path, source in zip(pair, (SAMPLES / f"{sample}.svg", files[sample])):
        keep_only(painted, source, path)
    found = float(run("compare", *pair).stdout)
    assert found == pytest.approx(told[painted]["error"], abs=2e-5)


def keep_only(painted, source, path):
    """Writes the document without the other objects that a mesh paints."""
    tree = ET.parse(source)
    for parent in list(tree.getroot().iter()):
        for child in list(parent):
            if child.get("id") in {p for _, p in OBJECTS} - {painted}:
                parent.remove(child)
    tree.write(path)


def test_from_python_as_from_the_command_line(simplified):
    files, told = simplified
    document = gradmesh.load(SAMPLES / "fruit.svg")
    assert [mesh.smooth for mesh in document.meshes] == [False]
    (result,) = gradmesh.simplify(document, method="lines", epsilon=EPSILON, visible_only=False)
    assert (result.method, result.error) == ("lines", told["pear"]["error"])
    assert document.to_bytes() == files["fruit"].read_bytes()
    (mesh,) = document.meshes
    assert not mesh.simplified and mesh.patches == result.patches_after


def test_again_it_starts_from_what_is_there(simplified, tmp_path):
    out = tmp_path / "out.svg"
    options = ["--method", "lines", "--epsilon", EPSILON]
    assert run("simplify", simplified[0]["fruit"], "-o", out, *options).returncode == 0
    (pear,) = gradmesh.load(out).meshes
    assert pear.patches <= simplified[1]["pear"]["patches_after"]


def test_a_group_of_blocks_that_is_one_rectangle_stays_a_group(tmp_path):
    group, out = tmp_path / "group.svg", tmp_path / "out.svg"
    exact = ["--method", "lines", "--epsilon", 0.02]
    # Everything merged: one block.
    merged = ["--method", "grid", "--epsilon", 1]
    assert run("simplify", SAMPLES / "tensor.svg", "-o", group, *merged).returncode == 0
    (silk,) = gradmesh.load(group).meshes
    assert silk.simplified and silk.patches == 1
    assert run("simplify", group, "-o", out, *exact).returncode == 0
    assert out.read_bytes() == group.read_bytes()


def test_a_mesh_with_T_junctions_is_refused(tmp_path):
    group, out = tmp_path / "group.svg", tmp_path / "out.svg"
    assert run("simplify", SAMPLES / "fruit.svg", "-o", group, "--method", "best").returncode == 0
    done = run("simplify", group, "-o", out, "--method", "lines")
    assert done.returncode == 1 and not out.exists()
    assert str(group) in done.stderr and "pear" in done.stderr
    assert "one rectangle of patches" in done.stderr and done.stderr.count("\n") == 1


# --- smooth meshes, type="bicubic" ---


def test_a_smooth_mesh_loses_lines_whatever_method_is_asked_for(tmp_path, simplified):
    out = tmp_path / "out.svg"
    for method in ("gqe", "motorcycle", "random"):
        options = ["--method", method, "--epsilon", EPSILON, "--report", tmp_path / "report.json"]
        assert run("simplify", VASE, "-o", out, *options).returncode == 0
        (told,) = json.loads((tmp_path / "report.json").read_text())["meshes"]
        assert told["method"] == "lines"
        assert out.read_bytes() == simplified[0]["smooth"].read_bytes()


def test_what_needs_single_patches_says_that_it_cannot(tmp_path):
    out = tmp_path / "out"
    for arguments in (
        ["simplify", VASE, "-o", out, "--method", "manual", "--edges", 5],
        ["analyze", VASE, "-o", out],
        ["draw", VASE, "-o", out, "--show", "errors"],
        ["draw", VASE, "-o", out, "--show", "motorcycle"],
        ["draw", VASE, "-o", out, "--show", "regions"],
    ):
        done = run(*arguments)
        assert (done.returncode, out.exists()) == (1, False)
        assert str(VASE) in done.stderr and '"vase"' in done.stderr and "whole lines" in done.stderr
        assert done.stderr.count("\n") == 1


def test_its_patches_are_not_edited_one_by_one():
    vase = gradmesh.load(VASE)
    with pytest.raises(gradmesh.InputError, match='"vase".*bicubic'):
        gradmesh.refine(vase, "vase")
    assert vase.to_bytes() == VASE.read_bytes()


def test_a_smooth_mesh_is_listed_drawn_and_reported(tmp_path, simplified):
    (mesh,) = json.loads(run("info", "--json", VASE).stdout)["meshes"]
    assert (mesh["smooth"], mesh["patches"], mesh["t_junctions"]) == (True, 88, 0)
    assert gradmesh.load(VASE).meshes[0].smooth
    for show in ("edges", "faces"):
        assert run("draw", VASE, "-o", tmp_path / "out.svg", "--show", show).returncode == 0
        ET.parse(tmp_path / "out.svg")
    page = tmp_path / "out.html"
    assert run("report", VASE, simplified[0]["smooth"], "-o", page).returncode == 0
    assert page.read_text().startswith("<!DOCTYPE html>")


def test_converted_its_colours_are_bicubic(tmp_path):
    out = tmp_path / "vase.hemesh"
    done = run("convert", VASE, out)
    assert done.returncode == 0 and "opacity is lost" in done.stdout
    opaque, out = tmp_path / "opaque.svg", tmp_path / "opaque.hemesh"
    opaque.write_text(re.sub(r"stop-opacity:[\d.]+", "stop-opacity:1", VASE.read_text()))
    done = run("convert", opaque, out)
    # Only the eight parts each way in which Inkscape paints make a difference, a level here and
    # there, for which FLIP charges 0.03.
    assert float(re.search(r"FLIP ([\d.]+)", done.stdout)[1]) <= 0.006
    assert gradmesh.load(out).meshes[0].patches == 88


def test_the_limit_counts_the_patches_of_the_document_not_those_that_are_painted(tmp_path):
    smooth, out = tmp_path / "photo.svg", tmp_path / "out.svg"
    text = (SAMPLES / "photo.svg").read_text()
    smooth.write_text(text.replace("<meshgradient ", '<meshgradient type="bicubic" '))
    assert gradmesh.load(smooth).meshes[0].smooth
    options = ("--resolution", 100, "--epsilon", 0.02, "--method", "lines")
    done = run("simplify", smooth, "-o", out, *options)
    assert done.returncode == 0 and gradmesh.load(out).meshes[0].patches < 400
    assert run("render", smooth, "-o", tmp_path / "out.png").returncode == 0
    assert run("compare", smooth, out).returncode == 0


def test_what_the_outline_hides_need_not_count_for_a_smooth_mesh_either():
    """Its mesh has other units than the object; a corner of the vase shows all that there is."""
    text = VASE.read_text()
    corner = re.sub(r'(<path id="vase" d=")[^"]*"', r'\1M 40,480 H 200 V 600 H 40 Z"', text)
    assert corner != text
    (all_counts,) = gradmesh.simplify(gradmesh.loads(text), epsilon=0.01, visible_only=True)
    (little,) = gradmesh.simplify(gradmesh.loads(corner), epsilon=0.01, visible_only=True)
    assert little.handles_after < all_counts.handles_after < 482


@in_inkscape
@pytest.mark.parametrize("type", ["coons", "bicubic"])
def test_inkscape_saves_the_same_mesh_again(simplified, tmp_path, type):
    sample, painted = ("smooth", "vase") if type == "bicubic" else ("transformed", "leaf")
    source, saved = simplified[0][sample], tmp_path / "saved.svg"
    with inkscape_harness.Inkscape() as inkscape:
        inkscape.run_actions(source, [f"export-filename:{saved}", "export-plain-svg", "export-do"])
    (before,), (after,) = (gradmesh.load(path).meshes for path in (source, saved))
    assert (before.patches, before.smooth) == (after.patches, after.smooth)
    for path, png in ((source, "before.png"), (saved, "after.png")):
        assert run("render", path, "--id", painted, "-o", tmp_path / png).returncode == 0
    assert float(run("compare", tmp_path / "before.png", tmp_path / "after.png").stdout) <= 0.0005
