"""A mesh that stays one mesh gradient remembers its original in few bytes."""

import re
import xml.etree.ElementTree as ET

import pytest

np = pytest.importorskip("numpy")

from built import ROOT, SAMPLES
from in_inkscape import inkscape  # noqa: F401
from program import meshes
from sample_meshes import PAINTED
from svg_meshes import GRADMESH

import gradmesh

EPSILON = 0.01
FRUIT = SAMPLES / "fruit.svg"
WHOLE = {"resolution": 300, "epsilon": EPSILON, "visible_only": False}
KOTUKU = ROOT.parent / "shared" / "real" / "kotuku-meshgradient.svg"

pytestmark = pytest.mark.module_only


def simplify(path, out, **options):
    document = gradmesh.load(path)
    results = gradmesh.simplify(document, **{**WHOLE, **options})
    gradmesh.save(document, out)
    return results


@pytest.fixture(scope="module")
def plain(tmp_path_factory):
    path = tmp_path_factory.mktemp("plain") / "fruit.svg"
    (result,) = simplify(FRUIT, path)
    assert result.method == "plain" and result.changed
    return path


@pytest.fixture
def copy(plain, tmp_path):
    path = tmp_path / "fruit.svg"
    path.write_bytes(plain.read_bytes())
    return path


def remembers(path, mesh="pear"):
    (found,) = [m["remembers"] for m in meshes(path) if m["id"] == mesh]
    return found


def memory(path, painted="pear"):
    """What an object remembers, or a group of blocks."""
    (found,) = [e for e in ET.parse(path).iter() if e.get("id") == painted]
    return found.get(GRADMESH + "fill-original", found.get(GRADMESH + "original"))


def error_now(path):
    """Against what is remembered, or the mesh itself."""
    options = {**WHOLE, "epsilon": 0, "preview": True}
    (result,) = gradmesh.simplify(gradmesh.load(path), **options)
    return result.error


def error(path):
    """Against the very first mesh, in its frame."""
    first, after = gradmesh.load(FRUIT), gradmesh.load(path)
    frame = {"resolution": WHOLE["resolution"]}
    pictures = gradmesh.render(first, **frame), gradmesh.render(after, framed_as=first, **frame)
    return gradmesh.compare(*pictures)


@pytest.mark.parametrize("memory_is_kept", [True, False])
@pytest.mark.full
def test_errors_of_several_runs_add_up_without_memory_only(tmp_path, memory_is_kept):
    path, errors = tmp_path / "fruit.svg", []
    path.write_bytes(FRUIT.read_bytes())
    for _ in range(4):
        simplify(path, path, remember_original=memory_is_kept)
        errors.append(error(path))
    if memory_is_kept:
        assert max(errors) <= errors[0] + 1e-3, errors
    else:
        assert memory(path) is None and not remembers(path)
        assert errors[-1] > 1.3 * errors[0], errors


@pytest.mark.parametrize(
    "sample", [pytest.param(name, marks=[pytest.mark.long] * (name == "photo")) for name in PAINTED]
)
@pytest.mark.full(all_but=1)
def test_no_file_becomes_larger(sample, tmp_path):
    before, after = SAMPLES / f"{sample}.svg", tmp_path / "after.svg"
    simplify(before, after, max_local_error=0.1, visible_only=True)
    assert after.stat().st_size < before.stat().st_size
    for painted in PAINTED[sample]:
        assert remembers(after, painted)
    # What is remembered takes a fifth at most of what it took in the document.
    kept = sum(len(text) for text in re.findall('original="([^"]*)"', after.read_text()))
    assert kept < 0.2 * before.stat().st_size


@pytest.mark.skipif(not KOTUKU.exists(), reason="documents of others are not here")
def test_what_would_make_a_small_file_larger_is_not_remembered(tmp_path):
    after = tmp_path / "after.svg"
    simplify(KOTUKU, after, resolution=700, max_local_error=0.1, visible_only=True)
    assert after.stat().st_size <= KOTUKU.stat().st_size
    assert "gradmesh" not in after.read_text()


