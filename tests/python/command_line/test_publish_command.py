"""The command gradmesh publish: what it prints, writes and refuses."""

import gzip
import json
import os
import subprocess
import xml.etree.ElementTree as ET

import pytest

from bad_documents import BAD, BELOW, FIRST, NEXT, row, stop
from built import PROGRAM, SAMPLES, gradmesh as run
from hemesh_files import grid

import gradmesh

SVG = "{http://www.w3.org/2000/svg}"
TWO = SAMPLES / "two.svg"


def tags(svg):
    return [element.tag for element in ET.fromstring(svg).iter()]


def gradient(name, colours, rows=None):
    """A mesh of one patch, or of these rows."""
    steps = ("l 20,0", "l 0,20", "l -20,0", "l 0,-20")
    rows = rows or row(f"<meshpatch>{''.join(map(stop, steps, colours))}</meshpatch>")
    return f'<meshgradient id="{name}" gradientUnits="userSpaceOnUse">{rows}</meshgradient>'


DOCUMENT = """<svg xmlns="http://www.w3.org/2000/svg" width="40" height="20">
<defs>{}</defs>
{}
</svg>
"""
RECT = '<rect id="{}" width="20" height="20" fill="url(#{})"/>'
RED, BLUE = "#c02010", "#2030b0"
GRADIENTS = {
    "plain": gradient("a", [RED] * 4),
    "ramp": gradient("b", [RED, BLUE, BLUE, RED]),
    "shades": gradient("c", [RED, BLUE, RED, BLUE]),
}
ALL = DOCUMENT.format(
    "".join(GRADIENTS.values()), "".join(RECT.format(name, "abc"[i]) for i, name in enumerate(GRADIENTS))
)
TORN = DOCUMENT.format(
    GRADIENTS["shades"] + gradient("n", [], row(FIRST, NEXT) + row(BELOW)),
    RECT.format("shades", "c") + RECT.format("torn", "n"),
)
REASON = 'meshgradient "n": row 2 does not have as many patches as row 1: 1, not 2.'


def test_it_prints_what_each_mesh_became_and_the_size_of_the_copy(tmp_path):
    svg, out = tmp_path / "in.svg", tmp_path / "out.svg"
    svg.write_text(ALL)
    done = run("publish", svg, "-o", out)
    assert (done.returncode, done.stderr) == (0, "")
    document = gradmesh.load(svg)
    told = {mesh.id: mesh for mesh in gradmesh.publish(document)}
    shades = told["shades"]
    assert sorted(done.stdout.splitlines()) == sorted(
        [
            "plain: colour",
            "ramp: linear gradient",
            f"shades: picture, {shades.width} x {shades.height} pixels, {shades.bytes} bytes",
            f"{out}: {out.stat().st_size} bytes",
        ]
    )
    assert done.stdout.splitlines()[-1].startswith(str(out))
    assert shades.bytes > 0 and (shades.width, shades.height) == (44, 44)
    # The same as from Python, and the document itself is as it was.
    assert out.read_bytes() == document.to_bytes()
    assert svg.read_text() == ALL


def test_the_copy_may_be_the_document(tmp_path):
    svg = tmp_path / "in.svg"
    svg.write_text(ALL)
    assert run("publish", svg, "-o", svg).returncode == 0
    assert SVG + "image" in tags(svg.read_bytes()) and SVG + "meshgradient" not in tags(svg.read_bytes())


def test_quiet_prints_nothing(tmp_path):
    loud, quiet = tmp_path / "loud.svg", tmp_path / "quiet.svg"
    assert run("publish", TWO, "-o", loud).stdout.count("\n") == 3
    done = run("publish", "--quiet", TWO, "-o", quiet)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert quiet.read_bytes() == loud.read_bytes()


def test_the_scale(tmp_path):
    sizes = {}
    for scale in ("1", "2", "3.5"):
        out = tmp_path / f"{scale}.svg"
        done = run("publish", TWO, "-o", out, "--scale", scale)
        assert done.returncode == 0
        (sizes[scale],) = [line for line in done.stdout.splitlines() if line.startswith("cap: picture, ")]
    assert len(set(sizes.values())) == 3
    default = run("publish", TWO, "-o", tmp_path / "default.svg").stdout
    assert sizes["2"] in default.splitlines()
    assert (tmp_path / "default.svg").read_bytes() == (tmp_path / "2.svg").read_bytes()


