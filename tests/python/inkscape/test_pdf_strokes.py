"""Strokes that Inkscape writes as PDF come back with their meshes."""

import re
import xml.etree.ElementTree as ET

import pytest

import inkscape_harness
from built import SAMPLES, gradmesh
from in_inkscape import inkscape, needs  # noqa: F401
from pictures import error, export
from program import listed
from svg_meshes import SVG, declared

pytestmark = needs()

#: FLIP between what Inkscape paints of the sample and of what came back.
SAME = 0.01
STYLE = {"stroke-width": "40", "stroke-linecap": "round", "stroke-linejoin": "bevel"}
#: Of opacities Inkscape writes these two, but not that of the stroke.
CASES = {
    "sample": {},
    "dashes": {**STYLE, "stroke-dasharray": "60,45", "stroke-dashoffset": "12", "opacity": "0.5"},
    "stops": {**STYLE, "stop-opacity": "0.6"},
}


def document(path, style):
    """The sample without its paper, with another stroke."""
    text = re.sub('<rect id="background".*?/>', "", (SAMPLES / "stroke.svg").read_text())
    for name, value in style.items():
        text, count = re.subn(rf"(?<![-\w]){name}:[^;\"]*", f"{name}:{value}", text)
        if not count:
            text = text.replace("fill:none;", f"fill:none;{name}:{value};")
    path.write_text(text)
    return path


@pytest.mark.parametrize("style", CASES.values(), ids=CASES)
def test_a_stroke_comes_back(inkscape, tmp_path, style):
    source = document(tmp_path / "stroke.svg", style)
    pdf, back = tmp_path / "stroke.pdf", tmp_path / "back.svg"
    inkscape_harness.run(["inkscape", f"--export-filename={pdf}", str(source)], inkscape.env, inkscape.timeout)
    done = gradmesh("convert", pdf, back)
    if "was built without PDF" in done.stderr:
        pytest.skip(done.stderr.strip())
    assert (done.returncode, done.stderr) == (0, "")
    (was,), (now,) = listed(source)["meshes"], listed(back)["meshes"]
    for key in ("role", "handles", "patches", "points", "t_junctions"):
        assert now[key] == was[key], key
    ends = [ET.parse(path) for path in (source, back)]
    rows = [[len(row) for row in end.iter(SVG + "meshrow")] for end in ends]
    assert rows[0] == rows[1]
    before, after = (declared(end.find(f".//{SVG}path[@id='{mesh['id']}']")) for end, mesh in zip(ends, (was, now)))
    for name in ("stroke-width", "stroke-dashoffset"):
        assert float(after.get(name, 0)) == pytest.approx(float(before.get(name, 0)), abs=1e-4), name
    for name, initial in {"stroke-linecap": "butt", "stroke-linejoin": "miter"}.items():
        assert after[name] == before.get(name, initial)
    assert error(*export(inkscape, [source, back])) < SAME
