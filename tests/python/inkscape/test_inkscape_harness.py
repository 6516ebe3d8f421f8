"""The harness sets an extension's parameters, ends what hangs, and sees Inkscape's window."""

import os
import re
import subprocess
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

import displays
import inkscape_harness
from built import SAMPLES
from in_inkscape import needs
from displays import Timeout
from inkscape_harness import Inkscape

RAW_ID = "org.gradmesh.test_opacity"
INX = f"""<inkscape-extension xmlns="http://www.inkscape.org/namespace/inkscape/extension">
<name>Test</name><id>{RAW_ID}</id>
<param name="opacity" type="float" min="0" max="1" precision="2" gui-text="Opacity">1</param>
<effect><object-type>all</object-type><effects-menu><submenu name="Test"/></effects-menu></effect>
<script><command location="inx" interpreter="python">test_opacity.py</command></script>
</inkscape-extension>
"""
# Plain Python, not inkex: the harness is under test, not what else is installed.
EFFECT = """import sys
import xml.etree.ElementTree as ET
*options, svg = sys.argv[1:]
values = [option.split("=", 1) for option in options]
chosen = [value for name, value in values if name == "--id"]
tree = ET.parse(svg)
for element in tree.iter():
    if element.get("id") in chosen:
        element.set("opacity", dict(values)["--opacity"])
tree.write(sys.stdout.buffer)
"""


def extension(folder, code):
    (folder / "test_opacity.inx").write_text(INX)
    (folder / "test_opacity.py").write_text(code)
    return folder / "test_opacity.inx", folder / "test_opacity.py"


@needs()
def test_an_extension_gets_the_preset_value(tmp_path):
    out = tmp_path / "out.svg"
    with Inkscape(values={f"{RAW_ID}.opacity": "0.25"}) as inkscape:
        inkscape.install(*extension(tmp_path, EFFECT))
        inkscape.run_extension(RAW_ID, SAMPLES / "fruit.svg", out, select=["pear", "stem"])
    found = {element.get("id"): element.get("opacity") for element in ET.parse(out).iter()}
    assert (found["pear"], found["stem"], found["leaf"]) == ("0.25", "0.25", None)


@needs()
def test_what_an_extension_says_holds_nobody_up(tmp_path):
    out = tmp_path / "out.svg"
    with Inkscape() as inkscape:
        inkscape.install(*extension(tmp_path, "import sys\nsys.exit('Alas.')\n"))
        assert inkscape.said_by_extension(RAW_ID, SAMPLES / "tensor.svg", out, ["silk"]) == "Alas.\n"
    assert out.exists()


@needs()
def test_pages_are_painted_in_spite_of_a_crash(tmp_path):
    documents = [SAMPLES / "two.svg", tmp_path / "absent.svg", SAMPLES / "tensor.svg"]
    pictures = {svg: tmp_path / f"{svg.stem}.png" for svg in documents}
    with Inkscape() as inkscape:
        missing = inkscape.export_pages(pictures, dict.fromkeys(documents, 20))
    assert list(missing) == [documents[1]]
    assert ("crashed" in missing[documents[1]]) == inkscape_harness.is_older_than(1, 4)
    assert [png.exists() for png in pictures.values()] == [True, False, True]


@needs()
def test_pages_for_which_there_is_no_time_are_told(tmp_path):
    pictures = {SAMPLES / f"{name}.svg": tmp_path / f"{name}.png" for name in ("two", "tensor")}
    with Inkscape() as inkscape:
        missing = inkscape.export_pages(pictures, dict.fromkeys(pictures, 20), timeout=0.001)
    assert list(missing.values()) == ["Inkscape did not end in time", "there was no time left for it"]


@needs("ps", *displays.WINDOW_PROGRAMS)
@pytest.mark.full
def test_a_hanging_run_is_ended_with_all_it_started(tmp_path):
    with Inkscape() as inkscape:
        inkscape.install(*extension(tmp_path, "import time\ntime.sleep(1000)\n"))
        with pytest.raises(Timeout, match="no end after 15 s") as failure:
            inkscape.run_extension(
                RAW_ID, SAMPLES / "tensor.svg", tmp_path / "out.svg", select=["silk"], timeout=15
            )
        shot = Path(re.search(r"open: .*; the display: (.*\.png)", str(failure.value))[1])
        assert shot.stat().st_size > 0
        shot.unlink()
        home = str(inkscape.home)
        running = subprocess.run(["ps", "eww", "-eo", "args"], capture_output=True, text=True)
        assert [line for line in running.stdout.splitlines() if home in line] == []
    assert not os.path.exists(home)


@needs(*displays.WINDOW_PROGRAMS)
def test_the_window_shows_the_document(tmp_path):
    image = pytest.importorskip("PIL.Image")
    with Inkscape() as inkscape, inkscape.window(SAMPLES / "two.svg") as window:
        window.key("5")
        with image.open(window.screenshot(tmp_path / "shot.png")) as shot:
            assert shot.size == displays.SCREEN
            colours = shot.convert("RGB").getcolors(1 << 24)
    # The mushroom's cap, on the fitted page, is the only large red thing on the screen.
    red = sum(count for count, (r, g, b) in colours if r > 150 and g < 80 and b < 80)
    assert red > 50000
