"""Meshes that are hard on numbers: a correct result or one sentence, and never nonsense in a file."""

import re
import xml.etree.ElementTree as ET

import pytest

import built
from extreme_meshes import CASES, DEGENERATE, OTHER, REFUSED, SAME, TRANSFORMED, document
from in_inkscape import inkscape  # noqa: F401
from test_robustness import expect_one_sentence

gradmesh = pytest.importorskip("gradmesh", reason="the compiled package is not there")

METHODS = ("best", "gqe", "grid", "lines")
EPSILON, RESOLUTION = 0.01, 200
GOOD = [name for name in CASES if name not in REFUSED]
#: The same picture as of the mesh as it is.
MOVED = [name for name in (*SAME, *TRANSFORMED) if not re.match("mirrored|upside|turned", name)]
#: Two of 30,000 pixels whose centres lie on the outline: coordinates are written rounded.
ROUNDING = 7e-5
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
COORDINATES = ("path", "x", "y", "width", "height", "tensor", "d", "points")
OF_MESHES = ("meshgradient", "meshpatch", "stop", "path")


def run(*arguments):
    done = built.gradmesh(*arguments)
    assert "Traceback" not in done.stderr and done.returncode in (0, 1), done.stderr
    return done


def coordinates(element):
    """The sizes of all coordinates in an element's attributes."""
    texts = [element.get(name, "") for name in COORDINATES]
    assert not any(re.search("nan|inf", text, re.IGNORECASE) for text in texts)
    return [abs(float(found)) for text in texts for found in NUMBER.findall(text)]


def expect_plain_numbers(data):
    """Finite, and of a mesh none that roundings have left of zero."""
    of_meshes = []
    for element in ET.fromstring(data).iter():
        found = coordinates(element)
        if element.tag.split("}")[-1] in OF_MESHES:
            of_meshes += found
        assert not re.search(r"\b(nan|inf)\b", element.get("style", ""), re.IGNORECASE)
    assert of_meshes and max(of_meshes) < 1e10
    assert not [x for x in of_meshes if 0 < x < 1e-13 * max(of_meshes)]


def expect_good(data, patches):
    """A document that says what it should, with all else that was in it."""
    expect_plain_numbers(data)
    assert OTHER.encode() in data
    (mesh,) = gradmesh.loads(data).meshes
    assert (mesh.id, mesh.patches) == ("box", patches)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", GOOD)
@pytest.mark.full(all_but=1)
def test_simplified(tmp_path, name, method):
    before, after = tmp_path / "before.svg", tmp_path / "after.svg"
    before.write_bytes(document(name))
    simplified = gradmesh.load(before)
    options = {"method": method, "epsilon": EPSILON, "resolution": RESOLUTION}
    (result,) = gradmesh.simplify(simplified, **options)
    assert 0 <= result.error <= EPSILON
    expect_good(simplified.to_bytes(), result.patches_after)
    gradmesh.save(simplified, after)
    again = run("compare", before, after, "--resolution", RESOLUTION)
    assert float(again.stdout) == pytest.approx(result.error, abs=ROUNDING)
    if name not in DEGENERATE:
        # The refined mesh has nine patches that differ; where pixels lie makes no difference.
        assert result.patches_after == 9
    # On what was written, nothing more comes of the same epsilon that a new document could hold.
    (more,) = gradmesh.simplify(simplified, **{**options, "method": "grid"})
    assert more.patches_after <= result.patches_after and more.error <= EPSILON


@pytest.mark.parametrize("name", GOOD)
def test_painted_and_converted(name):
    source = gradmesh.loads(document(name))
    picture = gradmesh.render(source, resolution=RESOLUTION)
    if name in MOVED:
        plain = gradmesh.render(gradmesh.loads(document("as it is")), resolution=RESOLUTION)
        assert gradmesh.compare(plain, picture) <= ROUNDING
    there = gradmesh.convert(source, "hemesh", resolution=RESOLUTION)
    text = there.document.to_bytes()
    assert not re.search(rb"nan|inf", text, re.IGNORECASE)
    assert there.patches == 30 and (there.lost_opacity or there.error <= 1e-4)
    back = gradmesh.convert(gradmesh.loads(text, "mesh.hemesh"), "svg", resolution=RESOLUTION)
    assert back.patches == 30 and back.error <= 1e-4
    expect_plain_numbers(back.document.to_bytes())


