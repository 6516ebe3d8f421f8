"""The line at the lower end of the screen: what it says instead of Inkscape's alarm, and for how long it stays."""

import shutil
import subprocess
import time

import pytest

import displays
import inkscape_harness
from built import PYTHON, SAMPLES
from extension_runs import SMALL, extension, refused, run  # noqa: F401

reason = inkscape_harness.missing()
GTK = "import gi; gi.require_version('Gtk', '3.0')"
if not reason and subprocess.run([PYTHON, "-c", GTK], stderr=subprocess.DEVNULL).returncode:
    reason = "not installed: gir1.2-gtk-3.0"
pytestmark = pytest.mark.skipif(bool(reason), reason=reason or "nothing is missing")

RECT = '<rect id="spot" width="9" height="9"/></svg>'
ONE, TWO = "This is said.", "This is said. And this is, too."


@pytest.fixture(scope="module")
def screen():
    with displays.Display() as display:
        yield display.name


@pytest.fixture
def seen(run, screen):
    """Runs an item where a line can be seen."""
    return lambda *arguments, **how: run(*arguments, DISPLAY=screen, GRADMESH_UNATTENDED="0", **how)


def log(tmp_path):
    return (tmp_path / "cache" / "gradmesh" / "extension.log").read_text()


@pytest.mark.parametrize(
    "item, options, words",
    [
        ("simplify", ["--id=spot"], "None of the selected objects"),
        ("simplify", ["--id=pear", "--limit=epsilon", "--amount=custom", "--epsilon=0", SMALL], "within an error of 0"),
        ("merge", [], "Select two or more blocks"),
        ("merge", ["--id=stem"], "no block of a simplified mesh"),
        ("refine", ["--id=pear", "--row=99"], "no row 99"),
        ("update", [], "Select an object"),
        ("update", ["--id=pear"], "one mesh gradient needs no update"),
        ("show_analysis", ["--id=spot"], "None of the selected objects"),
        ("remove_analysis", [], "There is no analysis"),
        ("to_one_mesh", ["--id=spot"], "None of the selected objects"),
        ("trace", [], "There is no picture"),
        ("more_detail", [], "Draw a shape"),
        ("pages", ["--file="], "Choose a PDF"),
        ("simplify_by_eye", ["--id=spot"], "None of the selected objects"),
    ],
)
@pytest.mark.full(all_but=1)
def test_what_is_no_fault_is_no_alarm(seen, tmp_path, item, options, words):
    text = (SAMPLES / "fruit.svg").read_text().replace("</svg>", RECT)
    done = seen(text, *options, item=item)
    assert done.returncode != 0 and (done.stdout, done.stderr) == ("", "")
    assert words in log(tmp_path)


@pytest.mark.parametrize(
    "item, options, words",
    [
        ("simplify", [], "not a readable SVG"),
        ("pages", ["--file=/gone.pdf"], "gone.pdf"),
        ("save", [], "holds one gradient mesh"),
    ],
)
@pytest.mark.full(all_but=1)
def test_faults_and_files_that_are_not_written_are_one(seen, item, options, words):
    document = "<svg" if item == "simplify" else SAMPLES / "two.svg"
    assert words in refused(seen(document, *options, item=item))


def test_what_merging_costs_is_in_the_line(seen, tmp_path):
    done = seen(SAMPLES / "fruit.svg", "--id=pear", "--first_row=2", "--last_row=3", "--first_column=4", item="merge")
    assert (done.returncode, done.stderr) == (0, "")
    assert "pear: these patches are one now." in log(tmp_path) and "ImportWarning" not in log(tmp_path)


def test_how_long_it_stays(extension):
    check = (
        "from gradmesh_toast import seconds_to_read, stays_until_clicked as stays\n"
        "print([seconds_to_read('word ' * n) for n in (3, 30)])\n"
        "print([stays(text) for text in ('Off by 0.3 of 255.', 'Das ist z. B. eins.', 'One. Two.', 'a “b.” C.')])\n"
    )
    done = subprocess.run([PYTHON, "-c", check], cwd=extension, capture_output=True, text=True, timeout=60)
    assert done.stdout.splitlines() == ["[3.0, 12.0]", "[False, False, True, True]"], done.stderr


@pytest.fixture
def line(extension, screen, tmp_path):
    """Begins a line; the process."""
    lines = []

    def begin(text, document=""):
        script = "import gradmesh_toast as t, sys; t.SECONDS_TO_NOTICE = 1; t.show(*sys.argv[1:])"
        command = [PYTHON, "-c", script, text, str(document)]
        env = {**inkscape_harness.os.environ, "DISPLAY": screen, "XDG_CACHE_HOME": str(tmp_path)}
        lines.append(subprocess.Popen(command, cwd=extension, env=env))
        end = time.monotonic() + 60
        while str(lines[-1].pid) != (latest.read_text() if latest.exists() else ""):
            assert time.monotonic() < end and lines[-1].poll() is None
            time.sleep(0.05)
        return lines[-1]

    latest = tmp_path / "gradmesh" / "line"
    latest.parent.mkdir()
    yield begin
    for each in lines:
        each.kill()
        each.wait()


def test_a_sentence_goes_by_itself(line):
    assert line(ONE).wait(60) == 0


def test_sentences_go_by_a_click(line, screen):
    process = line(TWO)
    time.sleep(3)
    assert process.poll() is None
    env = {**inkscape_harness.os.environ, "DISPLAY": screen}
    width, height = displays.SCREEN
    subprocess.run(["xdotool", "mousemove", str(width // 2), str(height - 90), "click", "1"], env=env, check=True)
    assert process.wait(60) == 0


def test_no_window_manager_gives_it_the_focus(line, screen):
    """With the focus on it, or on nobody as it came, keys would not reach Inkscape."""
    if not shutil.which("xwininfo"):
        pytest.skip("xwininfo is not installed")
    line(TWO)
    command = ["xwininfo", "-display", screen, "-name", "gradmesh"]
    end = time.monotonic() + 60
    while (told := subprocess.run(command, capture_output=True, text=True)).returncode:
        assert time.monotonic() < end
        time.sleep(0.1)
    assert "Override Redirect State: yes" in told.stdout


def test_the_next_line_takes_the_place_of_the_one_before(line):
    before, after = line(TWO), line(TWO)
    assert before.wait(60) == 0 and after.poll() is None


def test_it_stays_while_inkscape_shows_a_live_preview(line, tmp_path):
    copy = tmp_path / "ink_ext_XXXXXX.svgABC123"
    copy.touch()
    process = line(ONE, copy)
    time.sleep(3)
    assert process.poll() is None
    copy.unlink()
    assert process.wait(60) == 0