def test_it_is_remembered_by_lines_too(tmp_path):
    for sample, painted in (("fruit", "pear"), ("smooth", "vase")):
        path = tmp_path / f"{sample}.svg"
        simplify(SAMPLES / f"{sample}.svg", path, method="lines", epsilon=0.02)
        assert remembers(path, painted)
        (again,) = simplify(path, path, method="lines", epsilon=0.02)
        assert again.error > 0.001  # an original of its own would begin with 0


@pytest.mark.full
def test_a_further_run_measures_against_it(copy):
    kept = memory(copy)
    options = {"original": gradmesh.load(FRUIT), "epsilon": 0, "preview": True}
    (told,) = gradmesh.simplify(gradmesh.load(copy), **{**WHOLE, **options})
    assert error_now(copy) == pytest.approx(told.error, abs=1e-4) and told.error > 0.005
    simplify(copy, copy, epsilon=0.02)
    assert memory(copy) == kept
    # As blocks it is remembered too, and so it is of these as one mesh.
    simplify(copy, copy, epsilon=0.025, method="grid")
    assert remembers(copy) and gradmesh.load(copy).meshes[0].simplified
    document = gradmesh.load(copy)
    gradmesh.to_one_mesh(document)
    gradmesh.save(document, copy)
    assert remembers(copy) and not gradmesh.load(copy).meshes[0].simplified
    assert len(memory(copy)) == pytest.approx(len(kept), rel=0.1)


def test_a_person_can_have_it_forgotten(copy):
    simplify(copy, copy, epsilon=0.02, remember_original=False)
    assert "gradmesh:" not in copy.read_text()


def test_a_named_original_is_what_is_remembered(copy, tmp_path):
    other = tmp_path / "other.svg"
    simplify(FRUIT, other, epsilon=0.015, remember_original=False)
    (result,) = simplify(copy, copy, original=gradmesh.load(other), epsilon=0.03)
    assert result.changed and remembers(copy)
    assert error_now(copy) == pytest.approx(result.error, abs=1e-4)


@pytest.mark.parametrize(
    "pattern, replacement, is_edit",
    [
        (r'stop-color="#(\w\w)(\w{4})"', r'stop-color="#00\2"', True),
        (r'(<meshgradient [^>]*)\bx="[\d.]+"', r'\1x="200"', True),
        (r"(<meshgradient )", r'\1type="bicubic" ', True),
        ('gradmesh:fill-original="..', 'gradmesh:fill-original="', True),  # damaged
        ('gradmesh:fill-written="..', 'gradmesh:fill-written="', True),
        # To move it is none.
        ('gradientUnits="userSpaceOnUse"', r'\g<0> gradientTransform="translate(9,3)"', False),
        ('id="pear"', r'\g<0> transform="rotate(9)"', False),
        (r'stop-color="(#\w{6})"', r'style="stop-color:\1;stop-opacity:1"', False),
    ],
)
@pytest.mark.full(all_but=1)
def test_what_a_person_has_edited_is_the_new_original(copy, pattern, replacement, is_edit):
    assert remembers(copy)
    text, count = re.subn(pattern, replacement, copy.read_text(), count=1)
    assert count == 1
    copy.write_text(text)
    assert remembers(copy) != is_edit
    assert error_now(copy) == 0 if is_edit else 0.005 < error_now(copy) < 0.02


def test_inkscape_keeps_it(inkscape, plain, tmp_path):
    """Saved, moved, scaled and duplicated it is what it was; the numbers are Inkscape's then."""
    ways = {
        "saved": [],
        "moved": ["select-by-id:pear", "transform-translate:13,7"],
        "turned": ["select-by-id:pear", "transform-rotate:30"],
        "scaled": ["select-by-id:pear", "transform-scale:20"],
        "doubled": ["select-by-id:pear", "duplicate", "transform-translate:50,50"],
    }
    kept = memory(plain)
    for name, actions in ways.items():
        out = tmp_path / f"{name}.svg"
        inkscape.run_actions(plain, [*actions, f"export-filename:{out}", "export-do"])
        assert [mesh["remembers"] for mesh in meshes(out)] == [True] * (2 if name == "doubled" else 1)
        assert memory(out) == kept
        if name != "doubled":
            assert 0.005 < error_now(out) < 0.02, name
