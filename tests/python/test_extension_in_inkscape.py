"""The extension in a real Inkscape: what it does to the document, and what it looks like."""

import json
import re
import xml.etree.ElementTree as ET

import pytest

import inkscape_harness
from built import SAMPLES, gradmesh, install_extension
from inkscape_harness import Inkscape

RAW_ID = "org.gradmesh.simplify"
SVG = "{http://www.w3.org/2000/svg}"
LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
LABEL_TEXT = re.compile(r"Gradient mesh: (\d+) of (\d+) patches, (FLIP|SSIM) (\d\.\d{4})")
EPSILON = 0.01

reason = inkscape_harness.missing()
pytestmark = pytest.mark.skipif(bool(reason), reason=reason or "nothing is missing")


@pytest.fixture(scope="module")
def extension(tmp_path_factory):
    return install_extension(tmp_path_factory.mktemp("installed"))


@pytest.fixture(scope="module")
def inkscape(extension):
    with Inkscape() as running:
        running.install(extension)
        yield running


def meshes(svg):
    """By id what `gradmesh info` knows of each mesh."""
    return {mesh["id"]: mesh for mesh in json.loads(gradmesh("info", "--json", svg).stdout)["meshes"]}


def by_id(svg):
    return {element.get("id"): element for element in ET.parse(svg).iter() if element.get("id")}


def simplified(inkscape, sample, out, ids, **values):
    """The document out of Inkscape after the extension ran on `ids` with these values."""
    inkscape.set_values({f"{RAW_ID}.{name}": value for name, value in values.items()})
    inkscape.run_extension(RAW_ID, SAMPLES / f"{sample}.svg", out, select=ids)
    return by_id(out)


@pytest.mark.parametrize(
    "sample, ids",
    [
        ("fruit", ["pear"]),
        ("face", ["face"]),
        ("stroke", ["loop"]),
        ("transformed", ["leaf"]),
        ("two", ["cap", "stalk"]),
    ],
)
def test_the_mesh_is_smaller_and_looks_the_same(inkscape, tmp_path, sample, ids):
    before, after = SAMPLES / f"{sample}.svg", tmp_path / "after.svg"
    elements = simplified(inkscape, sample, after, ids, epsilon=EPSILON)
    found, was = meshes(after), meshes(before)
    for name in ids:
        patches, all_patches, metric, error = LABEL_TEXT.fullmatch(elements[name].get(LABEL)).groups()
        assert elements[name].tag == SVG + "g"
        assert int(patches) == found[name]["patches"] < was[name]["patches"] == int(all_patches)
        assert metric == "FLIP" and 0 < float(error) <= EPSILON
    pictures = [
        inkscape.export_png(svg, tmp_path / f"{when}.png", width=700)
        for when, svg in (("before", before), ("after", after))
    ]
    assert float(gradmesh("compare", *pictures).stdout) <= EPSILON + 0.003


def test_other_objects_stay(inkscape, tmp_path):
    """Compared with what Inkscape makes of the document without the extension."""
    plain = tmp_path / "plain.svg"
    inkscape.run_actions(SAMPLES / "two.svg", [f"export-filename:{plain}", "export-do"])
    before = by_id(plain)
    after = simplified(inkscape, "two", tmp_path / "after.svg", ["cap"])
    for name in ("background", "shadow", "stalk"):
        assert after[name].attrib == before[name].attrib
    assert meshes(tmp_path / "after.svg")["stalk"] == meshes(SAMPLES / "two.svg")["stalk"]


def test_preferences_reach_the_extension(inkscape, tmp_path):
    def label(**values):
        elements = simplified(inkscape, "fruit", tmp_path / "after.svg", ["pear"], **values)
        return LABEL_TEXT.fullmatch(elements["pear"].get(LABEL)).groups()

    coarse, fine = label(epsilon="0.03"), label(epsilon="0.003")
    assert int(coarse[0]) < int(fine[0])
    assert float(fine[3]) <= 0.003 < float(coarse[3]) <= 0.03
    assert label(metric="ssim")[2] == "SSIM"


def test_twice_is_once_more(inkscape, tmp_path):
    """What Inkscape saved is simplified again, and the label still counts from the first mesh."""
    once, twice = tmp_path / "once.svg", tmp_path / "twice.svg"
    simplified(inkscape, "fruit", once, ["pear"], epsilon="0.005")
    inkscape.set_values({f"{RAW_ID}.epsilon": "0.03"})
    inkscape.run_extension(RAW_ID, once, twice, select=["pear"])
    left, all_patches, *_ = LABEL_TEXT.fullmatch(by_id(twice)["pear"].get(LABEL)).groups()
    assert int(left) == meshes(twice)["pear"]["patches"] < meshes(once)["pear"]["patches"]
    assert all_patches == "132"
