"""The extension in Inkscape's window: from the menu, through its dialog, and one undo back."""

import xml.etree.ElementTree as ET

import pytest

import inkscape_harness
from built import SAMPLES, install_extension
from inkscape_harness import Inkscape

reason = inkscape_harness.missing(*inkscape_harness.WINDOW_PROGRAMS)
pytestmark = pytest.mark.skipif(bool(reason), reason=reason or "nothing is missing")

# Where things are on the harness's screen once the page fits the window.
PEAR, SUBMENU, SIMPLIFY = (750, 480), (460, 238), (779, 339)
SIMPLIFY_TAB, METHOD_TAB = (58, 30), (215, 30)
STRONG, ONLY_SAY, APPLY, CLOSE = (313, 152), (35, 410), (554, 510), (465, 510)
DIALOG, CANVAS, STATUS = (0, 0, 598, 528), (620, 140, 1370, 900), (450, 960, 1060, 1000)


def test_say_apply_and_undo(tmp_path):
    image = pytest.importorskip("PIL.Image")
    svg = tmp_path / "fruit.svg"
    svg.write_bytes((SAMPLES / "fruit.svg").read_bytes())

    def seen(window, area):
        with image.open(window.screenshot(tmp_path / "shot.png")) as shot:
            return shot.convert("RGB").crop(area).tobytes()

    with Inkscape() as inkscape:
        inkscape.install(install_extension(tmp_path / "installed"))
        with inkscape.window(svg) as window:
            window.key("5")
            window.click(*PEAR)
            at_first = seen(window, DIALOG), seen(window, CANVAS), seen(window, STATUS)

            window.key("alt+n")
            window.click(*SUBMENU)
            window.click(*SIMPLIFY)
            dialog = seen(window, DIALOG)
            assert dialog != at_first[0], "no dialog opened"

            window.click(*METHOD_TAB)
            method = seen(window, DIALOG)
            assert method != dialog
            window.click(*ONLY_SAY)
            ticked = seen(window, DIALOG)
            assert ticked != method
            window.click(*APPLY)
            assert seen(window, DIALOG) != ticked, "nothing is said"
            window.key("Escape")
            assert (seen(window, CANVAS), seen(window, STATUS)) == at_first[1:]

            window.click(*ONLY_SAY)
            window.click(*SIMPLIFY_TAB)
            window.click(*STRONG)
            window.click(*APPLY)
            window.click(*CLOSE)
            assert seen(window, STATUS) != at_first[2], "the selected object is still a path"

            window.key("ctrl+z")
            window.click(*PEAR)
            # Inkscape paints tiles anew, other ones than at first: some pixels are a level off.
            levels = zip(seen(window, CANVAS), at_first[1])
            assert max(abs(now - before) for now, before in levels) <= 1
            assert seen(window, STATUS) == at_first[2]

            # Inkscape knows that all is as it was, and has nothing to save.
            window.key("ctrl+s")
            assert svg.read_bytes() == (SAMPLES / "fruit.svg").read_bytes()

            window.key("ctrl+shift+z")
            window.key("ctrl+s")
    (pear,) = [element for element in ET.parse(svg).iter() if element.get("id") == "pear"]
    assert pear.tag == "{http://www.w3.org/2000/svg}g"