def test_a_compressed_copy(tmp_path):
    plain, small = tmp_path / "copy.svg", tmp_path / "copy.svgz"
    for out in (plain, small):
        assert run("publish", TWO, "-o", out, "--quiet").returncode == 0
    assert small.stat().st_size < plain.stat().st_size
    assert gzip.decompress(small.read_bytes()) == plain.read_bytes()


def test_a_compressed_copy_is_told_of_by_the_bytes_of_its_file(tmp_path):
    small = tmp_path / "copy.svgz"
    told = run("publish", TWO, "-o", small).stdout.splitlines()[-1]
    assert told == f"{small}: {small.stat().st_size} bytes"


def refused(done, *words):
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("gradmesh: ") and done.stderr.endswith(".\n")
    assert done.stderr.count("\n") == 1 and all(str(word) in done.stderr for word in words), done.stderr


def test_a_copy_is_an_svg_document(tmp_path):
    out = tmp_path / "copy.hemesh"
    refused(run("publish", TWO, "-o", out), out)
    assert not list(tmp_path.iterdir())


def test_hemesh_files(tmp_path):
    mesh, out = tmp_path / "grid.hemesh", tmp_path / "copy.svg"
    mesh.write_text(grid(2, 2))
    for target in (out, tmp_path / "copy.hemesh"):
        refused(run("publish", mesh, "-o", target), mesh if target == out else "hemesh")
    assert [path.name for path in tmp_path.iterdir()] == ["grid.hemesh"]


def test_a_published_copy_has_no_mesh(tmp_path):
    once, twice = tmp_path / "once.svg", tmp_path / "twice.svg"
    assert run("publish", TWO, "-o", once).returncode == 0
    refused(run("publish", once, "-o", twice), once, "no object in this document is painted by a mesh gradient")
    assert not twice.exists()


@pytest.mark.parametrize("quiet", [(), ("--quiet",)])
def test_a_mesh_that_cannot_be_read_is_told_of(tmp_path, quiet):
    svg, out = tmp_path / "in.svg", tmp_path / "out.svg"
    svg.write_text(TORN)
    done = run("publish", svg, "-o", out, *quiet)
    assert done.returncode == 0
    assert done.stderr == f"gradmesh: left as it was: {svg}: {REASON}\n"
    lines = done.stdout.splitlines()
    assert not lines if quiet else len(lines) == 2 and lines[0].startswith("shades: picture, ")
    found = tags(out.read_bytes())
    assert (found.count(SVG + "image"), found.count(SVG + "meshgradient")) == (1, 1)
    (left,) = json.loads(run("info", "--json", out).stdout)["meshes"]
    assert left["id"] == "torn"


@pytest.mark.parametrize("name", BAD)
def test_documents_that_are_refused(tmp_path, name):
    svg, out = tmp_path / "bad.svg", tmp_path / "out.svg"
    (tmp_path / "SECRET").write_text("secret")
    svg.write_text(BAD[name].text)
    refused(run("publish", svg, "-o", out), svg, *BAD[name].words)
    assert not out.exists()


@pytest.mark.parametrize("scale", ["0", "-1", "17", "nan", "inf", "large"])
def test_scales_that_are_none(tmp_path, scale):
    out = tmp_path / "out.svg"
    done = run("publish", TWO, "-o", out, f"--scale={scale}")
    assert done.returncode == 2 and done.stdout == "" and "scale" in done.stderr
    assert not out.exists()


def test_the_limit_on_resolution_bounds_pictures(tmp_path):
    done = subprocess.run(
        [PROGRAM, "publish", SAMPLES / "tensor.svg", "-o", tmp_path / "out.svg", "--scale", "16"],
        env={**os.environ, "GRADMESH_LIMITS": "resolution=120"},
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("silk: picture, 120 x 120 pixels, ")
