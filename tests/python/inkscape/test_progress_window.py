"""The small window beside long work: what it shows, and that stopping keeps the best so far."""

import json
import re
import subprocess
import xml.etree.ElementTree as ET

import pytest

import displays
import inkscape_harness
from built import PYTHON, SAMPLES
from extension_runs import extension, run  # noqa: F401

import gradmesh

LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
#: Of the sample "photo", by the method: what is counted, and how many there are.
ALL = {"gqe": ("patches", 400), "one-mesh": ("handles", 961)}

reason = inkscape_harness.missing()
GTK = "import gi; gi.require_version('Gtk', '3.0')"
if not reason and subprocess.run([PYTHON, "-c", GTK], stderr=subprocess.DEVNULL).returncode:
    reason = "not installed: gir1.2-gtk-3.0"
pytestmark = pytest.mark.skipif(bool(reason), reason=reason or "nothing is missing")

#: What both of the drivers below look at windows with.
LOOKING = """
import json, re, sys, threading
import gi
gi.require_version("Gtk", "3.0")
from gi.repository import GLib, Gtk

def inside(widget, kind):
    if isinstance(widget, kind):
        yield widget
    elif isinstance(widget, Gtk.Container):
        for child in widget.get_children():
            yield from inside(child, kind)
"""

#: Runs Simplify with somebody who looks at the window and stops the work in the way `stop` names,
#: once patches were merged, or handles taken out. The work waits for that, so it is never too quick.
DRIVER = LOOKING + """
import gradmesh_simplify, gradmesh_window

stop, all_of_it, seen_file, _script, *arguments = sys.argv[1:]
seen, stopped = [], threading.Event()

class Waiting(gradmesh_window.LongWork):
    def _progress(self, now):
        goes_on = super()._progress(now)
        if (now.handles or now.patches) >= int(all_of_it):
            return goes_on
        assert stopped.wait(60)
        return self._stop is False

def shown(window):
    (bar,), (button,) = inside(window, Gtk.ProgressBar), inside(window, Gtk.Button)
    title, words, _ = (label.get_text() for label in inside(window, Gtk.Label))
    return {
        "window": window.get_title(), "title": title, "words": words, "share": bar.get_fraction(),
        "button": button.get_label(), "can stop": button.is_visible() and button.is_sensitive(),
    }

def look():
    windows = Gtk.Window.list_toplevels()
    now = shown(windows[0]) if windows else {"words": ""}
    left = re.match("[0-9]+", now["words"])
    if not seen and left and int(left[0]) < int(all_of_it):
        seen.append(now)
        if stop == "button":
            next(inside(windows[0], Gtk.Button)).clicked()
        else:
            windows[0].close()
    elif seen and now["words"] != seen[0]["words"]:
        seen.append(now)
        with open(seen_file, "w") as file:
            json.dump(seen, file)
        stopped.set()
        return False
    return True

gradmesh_window.PATIENCE = 0
gradmesh_simplify.LongWork = Waiting
GLib.timeout_add(20, look)
gradmesh_simplify.Simplify().run(arguments)
"""


@pytest.fixture(scope="module")
def display():
    with displays.Display() as display:
        yield display.name


@pytest.mark.parametrize("stop, result", [("button", "gqe"), ("close", "gqe"), ("button", "one-mesh")])
@pytest.mark.full(all_but=1)
def test_the_window_tells_and_stops(run, display, tmp_path, stop, result):
    seen = tmp_path / "seen.json"
    what, before = ALL[result]
    options = ["--id=photo", f"--result={result}", "--amount=strong", "--resolution=100"]
    driver = (PYTHON, "-c", DRIVER, stop, str(before), str(seen))
    done = run(SAMPLES / "photo.svg", *options, python=driver, DISPLAY=display)
    assert (done.returncode, done.stderr) == (0, "")

    running, stopped = json.loads(seen.read_text())
    assert (running["window"], running["title"]) == ("Gradient Mesh", "Simplifying photo")
    left = int(re.fullmatch(rf"(\d+) {what} so far", running["words"])[1])
    assert 0 < left < before and 0 <= running["share"] < 1
    # gqe tells of a mesh that its first search has found before that search is done.
    assert running["share"] > 0 or result == "gqe"
    assert (running["button"], running["can stop"]) == ("Stop", True)
    assert (stopped["words"], stopped["can stop"]) == ("Stopping: the best so far is kept …", False)

    (photo,) = gradmesh.loads(done.stdout).meshes
    kept = getattr(photo, what)
    if result == "gqe":
        # What other threads had begun is done by then, and is kept where it is better than what was told.
        assert 0 < kept <= left
        (group,) = [e for e in ET.fromstring(done.stdout).iter() if e.get("id") == "photo"]
        assert f", {kept} of {before} patches" in group.get(LABEL)
    else:
        assert kept == left


#: Runs Trace Picture with somebody who waits for a picture of the mesh, and then stops the work.
TRACE_DRIVER = LOOKING + """
import gradmesh_trace, gradmesh_window

seen_file, _script, *arguments = sys.argv[1:]
stopped = threading.Event()

class Waiting(gradmesh_window.LongWork):
    def _progress(self, now):
        assert not self.picture or stopped.wait(60)
        return super()._progress(now)

def look():
    for window in Gtk.Window.list_toplevels():
        pictures = [image.get_pixbuf() for image in inside(window, Gtk.Image) if image.get_pixbuf()]
        for picture in pictures:
            middle = 3 * (picture.get_width() // 2) + picture.get_rowstride() * (picture.get_height() // 2)
            title = next(inside(window, Gtk.Label)).get_text()
            size = [picture.get_width(), picture.get_height()]
            with open(seen_file, "w") as file:
                json.dump({"title": title, "size": size, "middle": list(picture.get_pixels()[middle:middle + 3])}, file)
            next(inside(window, Gtk.Button)).clicked()
            stopped.set()
            return False
    return True

gradmesh_window.PATIENCE = 0
gradmesh_trace.LongWork = Waiting
GLib.timeout_add(20, look)
gradmesh_trace.Trace().run(arguments)
"""


def test_the_window_shows_the_mesh_so_far_of_a_picture(run, display, tmp_path):
    seen = tmp_path / "seen.json"
    driver = (PYTHON, "-c", TRACE_DRIVER, str(seen))
    done = run(SAMPLES / "photographs" / "apple.svg", "--id=apple", python=driver, DISPLAY=display)
    assert (done.returncode, done.stderr) == (0, "")
    told = json.loads(seen.read_text())
    assert told["title"] == "Tracing apple" and max(told["size"]) <= 320 and min(told["size"]) > 150
    red, green, blue = told["middle"]
    assert red > 150 > 100 > max(green, blue)
    (mesh,) = gradmesh.loads(done.stdout).meshes
    assert mesh.id == "apple" and 4 <= mesh.handles < 100


def test_the_window_names_a_picture_without_a_label_by_no_id(run, display, tmp_path):
    seen = tmp_path / "seen.json"
    driver = (PYTHON, "-c", TRACE_DRIVER, str(seen))
    run(SAMPLES / "photographs" / "apple.svg", "--id=photograph", python=driver, DISPLAY=display)
    assert json.loads(seen.read_text())["title"] == "Tracing the picture"
