"""What Inkscape writes as PDF comes back: our samples with their meshes, and strokes."""

import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest

import displays
from built import SAMPLES, gradmesh
from in_inkscape import inkscape, needs  # noqa: F401
from pictures import error, export
from program import listed
from svg_meshes import SVG, Document, apply, declared

pytestmark = needs()

#: Inkscape writes no mesh for ellipse.svg, whose gradient is in objectBoundingBox, and a picture for transformed.svg.
SAMPLES_WITH_MESHES = ["face", "fruit", "opacity", "photo", "smooth", "stroke", "tensor", "two"]


def as_pdf(inkscape, source, pdf):
    displays.run(["inkscape", f"--export-filename={pdf}", str(source)], inkscape.env, inkscape.timeout)
    return pdf


def read_back(pdf, back):
    """Makes an SVG document of a PDF; skips the test where gradmesh was built without PDF."""
    done = gradmesh("convert", pdf, back)
    if "was built without PDF" in done.stderr:
        pytest.skip(done.stderr.strip())
    assert (done.returncode, done.stderr) == (0, "")
    return back


def colors(mesh):
    """The colour and the opacity at the beginning of each side of each patch."""
    return np.array([side["color"] for side in mesh["elements"]["halfedges"]])


@pytest.fixture(scope="module")
def read_samples(inkscape, tmp_path_factory):
    """Each sample and what came back of it."""
    folder = tmp_path_factory.mktemp("pdf")
    sources = [SAMPLES / f"{name}.svg" for name in SAMPLES_WITH_MESHES]
    for source in sources:
        as_pdf(inkscape, source, folder / f"{source.stem}.pdf")
    return {s.stem: (s, read_back(folder / f"{s.stem}.pdf", folder / f"{s.stem}.svg")) for s in sources}


@pytest.mark.parametrize("name", SAMPLES_WITH_MESHES)
@pytest.mark.full(all_but=1)
def test_a_sample_comes_back(read_samples, name):
    source, back = read_samples[name]
    was, now = listed(source)["meshes"], listed(back)["meshes"]
    assert len(now) == len(was)
    documents = Document(source), Document(back)
    for before, after in zip(was, now):
        assert after["smooth"] == before["smooth"]
        elements = [document.by_id[mesh["id"]] for document, mesh in zip(documents, (before, after))]
        nets = [apply(d.to_document(e), d.net(e)) for d, e in zip(documents, elements)]
        assert nets[0].shape == nets[1].shape  # The same rows and columns.
        assert np.abs(nets[1] - nets[0]).max() < 0.001
        # The object's own opacity comes back as that of the stops.
        own = float(declared(elements[0]).get("opacity", 1))
        differs = np.abs(colors(after) - colors(before) * [1, 1, 1, own])
        assert differs[:, :3].max() < 1e-6
        assert differs[:, 3].max() < 1 / 255


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
@pytest.mark.full(all_but=1)
def test_a_stroke_comes_back(inkscape, tmp_path, style):
    source = document(tmp_path / "stroke.svg", style)
    pdf, back = tmp_path / "stroke.pdf", tmp_path / "back.svg"
    read_back(as_pdf(inkscape, source, pdf), back)
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
