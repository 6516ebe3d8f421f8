"""Simplify by Eye in the real Inkscape: its window over a document, by mouse and by keys."""

import os
import subprocess
import xml.etree.ElementTree as ET

import pytest

import inkscape_harness
from built import PYTHON, ROOT, SAMPLES, install_extension
from inkscape_harness import Inkscape

import gradmesh

reason = inkscape_harness.missing("xdotool", "import")
pytestmark = pytest.mark.skipif(bool(reason), reason=reason or "nothing is missing")

PEAR = (750, 480)
#: The picture, where the window is in the upper left corner of the display.
PICTURE = (0, 0, 700, 840)
#: The line from the stem down the pear's middle.
LINE = (360, 564)
#: A drag within one of the pear's rows, over four patches.
ALONG_A_ROW = (250, 564, 470, 564)
#: Beside the window.
NOWHERE = ("1300", "900")


@pytest.fixture
def svg(tmp_path):
    svg = tmp_path / "fruit.svg"
    svg.write_bytes((SAMPLES / "fruit.svg").read_bytes())
    return svg


@pytest.fixture
def by_eye(tmp_path, svg):
    """Inkscape's window and a function that opens Simplify by Eye on the pear."""
    with Inkscape() as inkscape:
        inkscape.install(install_extension(tmp_path / "installed"))
        inkscape.set_key("F10", "app.org.gradmesh.simplify-by-eye")
        with inkscape.window(svg) as window:
            window.key("5")
            window.click(*PEAR)
            window.xdotool("mousemove", *NOWHERE)
            window.open_window("F10", "Simplify by Eye")
            yield window


def picture_of(window, tmp_path):
    image = pytest.importorskip("PIL.Image")
    with image.open(window.screenshot(tmp_path / "shot.png")) as shot:
        return shot.convert("RGB").crop(PICTURE).tobytes()


def pear(svg):
    (found,) = (mesh for mesh in gradmesh.load(svg).meshes if mesh.id == "pear")
    return found


def test_what_is_chosen_is_written_in_one_step_of_undo(by_eye, svg, tmp_path):
    before, handles = svg.read_bytes(), pear(svg).handles
    seen = [picture_of(by_eye, tmp_path)]
    by_eye.key("End")
    seen.append(picture_of(by_eye, tmp_path))
    by_eye.key("ctrl+z")
    seen.append(picture_of(by_eye, tmp_path))
    by_eye.key("ctrl+shift+z")
    seen.append(picture_of(by_eye, tmp_path))
    assert seen[0] == seen[2] != seen[1] == seen[3]
    by_eye.key("ctrl+Return")
    by_eye.close_window()
    # Undone, Inkscape has nothing to save; one change more or less and it had.
    by_eye.key("ctrl+z")
    by_eye.key("ctrl+s")
    assert svg.read_bytes() == before
    by_eye.key("ctrl+shift+z")
    by_eye.key("ctrl+s")
    after = pear(svg)
    assert after.handles < handles / 4
    (path,) = [element for element in ET.parse(svg).iter() if element.get("id") == "pear"]
    assert path.tag == "{http://www.w3.org/2000/svg}path"


def test_a_line_is_taken_out_by_a_click_and_what_is_protected_stays(by_eye, svg, tmp_path):
    patches = pear(svg).patches
    untouched = picture_of(by_eye, tmp_path)
    by_eye.drag(60, 30, 640, 300)  # across the stem's end
    marked = picture_of(by_eye, tmp_path)
    assert marked != untouched
    by_eye.key("p")
    hatched = picture_of(by_eye, tmp_path)
    assert hatched not in (marked, untouched)
    by_eye.key("ctrl+z")
    assert picture_of(by_eye, tmp_path) == untouched
    by_eye.click(*LINE)
    by_eye.key("ctrl+Return")
    by_eye.close_window()
    by_eye.key("ctrl+s")
    assert pear(svg).patches < patches


def test_keys_show_what_is_known_and_take_the_brush(by_eye, svg, tmp_path):
    before, plain = pear(svg).patches, picture_of(by_eye, tmp_path)
    seen = []
    for _choice in ("prices", "regions", "parts", "nothing"):
        by_eye.key("s")
        seen.append(picture_of(by_eye, tmp_path))
    # Regions are those of a patch, and none is pointed at.
    assert seen[1] == seen[3] == plain and len({*seen}) == 3
    by_eye.key("t")
    by_eye.drag(*ALONG_A_ROW)
    assert picture_of(by_eye, tmp_path) != plain
    by_eye.key("Return")
    by_eye.key("ctrl+Return")
    by_eye.close_window()
    by_eye.key("ctrl+s")
    assert pear(svg).patches == before - 3, "one of four"


def test_cancelled_the_document_is_as_it_was(by_eye, svg):
    before = svg.read_bytes()
    by_eye.key("End")
    by_eye.key("Escape")
    by_eye.close_window()
    by_eye.key("ctrl+s")
    assert svg.read_bytes() == before


def printed_on_a_display(code, **env):
    """What a program prints that knows GTK and the small parts of windows."""
    code = f"import gi\ngi.require_version('Gtk', '3.0')\nimport gradmesh_widgets\n{code}"
    with inkscape_harness.Display() as display:
        env = {**os.environ, "DISPLAY": display.name, **env}
        done = subprocess.run(
            [PYTHON, "-c", code],
            env={**env, "GSETTINGS_BACKEND": "memory", "PYTHONPATH": str(ROOT / "extension")},
            capture_output=True,
            text=True,
            timeout=60,
        )
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


#: Prints whether windows are dark before and after Inkscape's preferences were read.
IS_DARK = """
before = gradmesh_widgets.is_dark()
gradmesh_widgets.prefer_dark()
print(before, gradmesh_widgets.is_dark())
"""


@pytest.mark.parametrize("saved, seen", [("1", "False True"), ("0", "False False")])
def test_it_is_dark_where_inkscape_is(tmp_path, saved, seen):
    (tmp_path / "preferences.xml").write_text(
        f'<inkscape version="1"><group id="theme" preferDarkTheme="{saved}"/></inkscape>'
    )
    assert printed_on_a_display(IS_DARK, INKSCAPE_PROFILE_DIR=str(tmp_path)) == seen


def test_no_window_is_larger_than_the_screen():
    width, height = inkscape_harness.SCREEN
    asked = f"print(*gradmesh_widgets.as_fits_the_screen(({width + 1}, {height - 1})))"
    assert printed_on_a_display(asked) == f"{width} {height - 1}"
    assert printed_on_a_display(asked, GDK_SCALE="2") == f"{width // 2} {height // 2}"
