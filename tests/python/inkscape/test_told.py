"""What a person is told after Simplify and Save a Copy, and what these leave alone."""

import re
import subprocess
import time

import pytest

from built import PYTHON, SAMPLES
from extension_runs import INKEX, SMALL, extension, refused, run  # noqa: F401

import gradmesh

TWO = SAMPLES / "two.svg"
ATTENDED = {"GRADMESH_UNATTENDED": "0"}

pytestmark = pytest.mark.skipif(not INKEX.is_dir(), reason="Inkscape is not installed")


def log(tmp_path):
    """What is told in a window is in the log, too."""
    return (tmp_path / "cache" / "gradmesh" / "extension.log").read_text()


def handles(text):
    return {mesh.id: mesh.handles for mesh in gradmesh.loads(text).meshes}


def with_attribute(name, attribute):
    """The sample with the cap and the stalk, one of which has another attribute."""
    names = 'xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"'
    return TWO.read_text().replace(f'id="{name}"', f'{names} id="{name}" {attribute}')


def test_the_result_is_told_without_a_dialog(run, tmp_path):
    done = run(TWO, SMALL, **ATTENDED)
    assert (done.returncode, done.stderr) == (0, "")
    before, after = (sum(handles(text).values()) for text in (TWO.read_text(), done.stdout))
    assert f"2 gradient meshes: {after} of {before} handles are left, FLIP up to 0.0" in log(tmp_path)


@pytest.mark.full
def test_more_than_strong_allows_is_said(run, tmp_path):
    run(TWO, SMALL, "--id=cap", "--amount=handles", "--handles=40", **ATTENDED)
    assert "That is more than Strong allows: it will be seen." in log(tmp_path)


@pytest.mark.full
def test_what_protection_keeps_is_said(run, tmp_path):
    shape = '<rect id="{}" x="{}" y="230" width="12" height="12"/></svg>'
    text = TWO.read_text()
    some = text.replace("</svg>", shape.format("spot", 150))
    run(some, SMALL, "--id=cap", "--id=spot", "--protect_selected=true", **ATTENDED)
    assert re.search(r"[1-9]\d* patches are protected, and lines that cross them stay\.", log(tmp_path))
    every = text.replace("</svg>", '<rect id="all" x="-999" y="-999" width="3000" height="3000"/></svg>')
    done = run(every, SMALL, "--id=cap", "--id=all", "--protect_selected=true")
    assert "280 patches are protected" in refused(done)


@pytest.mark.parametrize("attribute", ['sodipodi:insensitive="true"', 'display="none"'])
@pytest.mark.full
def test_what_is_locked_or_hidden_is_left_out_where_nothing_is_selected(run, tmp_path, attribute):
    text = with_attribute("stalk", attribute)
    done = run(text, SMALL, **ATTENDED)
    was, now = handles(text), handles(done.stdout)
    assert now["stalk"] == was["stalk"] and now["cap"] < was["cap"]
    assert "1 locked or hidden meshes were left out." in log(tmp_path)
    chosen = run(text, SMALL, "--id=stalk")
    assert handles(chosen.stdout)["stalk"] < was["stalk"]


def test_where_all_are_locked_or_hidden_that_is_said(run):
    text = TWO.read_text().replace("<g ", '<g style="display: none" ')
    assert "All gradient meshes, or their layers, are locked or hidden" in refused(run(text))


def test_a_clone_names_the_way_to_its_original(run):
    use = '<use id="u" xlink:href="#cap"/><use id="v" href="#u"/></svg>'
    text = TWO.read_text().replace("</svg>", use)
    for clone in "uv":
        assert refused(run(text, f"--id={clone}")).startswith(f"{clone} is a clone: Shift+D")


def test_clones_in_a_circle_end(run):
    circle = '<use id="u" xlink:href="#v"/><use id="v" href="#u"/><use id="w" href="#w"/></svg>'
    text = TWO.read_text().replace("</svg>", circle)
    for clone in "uvw":
        assert refused(run(text, f"--id={clone}")).startswith("None of the selected objects is painted")


@pytest.mark.full
def test_a_label_is_the_name(run, tmp_path):
    names = 'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" inkscape:label="the red cap"'
    run(TWO.read_text().replace('id="cap"', f'id="cap" {names}'), SMALL, "--id=cap", **ATTENDED)
    assert "the red cap: " in log(tmp_path)


def test_a_run_without_effect_names_the_amount_and_what_is_left(run):
    """Not always the second one: begun from what the first has left, it may find more."""
    document = (SAMPLES / "fruit.svg").read_text()
    left = handles(document)["pear"]
    while document := (done := run(document, SMALL, "--id=pear")).stdout:
        before, left = left, handles(document)["pear"]
        assert left < before
    assert refused(done).startswith(f"pear: as simple as Balanced allows, with {left} handles")


@pytest.mark.full
def test_a_whole_group_is_no_block(run):
    group = run(SAMPLES / "fruit.svg", SMALL, "--id=pear", "--result=blocks").stdout
    for item in ("merge", "refine"):
        said = refused(run(group, "--id=pear", item=item))
        assert said.startswith('apple.svg: group "pear": ')
        assert "double-click it, then select its blocks" in said or "after a double click" in said


def until(is_so):
    end = time.monotonic() + 60
    while not is_so():
        assert time.monotonic() < end
        time.sleep(0.05)


def test_a_copy_does_not_replace_the_drawing(run, tmp_path):
    """Inkscape writes the copy once the extension has ended, under a name that it tells nobody."""
    drawing, beside = tmp_path / "apple.svg", tmp_path / "apple-pictures-2.svg"
    original = (SAMPLES / "tensor.svg").read_bytes()
    drawing.write_bytes(original)
    (tmp_path / "apple-pictures.svg").write_text("another")
    done = run(drawing, item="publish", path=str(drawing), **ATTENDED)
    assert (done.returncode, done.stderr) == (0, "")
    drawing.write_text(done.stdout)
    until(beside.exists)
    until(lambda: drawing.read_bytes() == original)
    assert beside.read_text() == done.stdout
    until(lambda: "apple.svg stays as it is, with its meshes" in log(tmp_path))


def test_what_a_person_saves_meanwhile_is_no_copy(extension, tmp_path):
    drawing = tmp_path / "apple.svg"
    drawing.write_text("a drawing")
    watching = [PYTHON, "-c", "import gradmesh_keep as k, sys; k.PATIENCE = 1; k.main(*sys.argv[1:])", drawing, "00"]
    with subprocess.Popen(watching, cwd=extension, stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout.readline() == "ready\n"
        drawing.write_text("the drawing, saved again")
    assert child.returncode == 0
    assert drawing.read_text() == "the drawing, saved again" and len(list(tmp_path.iterdir())) == 1
