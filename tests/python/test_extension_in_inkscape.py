"""The extension in a real Inkscape: what it does to the document, and what it looks like."""

import json
import re
import xml.etree.ElementTree as ET

import pytest

import inkscape_harness
from built import SAMPLES, gradmesh as run, install_extension
from inkscape_harness import Inkscape

import gradmesh

RAW_ID = "org.gradmesh.simplify"
SVG = "{http://www.w3.org/2000/svg}"
LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
VIEW = "{http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd}namedview"
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
    return {mesh["id"]: mesh for mesh in json.loads(run("info", "--json", svg).stdout)["meshes"]}


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
    assert float(run("compare", *pictures).stdout) <= EPSILON + 0.003


@pytest.fixture(scope="module")
def untouched(inkscape, tmp_path_factory):
    """What Inkscape makes of the sample "two" without the extension."""
    plain = tmp_path_factory.mktemp("untouched") / "plain.svg"
    inkscape.run_actions(SAMPLES / "two.svg", [f"export-filename:{plain}", "export-do"])
    return plain


def all_but_the_view(svg):
    """The document, whatever window it was seen in."""
    return ET.canonicalize(from_file=svg, exclude_tags=[VIEW])


def test_other_objects_stay(inkscape, untouched, tmp_path):
    before = by_id(untouched)
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


STALK = 36  # patches, so few that every method is quick
METHODS = [
    ("motorcycle", {"kappa": 0.2}),
    ("gqe", {"omega": 0.3}),
    ("gqe1", {"omega": 0.9}),
    ("grid", {"seed": 2}),
    ("dual-grid", {"seed": 1}),
    ("random", {"seed": 2}),
]
EDGES = "100, 120"


@pytest.mark.parametrize("method, values", METHODS, ids=[method for method, _ in METHODS])
def test_every_method_with_its_settings(inkscape, tmp_path, method, values):
    """The same comes out as from Python: so every value has reached the core."""
    values = {"method": method, "resolution": 100, **values}
    (expected,) = gradmesh.simplify(gradmesh.load(SAMPLES / "two.svg"), "stalk", **values)
    elements = simplified(inkscape, "two", tmp_path / "after.svg", ["stalk"], **values)
    left, _, metric, error = LABEL_TEXT.fullmatch(elements["stalk"].get(LABEL)).groups()
    assert int(left) == expected.patches_after < STALK
    assert (metric, error) == ("FLIP", f"{expected.error:.4f}") and 0 < float(error) <= EPSILON
    assert meshes(tmp_path / "after.svg")["stalk"]["patches"] == int(left)


def test_named_edges(inkscape, tmp_path):
    values = {"method": "manual", "edges": EDGES, "resolution": 100}
    elements = simplified(inkscape, "two", tmp_path / "after.svg", ["stalk"], **values)
    left, _, _, error = LABEL_TEXT.fullmatch(elements["stalk"].get(LABEL)).groups()
    assert int(left) == STALK - 2 and 0 < float(error) <= EPSILON


@pytest.mark.parametrize(
    "values, words",
    [
        ({"preview": "true", "edges": EDGES}, "stalk: 34 of 36 patches would be left"),
        ({"preview": "true", "edges": EDGES, "epsilon": 0}, "above the largest error, 0."),
        ({"edges": EDGES, "epsilon": 0}, "half-edge 100"),
        ({"method": "magic"}, "'magic'"),
    ],
)
def test_what_is_only_said_changes_nothing(inkscape, untouched, tmp_path, values, words):
    values = {"method": "manual", "resolution": 100, **values}
    inkscape.set_values({f"{RAW_ID}.{name}": value for name, value in values.items()})
    after = tmp_path / "after.svg"
    said = inkscape.said_by_extension(RAW_ID, SAMPLES / "two.svg", after, select=["stalk"])
    assert words in said and said.count("\n") == 1 and said.endswith(".\n")
    assert all_but_the_view(after) == all_but_the_view(untouched)


def test_twice_is_once_more(inkscape, tmp_path):
    """What Inkscape saved is simplified again, and the label still counts from the first mesh."""
    once, twice = tmp_path / "once.svg", tmp_path / "twice.svg"
    simplified(inkscape, "fruit", once, ["pear"], epsilon="0.005")
    inkscape.set_values({f"{RAW_ID}.epsilon": "0.03"})
    inkscape.run_extension(RAW_ID, once, twice, select=["pear"])
    left, all_patches, *_ = LABEL_TEXT.fullmatch(by_id(twice)["pear"].get(LABEL)).groups()
    assert int(left) == meshes(twice)["pear"]["patches"] < meshes(once)["pear"]["patches"]
    assert all_patches == "132"
