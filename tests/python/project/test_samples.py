"""The committed samples are what their script writes, and Inkscape paints each of their meshes."""

import re
import subprocess
import sys
import xml.etree.ElementTree as ET

import pytest

from built import SAMPLES
from in_inkscape import inkscape  # noqa: F401
from sample_meshes import OBJECTS, PAINTED, mesh_of


def test_the_script_writes_the_committed_bytes(tmp_path):
    subprocess.run(
        [sys.executable, "-B", str(SAMPLES / "make_samples.py"), str(tmp_path)], check=True
    )
    written = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    committed = {path.name: path.read_bytes() for path in SAMPLES.glob("*.svg")}
    assert set(written) == {f"{sample}.svg" for sample in PAINTED}
    assert written == committed


@pytest.mark.parametrize("sample", PAINTED)
def test_ids_are_unique(sample):
    ids = [element.get("id") for element in ET.parse(SAMPLES / f"{sample}.svg").iter()]
    ids = [name for name in ids if name]
    assert len(ids) == len(set(ids))


@pytest.mark.parametrize("sample, painted", OBJECTS)
def test_patches_form_a_grid_with_the_right_sides(sample, painted):
    mesh = mesh_of(ET.parse(SAMPLES / f"{sample}.svg").getroot(), painted)
    counts = [[len(patch) for patch in row] for row in mesh]
    first = [4] + [3] * (len(counts[0]) - 1)
    other = [3] + [2] * (len(counts[0]) - 1)
    assert counts == [first] + [other] * (len(counts) - 1)
    assert sum(map(len, counts)) == PAINTED[sample][painted]


@pytest.fixture(scope="module")
def image():
    return pytest.importorskip("PIL.Image")


FALLBACK = re.compile(r"(url\(#[\w-]+\)) (#[0-9a-f]{6})")


def rendered(inkscape, image, text, folder, only=None):
    """The picture that Inkscape paints of an SVG text, or of one object in it."""
    svg = folder / "document.svg"
    svg.write_text(text, encoding="utf-8")
    with image.open(inkscape.export_png(svg, folder / "picture.png", only=only)) as picture:
        return picture.convert("RGBA")


@pytest.mark.parametrize("sample", PAINTED)
@pytest.mark.full(all_but=1)
def test_inkscape_renders_the_page_at_its_size(inkscape, image, tmp_path, sample):
    text = (SAMPLES / f"{sample}.svg").read_text(encoding="utf-8")
    picture = rendered(inkscape, image, text, tmp_path)
    root = ET.fromstring(text)
    assert picture.size == (int(root.get("width")), int(root.get("height")))
    assert picture.getchannel("A").getextrema() == (255, 255)
    assert len(picture.getcolors(1 << 24)) > 1000


@pytest.mark.parametrize("sample, painted", OBJECTS)
@pytest.mark.full(all_but=1)
def test_the_mesh_paints_the_whole_object_without_its_fallback(
    inkscape, image, tmp_path, sample, painted
):
    text = (SAMPLES / f"{sample}.svg").read_text(encoding="utf-8")
    mesh = rendered(inkscape, image, FALLBACK.sub(r"\1", text), tmp_path, painted)
    flat = rendered(inkscape, image, FALLBACK.sub(r"\2", text), tmp_path, painted)
    assert mesh.size == flat.size
    alphas = zip(mesh.getchannel("A").getdata(), flat.getchannel("A").getdata())
    inside = [a for a, whole in alphas if whole > 200]
    assert len(inside) > 10000
    assert min(inside) > 0, "the mesh leaves a hole in the object"
    assert len({rgba[:3] for _, rgba in mesh.getcolors(1 << 24) if rgba[3] > 0}) > 1000
