"""Trace Picture makes meshes of what paths surround in pictures, when run as Inkscape runs it."""

import base64
import io
import json
import re
from collections import Counter

import numpy as np
import pytest
from PIL import Image

import inkscape_harness
from extension_runs import INKEX, SVG, by_id, extension, refused, run  # noqa: F401
from in_inkscape import inkscape, needs  # noqa: F401
from pictures import export

import gradmesh

pytestmark = pytest.mark.skipif(not INKEX.is_dir(), reason="Inkscape is not installed")

INKSCAPE = "http://www.inkscape.org/namespaces/inkscape"
XLINK = 'xmlns:xlink="http://www.w3.org/1999/xlink"'
CIRCLE = '<path id="apple" d="M70,45A25,25 0 0 1 20,45 25,25 0 0 1 70,45Z" fill="none" stroke="red"/>'
FEW = "--handles=40"


def soft(tint=0):
    """The bytes of a soft picture of 90 x 70 pixels."""
    y, x = np.mgrid[0:70, 0:90]
    pixels = np.stack([x * 2.5, 255 - y * 3, 128 + tint + 60 * np.sin(x / 20) * np.cos(y / 15)], axis=-1)
    file = io.BytesIO()
    Image.fromarray(pixels.clip(0, 255).astype("uint8")).save(file, "PNG")
    return file.getvalue()


def embedded(tint=0):
    return "data:image/png;base64," + base64.b64encode(soft(tint)).decode()


def image(more="", link=None, name="photo"):
    return f'<image id="{name}" width="90" height="70" xlink:href="{link or embedded()}" {more}/>'


def page(*elements):
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" {XLINK} width="200" height="160" viewBox="0 0 200 160">'
        f'{"".join(elements)}</svg>'
    )


def labelled(element, label, own=False):
    """With a label in Inkscape, which gradmesh wrote if it is its own."""
    wrote = f'xmlns:gradmesh="urn:gradmesh" gradmesh:label="{label}"' if own else ""
    return element.replace("/>", f' inkscape:label="{label}" xmlns:inkscape="{INKSCAPE}" {wrote}/>')


FAR = '<circle id="far" cx="190" cy="150" r="9"/>'
CUT_AWAY = '<clipPath id="cut"><circle cx="190" cy="150" r="9"/></clipPath>'


def is_hidden(element):
    return "display:none" in (element.get("style") or "")


def traced(done, *ids):
    """The elements of the document that a run wrote, by their ids, if these are its meshes."""
    assert (done.returncode, done.stderr) == (0, "")
    assert gradmesh.loads(done.stdout).ids == list(ids)
    return by_id(done.stdout)


@pytest.mark.parametrize("select", (["photo", "apple"], ["apple"], ["all"]))
@pytest.mark.full(all_but=1)
def test_a_path_around_something_becomes_its_mesh(run, select):
    path = CIRCLE.replace("/>", ' transform="rotate(5)"/>')
    document = page('<g id="all">', image(), path, "</g>", '<rect id="last" width="5" height="5"/>')
    found = traced(run(document, *(f"--id={name}" for name in select), FEW, item="trace"), "apple")
    before = by_id(document)
    assert [name for name in found if name and name in before] == [name for name in before if name]
    assert found["apple"].get("d") == before["apple"].get("d")
    assert found["apple"].get("transform") == "rotate(5)"
    assert not is_hidden(found["photo"])


def test_the_picture_is_hidden_if_asked_for(run):
    found = traced(
        run(page(image(), CIRCLE), "--id=photo", "--id=apple", FEW, "--hide_picture=true", item="trace"), "apple"
    )
    assert is_hidden(found["photo"]) and not is_hidden(found["apple"])


def test_of_several_pictures_those_that_were_traced_are_hidden(run):
    """Where paths alone are selected, too: the picture is the one below."""
    other = image('transform="translate(100 0)"', link=embedded(60), name="other")
    spot = '<circle id="spot" cx="150" cy="40" r="20"/>'
    done = run(page(image(), other, CIRCLE, spot), "--id=spot", FEW, "--hide_picture=true", item="trace")
    found = traced(done, "spot")
    assert is_hidden(found["other"]) and not is_hidden(found["photo"])