@pytest.mark.full
def test_inkscape_shows_the_same_wherever_the_mesh_lies(inkscape, tmp_path):
    """The blocks' paths hold what they paint, too."""
    pictures = pytest.importorskip("pictures", reason="Debian package python3-pil is absent")
    names = [*SAME, *TRANSFORMED]
    before = [tmp_path / f"before{i}.svg" for i in range(len(names))]
    after = [tmp_path / f"after{i}.svg" for i in range(len(names))]
    for name, source, out in zip(names, before, after):
        source.write_bytes(document(name))
        simplified = gradmesh.load(source)
        gradmesh.simplify(simplified, method="gqe", epsilon=EPSILON, resolution=RESOLUTION)
        gradmesh.save(simplified, out)
    pngs = pictures.export(inkscape, [*before, *after])
    for png in pngs:
        with pictures.Image.open(png) as picture:
            opacity = pictures.np.asarray(picture)[..., 3]
        assert (opacity > 0).mean() > 0.5, png
    off = {name: pictures.flip(*pair) for name, *pair in zip(names, pngs, pngs[len(names) :])}
    assert {name: error for name, error in off.items() if error > EPSILON + 0.003} == {}


def blocks(data):
    """The ids of the blocks' paths, not those in a mask."""
    paths = [e.get("id") for e in ET.fromstring(data).iter() if e.get("{urn:gradmesh}face")]
    return [name for name in paths if "opacity" not in name]


@pytest.mark.parametrize("name", GOOD)
@pytest.mark.full(all_but=1)
def test_edited(name):
    edited = gradmesh.loads(document(name))
    (result,) = gradmesh.simplify(edited, method="gqe", resolution=100)
    written = edited.to_bytes()
    edited = gradmesh.loads(written)
    assert [update.changed for update in gradmesh.update(edited)] == [False]
    assert edited.to_bytes() == written
    refined = gradmesh.refine(edited, blocks(written)[0], resolution=100)
    assert refined.patches_after > refined.patches_before == result.patches_after
    expect_good(edited.to_bytes(), refined.patches_after)
    merged = gradmesh.merge(edited, blocks(edited.to_bytes())[:1], resolution=100)
    assert merged.patches_after < merged.patches_before
    expect_good(edited.to_bytes(), merged.patches_after)
    (one,) = gradmesh.to_one_mesh(edited, resolution=100)
    expect_good(edited.to_bytes(), one.patches_after)


@pytest.mark.parametrize("name", REFUSED)
@pytest.mark.full(all_but=1)
def test_refused(tmp_path, name):
    words = REFUSED[name][1]
    source, out = tmp_path / "drawing.svg", tmp_path / "out.svg"
    source.write_bytes(document(name))
    for method in METHODS:
        refused = run("simplify", source, "-o", out, "--method", method, "--resolution", RESOLUTION)
        assert refused.returncode == 1 and words in refused.stderr
        expect_one_sentence(refused.stderr.strip(), "drawing.svg")
        assert not out.exists()
    if words == "covers no pixel":
        # It can still be read, painted and converted: it is only that no error can be measured.
        found = gradmesh.load(source)
        assert gradmesh.render(found, resolution=RESOLUTION).min() == 255
        assert gradmesh.convert(found, "hemesh").patches == 30


@pytest.mark.parametrize("name", CASES)
@pytest.mark.full(all_but=1)
def test_every_command_ends_in_a_result_or_a_sentence(tmp_path, name):
    source = tmp_path / "source.svg"
    source.write_bytes(document(name))
    simplified, hemesh = tmp_path / "simplified.svg", tmp_path / "mesh.hemesh"
    drawing = tmp_path / "drawing.svg"
    run("simplify", source, "-o", simplified, "--resolution", 64, "--method", "grid")
    commands = [
        ("info", source, "--json"),
        ("convert", source, hemesh),
        ("analyze", source, "-o", tmp_path / "prices.json", "--resolution", 64),
        ("draw", source, "-o", drawing, "--show", "edges", "--no-picture"),
        ("update", simplified, "-o", simplified),
        ("convert", hemesh, tmp_path / "back.svg", "--subdivide", 1),
        ("simplify", hemesh, "-o", tmp_path / "small.hemesh", "--resolution", 64, "--method", "grid"),
    ]
    for command in commands:
        done = run(*command)
        if done.returncode == 1:
            expect_one_sentence(done.stderr.strip(), str(command[1]))
        else:
            # `info` lists what cannot be read, with the reason.
            assert name not in REFUSED or REFUSED[name][1] == "covers no pixel" or command[0] == "info"
            assert not re.search(r"\b(nan|inf)\b", done.stdout, re.IGNORECASE)
    for written in {*tmp_path.glob("*.svg")} - {source, drawing}:
        expect_plain_numbers(written.read_bytes())
    if drawing.exists():
        assert all(coordinates(element) is not None for element in ET.parse(drawing).iter())
