"""File > Save a Copy as code for apps."""

import pytest

from built import SAMPLES
from extension_runs import extension, run  # noqa: F401

import gradmesh

ITEMS = [("swift", "import SwiftUI"), ("compose", "import androidx.compose")]


@pytest.mark.parametrize("item, words", ITEMS)
@pytest.mark.full(all_but=1)
def test_a_copy_is_the_code_of_all_meshes(run, item, words):
    done = run(SAMPLES / "two.svg", item=item)
    assert (done.returncode, done.stderr) == (0, "")
    made = gradmesh.publish_code(gradmesh.load(SAMPLES / "two.svg"), item)
    # The first line names the file that Inkscape hands over.
    assert done.stdout.split("\n", 1)[1] == made.source.split("\n", 1)[1]
    assert done.stdout.startswith("// Made by gradmesh ") and words in done.stdout


@pytest.mark.parametrize("item, words", ITEMS)
def test_what_is_lost_is_told(run, tmp_path, item, words):
    done = run(SAMPLES / "stroke.svg", item=item)
    assert words in done.stdout and done.stderr == ""
    log = (tmp_path / "cache" / "gradmesh" / "extension.log").read_text()
    assert "all of the mesh is painted, not only the stroke." in log


@pytest.mark.parametrize("item, words", ITEMS)
def test_a_drawing_without_meshes_is_refused(run, tmp_path, item, words):
    drawing = tmp_path / "empty.svg"
    drawing.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>')
    done = run(drawing, item=item)
    assert words not in done.stdout and "mesh" in done.stderr