@pytest.mark.parametrize("beside", ("copy", "document"))
@pytest.mark.full(all_but=1)
def test_a_linked_picture_is_found_beside_the_copy_or_the_document(run, tmp_path, beside):
    """Inkscape makes most links relative to its copy, but not all."""
    folder = tmp_path if beside == "copy" else tmp_path / "home"
    (folder / "my pictures").mkdir(parents=True)
    (folder / "my pictures" / "soft.png").write_bytes(soft())
    document = page(image(link="my%20pictures/soft.png"), CIRCLE)
    traced(run(document, "--id=apple", FEW, item="trace", path=str(tmp_path / "home" / "a.svg")), "apple")
    (folder / "my pictures" / "soft.png").unlink()
    assert "soft.png" in refused(run(document, "--id=apple", FEW, item="trace"))


@pytest.mark.parametrize("relative_to", ("copy", "document"))
@pytest.mark.full(all_but=1)
def test_a_missing_picture_is_named_where_a_person_knows_it(run, tmp_path, relative_to):
    """Its folder may be gone too. Inkscape's copy of the document lies elsewhere than the document."""
    home = tmp_path / "home" / "ann"
    (home / "work").mkdir(parents=True)
    link = "home/ann/old/soft.png" if relative_to == "copy" else "../old/soft.png"
    done = run(page(image(link=link), CIRCLE), "--id=apple", FEW, item="trace", path=str(home / "work" / "a.svg"))
    assert f"{home / 'old' / 'soft.png'} cannot be read" in refused(done)


def test_a_mesh_for_each_of_several_paths_of_the_picture_below_it(run):
    other = image('transform="translate(100 0)"', link=embedded(60), name="other")
    spot = '<circle id="spot" cx="150" cy="40" r="20"/>'
    document = page(image(), other, CIRCLE, spot)
    alone, both = (
        run(document, *(f"--id={name}" for name in ids), FEW, item="trace")
        for ids in (["spot"], ["apple", "spot", "photo", "other"])
    )
    traced(alone, "spot")
    found = traced(both, "apple", "spot")
    assert {name: each.attrib for name, each in found.items() if name != "apple"}.keys() >= {"spot", "other"}
    assert mesh_colors(both.stdout, "spot") == mesh_colors(alone.stdout, "spot")


def mesh_colors(text, name):
    gradient = next(e for e in by_id(text).values() if (e.get("id") or "").startswith(name + "-mesh"))
    return [stop.get("style") or stop.get("stop-color") for stop in gradient.iter(SVG + "stop")]


@pytest.mark.parametrize(
    "more",
    (
        "",
        'transform="translate(60 20) rotate(20) scale(1.2 .8)"',
        'x="20" y="30" style="width:90px" preserveAspectRatio="none"',
        'clip-path="url(#cut)" opacity=".5"',
    ),
)
@pytest.mark.full(all_but=1)
def test_a_picture_alone_becomes_a_mesh_that_looks_like_it(run, inkscape, tmp_path, more):  # noqa: F811
    cut = '<clipPath id="cut"><circle cx="50" cy="35" r="24"/></clipPath>'
    document = page(f"<defs>{cut}</defs>", image(more))
    done = run(document, "--id=photo", FEW, "--hide_picture=true", item="trace")
    found = traced(done, "photo-mesh1")
    assert list(found).index("photo-mesh1") == list(found).index("photo") + 1
    (tmp_path / "before.svg").write_text(document)
    (tmp_path / "after.svg").write_text(done.stdout)
    was, now = (
        np.asarray(Image.open(path).convert("RGBA"), dtype=float)
        for path in export(inkscape, [tmp_path / "before.svg", tmp_path / "after.svg"])
    )
    opacity = was[..., 3].max()
    seen = (was[..., 3] == opacity) & (np.abs(now[..., 3] - opacity) <= 1)
    assert ((was[..., 3] > 0) ^ (now[..., 3] > 0)).mean() < 0.01
    assert seen.mean() > 0.05
    assert np.abs(was - now)[seen].mean() < 2


