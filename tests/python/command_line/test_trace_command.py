"""A mesh of a picture: `gradmesh trace`."""

import base64
import json
import re

import numpy as np
import pytest
from PIL import Image

from built import gradmesh as run
from in_inkscape import inkscape  # noqa: F401
from pictures import export
from program import printed, refused


@pytest.fixture
def picture(tmp_path):
    """Writes a soft ball on a soft ground, with its opacity in RGBA, and returns the path."""

    def write(name="ball.png", size=(120, 90), mode="RGB", **options):
        width, height = size
        y, x = np.mgrid[0:height, 0:width]
        ball = np.clip(40 - np.hypot(x - 0.45 * width, y - 0.5 * height), 0, 24) / 24
        pixels = np.stack([80 + 150 * ball, 60 + x / 2, 200 - y, 255 * ball], axis=-1).clip(0, 255)
        channels = {"RGB": 3, "RGBA": 4}[mode]
        Image.fromarray(pixels[..., :channels].astype("uint8"), mode).save(tmp_path / name, **options)
        return tmp_path / name

    return write


def traced(picture, *options):
    """The report and the document of a trace."""
    out, report = picture.with_suffix(".svg"), picture.with_suffix(".json")
    printed("trace", picture, "-o", out, "--report", report, *options)
    return json.loads(report.read_text()), out


def over_white(path):
    image = Image.open(path).convert("RGBA")
    white = Image.new("RGBA", image.size, "white")
    return np.asarray(Image.alpha_composite(white, image).convert("RGB"), dtype=float)


def test_a_mesh_looks_like_its_picture_and_says_how_much(picture, tmp_path):
    path = picture()
    report, out = traced(path, "--handles", "120", "--epsilon", "0")
    assert report["handles"] == (report["rows"] + 1) * (report["columns"] + 1) <= 120
    assert report["errors"]["flip"] < 0.03 and report["errors"]["rmse"] < 3
    text = printed("info", out)
    assert f"{report['handles']} handles" in text and "1 object" in text
    assert out.read_text().startswith("<?xml") and 'viewBox="0 0 120 90"' in out.read_text()


def test_the_error_is_that_of_what_inkscape_paints(picture, inkscape):  # noqa: F811
    path = picture("soft.png")
    report, out = traced(path, "--handles", "100")
    painted = over_white(export(inkscape, [out.rename(out.with_stem("mesh"))])[0])
    rmse = np.sqrt(np.mean((painted - over_white(path)) ** 2))
    assert abs(rmse - report["errors"]["rmse"]) < 0.3


@pytest.mark.full
def test_no_more_handles_than_the_error_needs(picture):
    path = picture()
    soft, _ = traced(path, "--epsilon", "0.06")
    close, _ = traced(path, "--epsilon", "0.02")
    assert soft["errors"]["flip"] <= 0.06 and close["errors"]["flip"] <= 0.02
    assert soft["handles"] < close["handles"] < 1000


@pytest.mark.full
def test_amounts_stand_for_errors(picture, tmp_path):
    path = picture()
    usual, _ = traced(path)
    balanced, _ = traced(path, "--amount", "balanced")
    strong, _ = traced(path, "--amount", "strong")
    assert balanced["handles"] == usual["handles"] > strong["handles"]
    for wrong in ("--amount strong --epsilon 0.1", "--amount some"):
        assert run("trace", path, "-o", tmp_path / "out.svg", *wrong.split()).returncode == 2
    assert not (tmp_path / "out.svg").exists()


def test_opacity_is_kept(picture):
    report, out = traced(picture("cut.png", mode="RGBA"), "--handles", "150")
    assert report["errors"]["flip"] < 0.06
    assert "stop-opacity" in out.read_text()


def test_large_pictures_are_reduced_and_the_page_is_not(picture):
    report, out = traced(picture("large.jpg", (1800, 1200), quality=95), "--handles", "60", "--resolution", "150")
    assert 'viewBox="0 0 1800 1200"' in out.read_text()
    assert report["errors"]["rmse"] < 12


def test_what_is_smaller_than_the_detail_is_not_followed(picture):
    path = picture("noise.png")
    pixels = np.asarray(Image.open(path), dtype=float)
    noise = np.random.default_rng(1).normal(0, 25, pixels.shape)
    Image.fromarray((pixels + noise).clip(0, 255).astype("uint8")).save(path)
    report, _ = traced(path, "--handles", "60", "--detail", "6")
    assert report["errors_without_detail"]["rmse"] < 0.5 * report["errors"]["rmse"]


