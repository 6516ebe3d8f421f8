"""A mesh that cannot be read hides no other: it is listed with the reason and left as it was."""

import json

import pytest

from bad_documents import FIRST, NEXT, RAGGED as BAD, REASON, row
from built import gradmesh
from program import listed, meshes, printed, refused as sentence
from extension_runs import INKEX, extension, refused, run  # noqa: F401

GOOD = f'<meshgradient id="m" gradientUnits="userSpaceOnUse">{row(FIRST, NEXT)}</meshgradient>'
UNUSED = f'<meshgradient id="u">{row(FIRST, NEXT)}</meshgradient>'
DOCUMENT = """<svg xmlns="http://www.w3.org/2000/svg" width="40" height="20">
<defs>{}</defs>
<g id="both"><rect id="good" width="40" height="20" fill="url(#m)"/>
<rect id="bad" width="40" height="20" fill="url(#n)"/></g>
</svg>
"""


with_inkex = pytest.mark.skipif(not INKEX.is_dir(), reason="Inkscape is not installed")


@pytest.fixture
def svg(tmp_path):
    path = tmp_path / "in.svg"
    path.write_text(DOCUMENT.format(GOOD + BAD))
    return path


def test_info_lists_it(svg):
    assert printed("info", svg).splitlines() == [
        "good (fill): 6 handles, 2 patches, 1 object, 6 points, 0 T-junctions",
        f"bad (fill): cannot be read: {svg}: {REASON}",
    ]
    good, bad = meshes(svg)
    assert good["patches"] == 2 and "refused" not in good
    said = f"{svg}: {REASON}"
    assert bad == {"id": "bad", "role": "fill", "simplified": False, "refused": said}


@pytest.mark.parametrize("ids", [(), ("--id", "both")])
@pytest.mark.parametrize("how", ["simplify", "preview"])
def test_the_others_are_simplified(svg, tmp_path, ids, how):
    out, report = tmp_path / "out.svg", tmp_path / "report.json"
    target = ("--preview",) if how == "preview" else ("-o", out)
    done = gradmesh("simplify", svg, *target, *ids, "--report", report)
    assert done.returncode == 0
    assert done.stderr == f"gradmesh: left as it was: {svg}: {REASON}\n"
    assert done.stdout.startswith("good: 4 of 6 handles, 1 of 2 patches left") and "bad" not in done.stdout
    good, bad = json.loads(report.read_text())["meshes"]
    assert good["patches_after"] == 1 and bad == {"id": "bad", "refused": f"{svg}: {REASON}"}
    if how == "simplify":
        assert BAD in out.read_text() and GOOD not in out.read_text()


@pytest.mark.parametrize("ids", [("--id", "bad"), ("--id", "good", "--id", "bad")])
def test_named_it_is_an_error(svg, tmp_path, ids):
    for command in ("simplify", "update", "analyze"):
        assert sentence(command, svg, "-o", tmp_path / "out", *ids) == f"{svg}: {REASON}"
    assert [path.name for path in tmp_path.iterdir()] == ["in.svg"]


@pytest.mark.parametrize("count, more", [(2, ""), (5, ""), (8, " 3 more meshes cannot be changed either.")])
def test_where_none_can_be_changed_each_is_told(tmp_path, count, more):
    path, paths = tmp_path / "in.svg", "<path fill='url(#n)'/>" * count
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg">{BAD}{paths}</svg>')
    told = " ".join([f"{path}: {REASON}"] * min(count, 5))
    assert sentence("simplify", path, "-o", tmp_path / "out.svg") == told + more


def test_the_only_one_that_can_be_read_needs_no_name(svg, tmp_path):
    printed("render", svg, "-o", tmp_path / "out.png")


@with_inkex
@pytest.mark.parametrize("ids", [(), ("--id=good", "--id=bad"), ("--id=both",)])
@pytest.mark.full(all_but=1)
def test_in_inkscape_the_others_are_simplified(run, svg, tmp_path, ids):
    lines = tmp_path / "lines"
    done = run(svg, *ids, GRADMESH_REPORT=str(lines))
    assert done.returncode == 0
    assert done.stderr == f"Left as it was: apple.svg: {REASON}\n"
    assert BAD in done.stdout and GOOD not in done.stdout
    line = json.loads(lines.read_text())
    assert line["outcome"] == "done" and line["message"] == done.stderr.strip()
    good, bad = line["meshes"]
    assert (good["patches_after"], good["refused"]) == (1, None)
    assert bad == {"id": "bad", "refused": f"apple.svg: {REASON}"}


@with_inkex
@pytest.mark.parametrize("item", ["simplify", "update", "to_one_mesh", "show_analysis"])
@pytest.mark.full(all_but=1)
def test_alone_in_inkscape_it_is_a_sentence(run, svg, item):
    assert refused(run(svg, "--id=bad", item=item)) == f"apple.svg: {REASON}\n"


@with_inkex
def test_the_analysis_of_the_others_is_shown(run, svg):
    done = run(svg, "--id=both", item="show_analysis")
    assert done.stderr == f"Left as it was: apple.svg: {REASON}\n"
    assert "gradmesh:analysis" in done.stdout


def test_a_mesh_that_nothing_uses(tmp_path):
    path = tmp_path / "dead.svg"
    path.write_text(DOCUMENT.format(UNUSED))
    assert printed("info", path) == "u: 2 patches, unused: no object is painted by it\n"
    assert meshes(path) == [] and listed(path)["unused"] == [{"id": "u", "patches": 2}]
    said = sentence("simplify", path, "-o", tmp_path / "out.svg")
    assert "no object in this document is painted" in said


def test_only_what_paints_nothing_is_unused(svg, tmp_path):
    path, out = tmp_path / "mixed.svg", tmp_path / "out.svg"
    part = '<text><tspan fill="url(#v)">A</tspan></text>'
    text = DOCUMENT.format(GOOD + BAD + UNUSED + UNUSED.replace('"u"', '"v"'))
    path.write_text(text.replace("</svg>", part + "</svg>"))
    # Blocks are painted by gradients too.
    printed("simplify", path, "-o", out, "--id", "good", "--method", "best")
    for file in (path, out):
        assert [mesh["id"] for mesh in listed(file)["unused"]] == ["u"]