LINES = (
    '<path id="line" d="M33.3,30V60" transform="translate(1)"/>',
    '<line id="line" x1="34.3" y1="30" x2="34.3" y2="60"/>',
    '<polyline id="line" points="34.3,30 34.3,60"/>',
)


@pytest.mark.parametrize("line", LINES)
@pytest.mark.full(all_but=1)
def test_lines_of_a_mesh_follow_open_paths(run, line):
    """Points lie on the path, which goes straight down; without it no three lie so."""
    document = page(image(), CIRCLE, line)
    free, guided = (
        run(document, *(f"--id={name}" for name in ids), FEW, item="trace")
        for ids in (["photo", "apple"], ["photo", "apple", "line"])
    )
    assert most_points_below_each_other(free.stdout) < 3 <= most_points_below_each_other(guided.stdout)
    assert by_id(guided.stdout)["line"].attrib == by_id(document)["line"].attrib


def most_points_below_each_other(text):
    hemesh = gradmesh.convert(gradmesh.loads(text), "hemesh", "apple", subdivide=1).document.to_bytes().decode()
    points = hemesh.splitlines()[2 : 2 + int(hemesh.split()[1])]
    return max(Counter(round(float(point.split()[0]), 6) for point in points).values())


EYE = '<circle id="eye" cx="30" cy="30" r="12" style="fill:red"/>'


def test_a_mesh_comes_closer_where_shapes_are_marked(run):
    document = page(image(), EYE)
    marked = run(document, "--id=eye", item="more_detail")
    assert (marked.returncode, marked.stderr) == (0, "")
    eye = by_id(marked.stdout)["eye"].attrib
    assert "fill:none" in eye["style"] and eye[f"{{{INKSCAPE}}}label"] == "More detail"
    plain, closer = (run(drawing, "--id=photo", FEW, item="trace") for drawing in (document, marked.stdout))
    (mesh,) = gradmesh.loads(plain.stdout).ids
    assert traced(closer, mesh)["eye"].attrib == eye
    sides = [re.findall(r'<[^>]*stop [^>]*path="([^"]*)"', trace.stdout) for trace in (plain, closer)]
    assert sides[0] and sides[0] != sides[1]
    hidden = run(marked.stdout, "--id=photo", FEW, "--hide_picture=true", item="trace")
    assert all("display:none" in by_id(hidden.stdout)[name].get("style") for name in ("photo", "eye"))
    again = run(marked.stdout, "--id=eye", item="more_detail")
    assert by_id(again.stdout)["eye"].attrib == by_id(document)["eye"].attrib


def test_marked_shapes_need_a_picture(run):
    marked = run(page(image(), EYE), "--id=eye", item="more_detail").stdout
    assert "Select the picture, too" in refused(run(marked, "--id=eye", item="trace"))
    assert "Draw a shape" in refused(run(marked, "--id=photo", item="more_detail"))


@pytest.mark.parametrize(
    "elements, select, words",
    (
        ([CIRCLE], ["apple"], "There is no picture in the document"),
        ([image(), CIRCLE], [], "Select a picture"),
        ([image(), '<text id="words">a</text>'], ["words"], "None of the selected objects"),
        ([image(), '<path id="line" d="M10,10 40,40 10,40"/>'], ["line"], "line is an open path"),
        ([image(), FAR], ["photo", "far"], '"far" does not lie on'),
        ([image(), labelled(FAR, "Sun")], ["photo", "far"], '"Sun" does not lie on'),
        ([image(), labelled(FAR, "Ours", own=True)], ["photo", "far"], '"far" does not lie on'),
        ([image(link="none.png"), FAR], ["far"], '"far" does not lie on'),
        ([image(link="none.png"), image('y="80"', link="none.png", name="other"), FAR], ["far"], "none of its 2 pic"),
        ([image(link="none.png"), CIRCLE], ["apple"], "none.png"),
        ([image('clip-path="url(#cut)"'), CUT_AWAY], ["photo"], "nothing is seen of the picture."),
        ([labelled(image('clip-path="url(#cut)"'), "Sea"), CUT_AWAY], ["photo"], 'nothing is seen of "Sea".'),
        ([image().replace('"90"', '"0"')], ["photo"], "the picture has no size."),
        ([image(link="data:image/png;base64,aaaa"), CIRCLE], ["apple"], "picture"),
    ),
)
@pytest.mark.full(all_but=1)
def test_what_cannot_be_traced_gets_a_sentence(run, elements, select, words):
    assert words in refused(run(page(*elements), *(f"--id={name}" for name in select), item="trace"))


