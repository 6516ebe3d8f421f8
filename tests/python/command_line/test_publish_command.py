"""The command gradmesh publish: what it prints, writes and refuses."""

import gzip
import xml.etree.ElementTree as ET

import pytest

from bad_documents import RAGGED, REASON
from built import SAMPLES, gradmesh as run
from hemesh_files import grid
from lattices import BLUE, DOCUMENT, FILLED, MANY, RED, document, gradient
from program import meshes, printed, refused
from svg_meshes import SVG

import gradmesh

TWO = SAMPLES / "two.svg"
RECT = '<rect id="{}" x="12" y="12" width="36" height="16" fill="url(#{})"/>'
ALL = document(
    MANY,
    RECT.format("plain", "a") + RECT.format("ramp", "b") + RECT.format("shades", "m"),
    gradient([[RED] * 2] * 2, "a") + gradient([[RED, BLUE]] * 2, "b"),
)
TORN = DOCUMENT.format(defs=gradient(MANY) + RAGGED, body=FILLED + RECT.format("torn", "n"))


def tags(svg):
    return [element.tag for element in ET.parse(svg).iter()]


def test_it_prints_what_each_mesh_became_and_the_size_of_the_copy(tmp_path):
    svg, out = tmp_path / "in.svg", tmp_path / "out.svg"
    svg.write_text(ALL)
    lines = printed("publish", svg, "-o", out).splitlines()
    document = gradmesh.load(svg)
    (shades,) = [mesh for mesh in gradmesh.publish(document) if mesh.id == "shades"]
    picture = f"shades: picture, {shades.width} x {shades.height} pixels, {shades.bytes} bytes"
    assert sorted(lines[:-1]) == ["plain: colour", "ramp: linear gradient", picture]
    assert lines[-1] == f"{out}: {out.stat().st_size} bytes"
    assert shades.bytes > 0 and (shades.width, shades.height) == (76, 36)
    # The same as from Python, and the document itself is as it was.
    assert out.read_bytes() == document.to_bytes()
    assert svg.read_text() == ALL
    # The copy may be the document.
    printed("publish", svg, "-o", svg)
    assert svg.read_bytes() == out.read_bytes()
    assert SVG + "image" in tags(svg) and SVG + "meshgradient" not in tags(svg)


def test_quiet_prints_nothing(tmp_path):
    loud, quiet = tmp_path / "loud.svg", tmp_path / "quiet.svg"
    assert printed("publish", TWO, "-o", loud).count("\n") == 3
    assert printed("publish", "--quiet", TWO, "-o", quiet) == ""
    assert quiet.read_bytes() == loud.read_bytes()


def test_the_scale(tmp_path):
    lines, files = {}, {}
    for scale in (None, 1, 2, 3.5):
        out = tmp_path / "out.svg"
        options = ["--scale", scale] if scale else []
        said = printed("publish", TWO, "-o", out, *options)
        (lines[scale],) = [line for line in said.splitlines() if line.startswith("cap: picture, ")]
        files[scale] = out.read_bytes()
    assert len(set(lines.values())) == 3 and lines[None] == lines[2] and files[None] == files[2]


def test_a_compressed_copy_is_told_of_by_the_bytes_of_its_file(tmp_path):
    plain, small = tmp_path / "copy.svg", tmp_path / "copy.svgz"
    printed("publish", TWO, "-o", plain)
    said = printed("publish", TWO, "-o", small)
    assert small.stat().st_size < plain.stat().st_size
    assert gzip.decompress(small.read_bytes()) == plain.read_bytes()
    assert said.splitlines()[-1] == f"{small}: {small.stat().st_size} bytes"


@pytest.mark.parametrize("name, out", [("two.svg", "o.hemesh"), ("grid.hemesh", "o.svg"), ("grid.hemesh", "o.hemesh")])
def test_a_document_and_its_copy_are_svg_documents(tmp_path, name, out):
    mesh = tmp_path / name
    mesh.write_text(TWO.read_text() if name == "two.svg" else grid(2, 2))
    said = refused("publish", mesh, "-o", tmp_path / out)
    assert str(tmp_path / out if name == "two.svg" else mesh) in said
    assert [path.name for path in tmp_path.iterdir()] == [name]


def test_a_published_copy_has_no_mesh(tmp_path):
    once, twice = tmp_path / "once.svg", tmp_path / "twice.svg"
    printed("publish", TWO, "-o", once)
    said = refused("publish", once, "-o", twice)
    assert str(once) in said and "no object in this document is painted by a mesh gradient" in said
    assert not twice.exists()


@pytest.mark.parametrize("quiet", [(), ("--quiet",)])
def test_a_mesh_that_cannot_be_read_is_told_of(tmp_path, quiet):
    svg, out = tmp_path / "in.svg", tmp_path / "out.svg"
    svg.write_text(TORN)
    done = run("publish", svg, "-o", out, *quiet)
    assert (done.returncode, done.stderr) == (0, f"gradmesh: left as it was: {svg}: {REASON}\n")
    lines = done.stdout.splitlines()
    assert not lines if quiet else len(lines) == 2 and lines[0].startswith("box: picture, ")
    found = tags(out)
    assert (found.count(SVG + "image"), found.count(SVG + "meshgradient")) == (1, 1)
    assert [mesh["id"] for mesh in meshes(out)] == ["torn"]
