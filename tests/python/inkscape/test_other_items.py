"""The items beside Simplify do what they say when run as Inkscape runs them."""

import re
import xml.etree.ElementTree as ET

import pytest

from built import SAMPLES
from extension_runs import INKEX, SVG, by_id, extension, is_one_sentence, refused, run  # noqa: F401

import gradmesh

pytestmark = pytest.mark.skipif(not INKEX.is_dir(), reason="Inkscape is not installed")


def block_ids(text, mesh="pear"):
    return [e.get("id") for e in by_id(text)[mesh] if e.get("{urn:gradmesh}face")]


@pytest.fixture(scope="module")
def simplified():
    document = gradmesh.load(SAMPLES / "fruit.svg")
    gradmesh.simplify(document, method="best", count="handles", amount="strong", resolution=200)
    return document.to_bytes().decode()


def patches(text):
    (mesh,) = gradmesh.loads(text).meshes
    return mesh.patches


def test_refine_and_update_and_one_mesh(run, simplified, tmp_path):
    block = block_ids(simplified)[0]
    refined = run(simplified, f"--id={block}", "--row=1", "--column=1", item="refine")
    assert refined.stderr == "" and patches(refined.stdout) == patches(simplified) + 3
    log = (tmp_path / "cache" / "gradmesh" / "extension.log").read_text()
    assert "pear: 3 more patches; now it has" in log and f"{patches(refined.stdout)} patches.\n" in log
    assert "fit together" in refused(run(simplified, "--id=pear", item="update"))
    one = run(simplified, f"--id={block}", item="to_one_mesh")
    assert one.stderr == "" and by_id(one.stdout)["pear"].tag == SVG + "path"
    assert patches(one.stdout) >= patches(simplified)


def test_merge(run, simplified):
    blocks = block_ids(simplified)
    merged = refused_once = False
    for other in blocks[1:]:
        done = run(simplified, f"--id={blocks[0]}", f"--id={other}", "--tell=false", item="merge")
        if done.stderr:
            assert "cannot become one" in refused(done)
            refused_once = True
        else:
            assert patches(done.stdout) < patches(simplified)
            merged = True
        if merged and refused_once:
            return
    assert refused_once


def test_merge_tells_a_person_the_error_and_nobody_otherwise(run):
    part = ("--id=pear", "--first_row=2", "--last_row=3", "--first_column=4")
    told = run(SAMPLES / "fruit.svg", *part, item="merge")
    assert patches(told.stdout) == 131
    said = r"pear: these patches are one now\. The error is FLIP 0\.\d{4}, and \d+ handles and 131 patches are left\.\n"
    assert re.fullmatch(said, told.stderr)
    for options, environment in (["--tell=false"], {}), ([], {"GRADMESH_UNATTENDED": "1"}):
        silent = run(SAMPLES / "fruit.svg", *part, *options, item="merge", **environment)
        assert silent.stderr == "" and silent.stdout == told.stdout


def test_merge_heeds_rows_of_one_block_alone(run, simplified):
    """As Inkscape remembers what the dialog said before."""
    blocks = [f"--id={block}" for block in block_ids(simplified)[:2]]
    said = [run(simplified, *blocks, *rows, "--tell=false", item="merge") for rows in ([], ["--first_row=1"])]
    assert said[0].stdout == said[1].stdout and said[0].stderr == said[1].stderr


@pytest.mark.parametrize("show", ["edges", "errors", "faces", "motorcycle", "regions"])
@pytest.mark.full(all_but=1)
def test_analysis_comes_and_goes(run, show):
    shown = run(SAMPLES / "fruit.svg", "--id=pear", f"--show={show}", item="show_analysis")
    assert shown.stderr == ""
    (layer,) = [e for e in ET.fromstring(shown.stdout) if e.get("{urn:gradmesh}analysis")]
    assert layer.get("{http://www.inkscape.org/namespaces/inkscape}groupmode") == "layer"
    assert len(list(layer.iter(SVG + "path"))) > 50 and not list(layer.iter(SVG + "image"))
    removed = run(shown.stdout, item="remove_analysis")
    assert list(by_id(removed.stdout)) == list(by_id((SAMPLES / "fruit.svg").read_text()))
    assert "no analysis" in refused(run(removed.stdout, item="remove_analysis"))


@pytest.mark.parametrize(
    "item, options, words",
    [
        ("merge", [], "Select two or more blocks"),
        ("merge", ["--id=pear"], "rows and columns of it"),
        ("merge", ["--id=pear", "--first_row=3", "--last_row=2"], "from the first to the last"),
        ("merge", ["--id=stem"], "no block of a simplified mesh"),
        ("merge", ["--id=gone"], '"gone"'),
        ("refine", [], "Select one block"),
        ("refine", ["--id=stem"], "no block of a simplified mesh"),
        ("refine", ["--id=pear", "--row=99"], "no row 99"),
        ("refine", ["--id=pear", "--direction=up"], "'up'"),
        ("update", [], "Select an object"),
        ("update", ["--id=pear"], "needs no update"),
        ("to_one_mesh", ["--id=pear"], "simplified"),
        ("show_analysis", ["--id=pear", "--show=taste"], "'taste'"),
    ],
)
@pytest.mark.full(all_but=1)
def test_other_items_refuse_in_one_sentence(run, item, options, words):
    assert words in refused(run(SAMPLES / "fruit.svg", *options, item=item))


def test_hemesh_in_and_out(extension, run, tmp_path):
    saved = run(SAMPLES / "fruit.svg", item="save")
    assert saved.stderr == "" and saved.stdout.startswith("HEMESH")
    opened = run(saved.stdout, item="open")
    assert opened.stderr == ""
    assert patches(opened.stdout) == 132  # colours from SVG need no smaller patches
    assert "holds one gradient mesh" in refused(run(SAMPLES / "two.svg", item="save"))
    assert run(SAMPLES / "two.svg", "--id=cap", item="save").stdout.startswith("HEMESH")
    bad = run("HEMESH\nnot a mesh\n", item="open")
    assert bad.stdout == "" and is_one_sentence(bad.stderr)
    assert bad.stderr.endswith(', line 2: "not" is not a whole number.\n') and "/" not in bad.stderr