def test_a_picture_that_is_no_gradient_gets_a_sentence(picture):
    path = picture("checks.png")
    y, x = np.mgrid[0:90, 0:120]
    Image.fromarray(((x // 6 + y // 6) % 2 * 255).astype("uint8")).save(path)
    done = run("trace", path, "-o", path.with_suffix(".svg"), "--handles", "30")
    assert done.returncode == 0
    assert done.stderr.startswith(f"gradmesh: {path}: with ") and done.stderr.count("\n") == 1
    assert "Trace Bitmap" in done.stderr


def test_the_same_bytes_on_any_number_of_threads(picture):
    path = picture()
    _, out = traced(path, "--handles", "80", "--threads", "1")
    first = out.read_bytes()
    traced(path, "--handles", "80", "--threads", "4")
    assert out.read_bytes() == first


def curve_of(path):
    (mesh,) = json.loads(path.read_text())["meshes"]
    assert mesh["kind"] == "one gradient"
    return mesh


def test_a_curve_has_what_is_left_as_lines_are_taken_out(picture, tmp_path):
    file = tmp_path / "curve.json"
    report, out = traced(picture(), "--handles", "150", "--epsilon", "0", "--curve", file)
    curve = curve_of(file)
    states = curve["states"]
    assert set(states[0]) == {"handles", "patches", "objects", "error", "local_error"}
    assert curve["id"] in out.read_text()
    assert (states[0]["handles"], states[0]["patches"]) == (report["handles"], report["patches"])
    assert states[0]["error"] == report["errors"]["flip"]
    handles = [state["handles"] for state in states]
    assert handles == sorted(set(handles), reverse=True) and handles[-1] < 0.2 * handles[0]
    assert states[-1]["error"] > 3 * states[0]["error"]
    assert all(0 < state["error"] < state["local_error"] <= 1 for state in states)
    assert sorted(curve["marks"].values()) == [curve["marks"][name] for name in ("gentle", "balanced", "strong")]
    for name, most in {"gentle": 0.02, "balanced": 0.03, "strong": 0.04}.items():
        assert states[curve["marks"][name]]["error"] <= most


def test_the_curve_of_a_shape_is_of_what_is_inside(picture, outline, tmp_path):
    file = tmp_path / "curve.json"
    report, _ = traced(picture(), "--outline", outline(), "--handles", "64", "--epsilon", "0", "--curve", file)
    curve = curve_of(file)
    assert curve["id"] == "ball"
    assert curve["states"][0]["error"] == report["errors"]["flip"]
    assert curve["states"][-1]["error"] > report["errors"]["flip"]


def test_a_curve_needs_no_document(picture, tmp_path):
    path, file = picture(), tmp_path / "curve.json"
    printed("trace", path, "--curve", file, "--handles", "40")
    assert curve_of(file)["states"]
    assert not list(tmp_path.glob("*.svg"))
    assert run("trace", path, "--handles", "40").returncode == 2


@pytest.mark.parametrize("wrong", ["--handles 3", "--epsilon 2", "--detail 0.5", "--resolution 8"])
def test_options_out_of_range_are_refused(picture, wrong):
    path = picture()
    assert run("trace", path, "-o", path.with_suffix(".svg"), *wrong.split()).returncode == 2
    assert not path.with_suffix(".svg").exists()


def test_more_handles_than_a_mesh_may_have_are_refused_before_any_work(picture):
    path = picture()
    sentence = refused("trace", path, "-o", path.with_suffix(".svg"), "--handles", "30000")
    assert sentence.startswith("30000 handles can be as many patches, more than the limit of 20000")
    assert not path.with_suffix(".svg").exists()


def test_a_mesh_for_the_papers_programs(picture, tmp_path):
    out = tmp_path / "ball.hemesh"
    printed("trace", picture(), "-o", out, "--handles", "40")
    assert "1 object" in printed("info", out)


@pytest.mark.parametrize("size", [(8, 8), (1, 50), (50, 1), (1, 1)], ids=str)
def test_the_smallest_pictures_become_meshes(picture, size):
    _, out = traced(picture("small.png", size))
    assert "handles" in printed("info", out)


@pytest.mark.parametrize(
    "content", [b"", b"nothing", b"\x89PNG\r\n\x1a\n" + b"\0" * 40], ids=["empty", "text", "cut off"]
)
def test_what_is_no_picture_is_refused_in_a_sentence(tmp_path, content):
    path = tmp_path / "no.png"
    path.write_bytes(content)
    sentence = refused("trace", path, "-o", tmp_path / "out.svg")
    assert sentence.startswith(f"{path} is not a readable picture: ")
    assert not (tmp_path / "out.svg").exists()


@pytest.fixture
def outline(tmp_path):
    """Writes a document with a stroked ellipse around the ball of the picture, and returns FILE#ID."""

    def write(inside='<ellipse id="ball" {shape} style="fill:none;stroke:#f00"/>', page='width="120" height="90"'):
        shape = 'cx="54" cy="45" rx="30" ry="26"'
        path = tmp_path / "outline.svg"
        path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" {page}>{inside.format(shape=shape)}</svg>')
        return f"{path}#ball"

    return write


def picture_of_shape(tmp_path, out, inkscape):  # noqa: F811
    return export(inkscape, [out.rename(tmp_path / "mesh.svg")])[0]


def test_a_shape_on_the_picture_becomes_the_mesh(picture, outline, tmp_path, inkscape):  # noqa: F811
    """Its inside looks like the picture there, and around it there is nothing."""
    path = picture()
    report, out = traced(path, "--outline", outline(), "--handles", "64", "--epsilon", "0")
    assert report["handles"] <= 64 and report["errors"]["rmse"] < 2
    text = out.read_text()
    assert '<ellipse id="ball" cx="54"' in text and "stroke:none" in text
    painted = np.asarray(Image.open(picture_of_shape(tmp_path, out, inkscape)).convert("RGBA"), dtype=float)
    y, x = np.mgrid[0:90, 0:120] + 0.5
    away = np.hypot((x - 54) / 30, (y - 45) / 26)
    inside = away < 0.94
    assert painted[away > 1.06][:, 3].max() == 0 and painted[inside][:, 3].min() == 255
    difference = painted[inside][:, :3] - over_white(path)[inside]
    assert abs(np.sqrt(np.mean(difference**2)) - report["errors"]["rmse"]) < 0.3


PLACED = (
    '<g transform="translate(300,200) rotate(25)"><image x="10" y="20" width="240" height="180"'
    ' transform="scale(0.5)" href="ball.png"/>'
    '<g id="above" transform="translate(5,10)"><ellipse id="ball" {shape} fill="#000" opacity="0.5"/></g></g>'
)


def corner(out):
    """Where the gradient in a document begins."""
    return re.search(r'<meshgradient [^>]* x="(.*?)" y="(.*?)"', out.read_text()).groups()


def test_the_picture_lies_where_the_document_shows_it(picture, outline):
    """The same shape on the picture gives the same mesh, wherever both are."""
    path = picture()
    plain, out = traced(path, "--outline", outline(), "--handles", "49", "--epsilon", "0")
    at = corner(out)
    placed, out = traced(path, "--outline", outline(PLACED), "--handles", "49", "--epsilon", "0")
    text = out.read_text()
    assert corner(out) == at
    assert "<image" in text and 'id="above"' in text and 'opacity="0.5"' in text
    assert placed["errors"]["rmse"] == pytest.approx(plain["errors"]["rmse"], abs=0.3)


def test_a_page_without_a_picture_is_filled_by_it(picture, outline):
    path = picture()
    plain, _ = traced(path, "--outline", outline(), "--handles", "49", "--epsilon", "0")
    scaled, out = traced(
        path,
        "--outline",
        outline(
            '<ellipse id="ball" cx="5.4" cy="4.5" rx="3" ry="2.6"/>',
            'width="12mm" height="9mm" viewBox="0 0 12 9"',
        ),
        *("--handles", "49", "--epsilon", "0"),
    )
    assert scaled["errors"]["rmse"] == pytest.approx(plain["errors"]["rmse"], abs=0.5)


@pytest.mark.parametrize("how", ["linked", "named in full", "in the document", "in broken lines"])
@pytest.mark.full(all_but=1)
def test_the_document_s_own_picture_need_not_be_named(picture, outline, tmp_path, how):
    path = picture("a ball.png")
    data = base64.encodebytes(path.read_bytes()).decode()
    reference = {
        "linked": "a%20ball.png",
        "named in full": path.as_uri(),
        "in the document": "data:image/png;base64," + data.replace("\n", ""),
        "in broken lines": "data:image/png;base64," + data.replace("\n", "&#10;"),
    }[how]
    attribute = 'xmlns:x="http://www.w3.org/1999/xlink" x:href' if how == "linked" else "href"
    shape = f'<image width="120" height="90" {attribute}="{reference}"/><ellipse id="ball" {{shape}}/>'
    made = [tmp_path / "named.svg", tmp_path / "own.svg"]
    for out, named in zip(made, ([path], [])):
        printed("trace", *named, "--outline", outline(shape), "-o", out, "--handles", "36")
    meshes = [re.search("gradientUnits.*</meshgradient>", out.read_text(), re.S)[0] for out in made]
    assert meshes[0] == meshes[1]


@pytest.mark.parametrize(
    ("inside", "reason"),
    [
        ("", "outline.svg: it shows no picture, so that one has to be named."),
        ('<image href="https://example.org/a.png"/>', 'its picture "https://example.org/a.png" is no file of'),
        ('<image href="data:image/png;base64,?"/>', "outline.svg: what it holds of its picture cannot be read."),
        ('<image href="data:image/png;base64,AAAA"/>', "outline.svg is not a readable picture"),
        ('<image href="none.png"/>', "none.png cannot be read"),
        ("<image/>", "is no file of this machine"),
    ],
)
def test_a_picture_that_the_document_does_not_have_is_told(outline, tmp_path, inside, reason):
    sentence = refused("trace", "--outline", outline(inside + '<ellipse id="ball" {shape}/>'), "-o", tmp_path / "x.svg")
    assert reason in sentence
    assert run("trace", "-o", tmp_path / "x.svg").returncode == 2


def test_only_the_mesh_of_the_shape_goes_to_the_papers_programs(picture, outline, tmp_path):
    out = tmp_path / "ball.hemesh"
    printed("trace", picture(), "--outline", outline(), "-o", out, "--handles", "40")
    assert "1 object" in printed("info", out)


@pytest.mark.parametrize(
    ("inside", "reason"),
    [
        ("<g/>", "outline.svg: there is no object with the id \"ball\"."),
        ('<line id="ball" x2="9"/>', 'outline.svg: "ball" is no closed shape, such as a path, that a mesh'),
        ('<path id="ball" d="M0,0H9"/>', "outline.svg: \"ball\" is no closed shape, such as a path, that a mesh"),
        ('<g id="ball"><rect width="9" height="9"/></g>', "outline.svg: \"ball\" is no closed shape"),
        ('<rect id="ball" x="500" width="9" height="9"/>', "outline.svg: \"ball\" does not lie on the picture."),
        (
            '<image x="50" width="9" height="9"/><image x="60" width="9" height="9"/>'
            '<rect id="ball" width="9" height="9"/>',
            'outline.svg: "ball" lies on none of its 2 pictures.',
        ),
    ],
)
def test_what_is_no_outline_is_refused_in_a_sentence(picture, outline, tmp_path, inside, reason):
    sentence = refused("trace", picture(), "--outline", outline(inside), "-o", tmp_path / "out.svg")
    assert reason in sentence
    assert not (tmp_path / "out.svg").exists()


def test_lines_of_the_mesh_follow_guides(picture, outline, tmp_path):
    shape = '<circle id="ball" cx="54" cy="45" r="30"/><path id="rim" d="M40,30 Q54,20 68,30"/>'
    path, where, report = picture(), outline(shape), tmp_path / "report.json"
    to = ("-o", tmp_path / "out.svg", "--report", report, "--handles", "60", "--epsilon", "0")
    printed("trace", path, "--outline", where, "--guides", "rim", *to)
    guided = (tmp_path / "out.svg").read_bytes()
    assert json.loads(report.read_text())["unused_guides"] == 0
    printed("trace", path, "--outline", where, *to)
    free = (tmp_path / "out.svg").read_bytes()
    assert free != guided
    assert 'no object with the id "none"' in refused("trace", path, "--outline", where, "--guides", "rim,none", *to)
    printed("trace", path, "--outline", where, "--weigh", "rim=4", *to)
    assert (tmp_path / "out.svg").read_bytes() != free
    wrong = ("trace", path, "--outline", where, "--weigh", "rim", *to)
    assert "--weigh needs an id and a number" in refused(*wrong, code=2)
    assert '"ball" is no path that lines' in refused("trace", path, "--outline", where, "--guides", "ball", *to)


def test_an_outline_needs_a_file_and_an_id(picture, tmp_path):
    path = picture()
    assert run("trace", path, "--outline", "outline.svg", "-o", tmp_path / "out.svg").returncode == 2
    sentence = refused("trace", path, "--outline", f"{path}#ball", "-o", tmp_path / "out.svg")
    assert "ball.png" in sentence