def test_settings_that_do_not_work_get_a_sentence(run):
    said = refused(run(page(image(), CIRCLE), "--id=apple", "--amount=none", item="trace"))
    assert said.startswith("These settings do not work")


def test_a_script_is_told_of_each_mesh(run, tmp_path):
    report = tmp_path / "report.json"
    run(page(image(), CIRCLE), "--id=apple", FEW, item="trace", GRADMESH_REPORT=str(report))
    line = json.loads(report.read_text())
    assert (line["action"], line["outcome"]) == ("org.gradmesh.trace", "done")
    (mesh,) = line["meshes"]
    assert mesh["id"] == "apple" and mesh["handles"] <= 40 and mesh["mean"] < 2 and not mesh["stopped"]


def test_what_is_told_of_each_mesh(extension, run, tmp_path):  # noqa: F811
    """Also what would help, where the mesh does not look like the picture."""

    def noise(*size):
        file = io.BytesIO()
        Image.fromarray(np.random.default_rng(1).integers(0, 256, (*size, 3), dtype="uint8")).save(file, "PNG")
        return image(link="data:image/png;base64," + base64.b64encode(file.getvalue()).decode())

    log = tmp_path / "cache" / "gradmesh" / "extension.log"
    spot = labelled(CIRCLE, "Spot")
    run(page(noise(70, 90), spot), "--id=apple", "--handles=4", item="trace")
    assert re.search(r"Spot: 4 handles, 7\d\.\d % like the picture\. You can see", log.read_text())
    log.unlink()
    run(page(image(), spot), "--id=apple", FEW, item="trace")
    assert re.search(r"Spot: \d+ handles, 99\.\d % like", log.read_text()) and "You can see" not in log.read_text()
    log.unlink()
    run(page(image()), "--id=photo", FEW, item="trace", LANGUAGE="de")
    assert re.search(r"Das Bild: \d+ Anfasser, zu 9\d,\d % wie das Bild\.", log.read_text())
    log.unlink()
    # Ten seconds of two cores without that.
    large = ["--resolution=1000", "--handles=1000", "--time_budget=1"]
    run(page(noise(700, 900), spot), "--id=photo", *large, item="trace")
    assert "The time that is allowed under More was over" in log.read_text()


@needs()
def test_inkscape_runs_it_and_writes_the_mesh(extension, inkscape, tmp_path):  # noqa: F811
    inkscape.install(extension)
    inkscape.set_values({"org.gradmesh.trace.handles": "40"})
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "soft.png").write_bytes(soft())
    # After any extension, its own too, 1.4 tells in a dialog that it has found the file of a relative link again.
    is_linked = inkscape_harness.is_older_than(1, 4)
    picture = image(link="sub/soft.png") if is_linked else image()
    (tmp_path / "in.svg").write_text(page(picture, CIRCLE))
    out = tmp_path / "out.svg"
    inkscape.run_extension("org.gradmesh.trace", tmp_path / "in.svg", out, select=["photo", "apple"])
    text = out.read_text()
    (mesh,) = gradmesh.loads(text).meshes
    assert mesh.id == "apple" and mesh.handles <= 40
    link = by_id(text)["photo"].get("{http://www.w3.org/1999/xlink}href")
    assert link == "sub/soft.png" if is_linked else link.startswith("data:image/png;")
