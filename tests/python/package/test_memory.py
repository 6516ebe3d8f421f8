"""A simplified mesh remembers the original: later runs measure against it, whatever happened to
the document in between."""

import re
import xml.etree.ElementTree as ET

import pytest

pytest.importorskip("numpy")

from built import SAMPLES
from in_inkscape import inkscape  # noqa: F401
from pictures import export, flip, gradmesh as command
from svg_meshes import GRADMESH

import gradmesh

EPSILON = 0.01
ROUNDING = 5e-5  # of what is remembered
FRUIT = SAMPLES / "fruit.svg"

pytestmark = pytest.mark.module_only


def run_again(path, method="grid", **options):
    document = gradmesh.load(path)
    (result,) = gradmesh.simplify(document, method=method, epsilon=EPSILON, visible_only=False, **options)
    gradmesh.save(document, path)
    return result


def ten_runs(path, **options):
    """Runs of at most five merges each, told after each of them."""
    for seed in range(10):
        before = gradmesh.load(path).meshes[0].patches
        yield run_again(
            path, seed=seed, progress=lambda now: now.patches > before - 5, **options
        )


@pytest.fixture
def copy(tmp_path):
    """A copy of the sample that runs may change."""
    path = tmp_path / "copy.svg"
    path.write_bytes(FRUIT.read_bytes())
    return path


@pytest.fixture
def simplified(copy):
    run_again(copy)
    return copy


def group(path):
    return next(e for e in ET.parse(path).iter() if e.get(GRADMESH + "version"))


def label(path):
    (found,) = re.findall('inkscape:label="(Gradient mesh[^"]*)"', path.read_text())
    return found


def change_memory(path, name, change):
    """Replaces the value of an attribute of the group."""
    value = group(path).get(GRADMESH + name)
    text = path.read_text()
    assert text.count(value) == 1
    path.write_text(text.replace(value, change(value)))


def test_ten_runs_keep_to_epsilon_of_the_very_first_mesh(copy):
    merged = 0
    for result in ten_runs(copy):
        merged += result.patches_after < result.patches_before
        assert flip(FRUIT, copy) <= EPSILON
        assert label(copy).startswith(
            f"Gradient mesh: {result.handles_after} of 660 handles, {result.patches_after} of 132 patches, FLIP"
        )
    assert merged >= 3


def test_ten_runs_drift_away_without_memory(copy):
    for result in ten_runs(copy, remember_original=False):
        assert result.error <= EPSILON
    assert flip(FRUIT, copy) > 2 * EPSILON


def test_a_run_again_changes_nothing_and_has_the_error_against_the_original(simplified):
    before = simplified.read_bytes()
    result = run_again(simplified)
    assert result.stopped == "nothing to merge" and 0.009 < result.error <= EPSILON + ROUNDING
    assert simplified.read_bytes() == before
    # Nor does one that may leave a smaller error only.
    document = gradmesh.load(simplified)
    (result,) = gradmesh.simplify(document, method="grid", epsilon=0.002)
    assert result.stopped == "nothing to merge" and result.error > 0.002
    assert document.to_bytes() == before


def test_forgetting_makes_the_file_smaller(copy):
    whole = copy.with_name("whole.svg")
    whole.write_bytes(copy.read_bytes())
    few = {"progress": lambda now: now.patches > 125}
    run_again(whole, **few)
    run_again(copy, **few, remember_original=False)
    assert group(whole).get(GRADMESH + "original")
    assert group(copy).get(GRADMESH + "original") is None
    assert len(copy.read_bytes()) < len(whole.read_bytes())
    # A later run can leave it out too, and still has measured against it.
    run_again(whole, "random", seed=3, remember_original=False)
    assert group(whole).get(GRADMESH + "original") is None
    assert flip(FRUIT, whole) <= EPSILON


@pytest.mark.parametrize("name", ["original", "written"])
@pytest.mark.parametrize(
    "change", [lambda v: v[:-7], lambda v: "", lambda v: "AA" + v[2:], lambda v: "no memory"]
)
@pytest.mark.full(all_but=1)
def test_a_damaged_memory_counts_as_absent(simplified, name, change):
    (sound,) = gradmesh.load(simplified).meshes
    change_memory(simplified, name, change)
    assert gradmesh.load(simplified).meshes == [sound]
    result = run_again(simplified, "random", seed=1)
    if name == "original":  # only the simplified mesh itself is left to measure against
        assert result.patches_after < result.patches_before
        assert flip(FRUIT, simplified) > EPSILON
    else:
        assert flip(FRUIT, simplified) <= EPSILON


def test_a_moved_group_still_remembers(simplified):
    ET.register_namespace("gradmesh", "urn:gradmesh")
    tree = ET.parse(simplified)
    next(e for e in tree.iter() if e.get("id") == "pear").set("transform", "rotate(20)")
    tree.write(simplified)
    assert run_again(simplified).error > 0.005


def test_bicubic_colours_are_remembered(tmp_path):
    bicubic = gradmesh.convert(gradmesh.load(SAMPLES / "tensor.svg"), "hemesh").document
    gradmesh.save(bicubic, tmp_path / "silk.hemesh")
    svg, again = tmp_path / "silk.svg", tmp_path / "again.svg"
    options = ("--method", "grid", "--epsilon", 0.02)
    command("simplify", tmp_path / "silk.hemesh", "-o", svg, *options)
    command("simplify", svg, "-o", again, "--method", "random", "--epsilon", 0.03)
    assert flip(tmp_path / "silk.hemesh", again) <= 0.0301  # in a frame of its own


def test_inkscape_keeps_the_memory(inkscape, simplified):
    (saved,) = export(inkscape, [simplified], kind="svg")
    assert saved.read_bytes() != simplified.read_bytes()
    for name in ("original", "written"):
        assert group(saved).get(GRADMESH + name) == group(simplified).get(GRADMESH + name)
    result = run_again(saved, "random", seed=1)
    assert 0.009 < result.error <= EPSILON + ROUNDING  # an edited mesh would begin with 0
    assert flip(FRUIT, saved) <= EPSILON
