"""Simplify by Eye in the real Inkscape: its window over a document, by mouse and by keys."""

import time
import xml.etree.ElementTree as ET
from concurrent.futures import ThreadPoolExecutor

import pytest

import inkscape_harness
from built import SAMPLES, install_extension
from extension_runs import extension, refused, run  # noqa: F401
from inkscape_harness import Inkscape
from windows import Started

import gradmesh

reason = inkscape_harness.missing("xdotool", "import")
pytestmark = pytest.mark.skipif(bool(reason), reason=reason or "nothing is missing")

#: The picture, where the window is in the upper left corner of the display.
PICTURE = (0, 0, 820, 860)
#: The line from the stem down the pear's middle.
LINE = (412, 591)
#: A drag within one of the pear's rows, over four patches.
ALONG_A_ROW = (235, 572, 445, 572)
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
        with inkscape.window(svg, actions=["select-by-id:pear"]) as window:
            window.key("5")
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


def rectangles(svg):
    return len([element for element in ET.parse(svg).iter() if element.tag.endswith("}rect")])


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


@pytest.mark.full
def test_inkscape_puts_no_box_of_its_own_above_the_window(by_eye):
    by_eye.key("End")
    assert sorted(by_eye.titles()) == sorted(["fruit.svg - Simplify by Eye", "fruit.svg - Inkscape"])


@pytest.mark.full
def test_clicks_on_the_waiting_inkscape_neither_cover_the_window_nor_are_answered_later(tmp_path, svg):
    reason = inkscape_harness.missing("openbox", "xprop")
    if reason:
        pytest.skip(reason)
    rectangle_tool, page, before = (13, 217), (1300, 700), rectangles(svg)
    with Inkscape() as inkscape, Started(["openbox"], inkscape.env, 60):
        inkscape.install(install_extension(tmp_path / "installed"))
        inkscape.set_key("F10", "app.org.gradmesh.simplify-by-eye")
        with inkscape.window(svg, actions=["select-by-id:pear"]) as window:
            window.open_window("F10", "Simplify by Eye")
            window.xdotool("windowmove", window.find_window("Simplify by Eye"), "100", "60")
            own, waiting = (window.find_window(title) for title in ("Simplify by Eye", "Inkscape"))
            assert int(window.property(own, "WM_TRANSIENT_FOR"), 16) == int(waiting)
            assert "SKIP_TASKBAR" in window.property(own, "_NET_WM_STATE")
            window.click(*rectangle_tool)
            in_front = window.property("root", "_NET_CLIENT_LIST_STACKING").split(", ")[-1]
            assert int(in_front, 16) == int(own)
            window.xdotool("windowfocus", own)
            window.key("End", "ctrl+Return")
            window.close_window()
            window.drag(*page, *(each + 60 for each in page))
            window.key("ctrl+s")
    assert pear(svg).handles < 660, "what was made in the window is written"
    assert rectangles(svg) == before, "the tool is the one that it was"


@pytest.mark.full
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


@pytest.mark.full
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


@pytest.mark.full
def test_cancelled_the_document_is_as_it_was(by_eye, svg):
    before = svg.read_bytes()
    by_eye.key("End")
    by_eye.key("Escape")
    by_eye.close_window()
    by_eye.key("ctrl+s")
    assert svg.read_bytes() == before


#: A program in the place of gradmesh that tells how it was called.
TELLS = """#!/bin/sh
echo "$@" >"$TOLD"
"""


@pytest.fixture
def told(run, tmp_path):
    """Runs Simplify by Eye with a program in the place of the window's; how that was called."""
    program = tmp_path / "tells"
    program.write_text(TELLS)
    program.chmod(0o755)

    def told(**env):
        env = {"GRADMESH_CORE": "module", "GRADMESH_HELPER": str(program), "GRADMESH_UNATTENDED": "0", **env}
        done = run(SAMPLES / "two.svg", "--id=cap", item="simplify_by_eye", TOLD=str(tmp_path / "told"), **env)
        assert (done.returncode, done.stderr) == (0, "")
        return (tmp_path / "told").read_text().split()

    return told


@pytest.mark.parametrize("saved, theme", [("1", "dark"), ("0", "light")])
@pytest.mark.full(all_but=1)
def test_the_window_is_as_inkscape_is(told, tmp_path, saved, theme):
    (tmp_path / "preferences.xml").write_text(
        f'<inkscape version="1"><group id="theme" preferDarkTheme="{saved}"/></inkscape>'
    )
    words = told(INKSCAPE_PROFILE_DIR=str(tmp_path), LANGUAGE="de")
    assert words[words.index("--theme") + 1] == theme
    assert words[words.index("--language") + 1] == "de"
    assert [word for word in words if word.startswith("--id")] == ["--id=cap"]


def test_where_inkscape_does_not_say_the_desktop_decides(told, tmp_path):
    words = told(INKSCAPE_PROFILE_DIR=str(tmp_path))
    assert "--theme" not in words and words[words.index("--language") + 1] == "en"


def test_without_a_display_a_sentence_names_the_dialog(run):
    env = {"GRADMESH_UNATTENDED": "0", "SDL_VIDEODRIVER": "x11"}
    said = refused(run(SAMPLES / "two.svg", item="simplify_by_eye", **env))
    assert said.startswith("No window can be shown here: ")
    assert said.endswith("Extensions > Gradient Mesh > Simplify does the same by numbers.\n")
    german = refused(run(SAMPLES / "two.svg", item="simplify_by_eye", **env, LANGUAGE="de"))
    assert german.startswith("Hier kann kein Fenster gezeigt werden: ")
    assert german.endswith("Verlaufsgitter > Vereinfachen tut dasselbe mit Zahlen.\n")


def test_nobody_is_shown_a_window_where_nobody_is(run):
    done = run(SAMPLES / "two.svg", item="simplify_by_eye", GRADMESH_UNATTENDED="1")
    assert done.returncode != 0 and done.stdout == ""


def test_a_second_window_on_a_document_is_refused(run, tmp_path):
    """The lock is the document's; a run that waits for its window holds it."""
    waits = tmp_path / "waits"
    waits.write_text('#!/bin/sh\ntouch "$TOLD"\nwhile [ -e "$TOLD" ]; do sleep 0.1; done\n')
    waits.chmod(0o755)
    flag = tmp_path / "told"
    env = {"GRADMESH_CORE": "module", "GRADMESH_HELPER": str(waits), "GRADMESH_UNATTENDED": "0", "TOLD": str(flag)}
    with ThreadPoolExecutor() as pool:
        first = pool.submit(run, SAMPLES / "two.svg", item="simplify_by_eye", **env)
        while not flag.exists():
            assert not first.done(), first.result()
            time.sleep(0.1)
        said = refused(run(SAMPLES / "two.svg", item="simplify_by_eye", GRADMESH_UNATTENDED="0"))
        flag.unlink()
        assert first.result().returncode == 0
    assert said == "Simplify by Eye is open on this document already.\n"
