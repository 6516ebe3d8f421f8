"""Methods of choosing edges and their options, from the command line and from Python."""

import json

import pytest

from built import SAMPLES, gradmesh as run
from hemesh_files import grid

import gradmesh

FRUIT = SAMPLES / "fruit.svg"
METHODS = ("random", "grid", "dual-grid", "motorcycle", "gqe", "gqe1", "best", "plain")


def simplified(**options):
    document = gradmesh.load(FRUIT)
    (result,) = gradmesh.simplify(document, **{"resolution": 100, **options})
    return result, document.to_bytes()


FROM_BOTH_SIDES = [
    *({"method": method, "seed": 3} for method in METHODS),
    *({"method": "gqe", "omega": omega} for omega in (0, 1)),
    *({"method": "motorcycle", "kappa": kappa} for kappa in (0, 20)),
    {"amount": "strong", "metric": "ssim"},
]


@pytest.mark.parametrize("options", FROM_BOTH_SIDES, ids=str)
@pytest.mark.full(all_but=1)
def test_every_option_from_both_sides(tmp_path, options):
    out, report = tmp_path / "out.svg", tmp_path / "report.json"
    flags = [text for name, value in options.items() for text in (f"--{name}", value)]
    done = run("simplify", FRUIT, "-o", out, "--resolution", 100, "--report", report, *flags)
    assert (done.returncode, done.stderr) == (0, "")
    (told,) = json.loads(report.read_text())["meshes"]
    assert {name: told[name] for name in options if name != "amount"} == options or "amount" in options
    # With kappa 0 only what costs nothing is merged.
    costs = options.get("kappa") != 0
    assert told["patches_after"] < 132 and costs == (told["error"] > 0) and told["error"] <= told["epsilon"]
    result, data = simplified(**options)
    assert data == out.read_bytes()
    assert {**result.run, "seconds": 0} == {**told, "changed": True, "refused": None, "seconds": 0}


@pytest.mark.module_only
@pytest.mark.parametrize(
    "method, name, values", [("random", "seed", (1, 2)), ("gqe", "omega", (0, 1)), ("motorcycle", "kappa", (0, 20))]
)
@pytest.mark.full(all_but=1)
def test_settings_reach_the_methods(method, name, values):
    made = [simplified(method=method, **{name: value})[1] for value in values]
    assert made[0] != made[1]


@pytest.mark.module_only
def test_by_default_one_object_with_few_handles_is_left(tmp_path):
    out, report = tmp_path / "out.svg", tmp_path / "report.json"
    options = ["--resolution", 100, "--report", report]
    assert run("simplify", FRUIT, "-o", out, *options).returncode == 0
    (told,) = json.loads(report.read_text())["meshes"]
    assert (told["method"], told["objects"]) == ("plain", 1)
    assert told["handles_after"] < told["handles_before"]
    (mesh,) = gradmesh.load(out).meshes
    assert not mesh.simplified and mesh.patches == told["patches_after"]
    results = [simplified(**method) for method in ({}, {"method": "simplest"}, {"method": "plain"})]
    assert [data for _, data in results] == 3 * [out.read_bytes()]


@pytest.mark.module_only
@pytest.mark.parametrize("options", [{"patches": 60}, {"ratio": 0.5, "count": "patches"}, {"count": "patches"}])
@pytest.mark.full
def test_where_patches_are_counted_best_is_the_default(options):
    (result, data), best = simplified(**options), simplified(method="best", **options)
    assert result.method == "best" and data == best[1]
    assert result.patches_after <= options.get("patches", 66)


@pytest.mark.module_only
@pytest.mark.parametrize("target, most", [({"handles": 120}, 120), ({"ratio": 0.5}, 330), ({"handles": 30}, 30)])
@pytest.mark.full(all_but=1)
def test_of_svg_handles_are_counted(target, most):
    (result, data), plain = simplified(**target), simplified(method="plain", **target)
    assert (result.method, result.handles_before) == ("plain", 660) and data == plain[1]
    # Far fewer than asked for would have a needlessly large error.
    assert most / 2 <= result.handles_after <= most


@pytest.mark.module_only
@pytest.mark.full
def test_a_named_method_counts_patches_unless_told():
    best = simplified(method="best", ratio=0.5)[0]
    assert best.patches_after <= 66 and best.handles_after > 330
    assert simplified(method="best", ratio=0.5, count="handles")[0].handles_after <= 330
    assert simplified(method="plain", ratio=0.5, count="patches")[0].patches_after <= 66


@pytest.mark.module_only
def test_of_hemesh_files_patches_are_counted():
    def left(**target):
        document = gradmesh.loads(grid(4, 5), "leaf.hemesh")
        (result,) = gradmesh.simplify(document, resolution=100, **target)
        return result

    assert left(ratio=0.2).patches_after <= 4
    shared, counted = left(ratio=0.5, count="handles"), left(handles=64)
    assert shared.handles_after == counted.handles_after <= 64 == counted.handles_before / 2


@pytest.mark.parametrize(
    "options, words",
    [
        ({"handles": 9, "patches": 3}, "one of these only"),
        ({"handles": 9, "ratio": 0.5}, "one of these only"),
        ({"handles": 9, "count": "patches"}, "a number of handles is no target"),
        ({"patches": 9, "count": "handles"}, "a number of patches is no target"),
        ({"count": "corners"}, "handles or patches, not 'corners'"),
        ({"handles": 0}, "at least 1"),
        ({"amount": "huge"}, "there are: gentle, balanced, strong"),
        ({"amount": "strong", "epsilon": 0.1}, "there is no epsilon"),
        ({"method": "magic"}, "'magic'"),
        ({"method": "manual"}, "needs the edges"),
        ({"edges": [1]}, "manual only"),
        ({"edges": [2**31]}, "half-edges are below"),
        ({"metric": "taste"}, "'taste'"),
        ({"epsilon": -0.1}, "epsilon"),
        ({"epsilon": float("nan")}, "epsilon"),
        ({"max_local_error": -0.1}, "local error"),
        ({"max_local_error": 2}, "local error"),
        ({"resolution": 15}, "resolution"),
        ({"seed": -1}, "seed"),
        ({"seed": 2**64}, "seed"),
        ({"omega": 1.5}, "omega"),
        ({"omega": float("nan")}, "omega"),
        ({"kappa": -1}, "kappa"),
        ({"time_budget": -1}, "time budget"),
        ({"time_budget": float("inf")}, "time budget"),
        ({"threads": -1}, "threads"),
        ({"kapa": 1}, "no option 'kapa'; there are: .*kappa"),
    ],
)
def test_options_that_make_no_sense_are_refused(options, words):
    document = gradmesh.load(FRUIT)
    with pytest.raises(TypeError if "kapa" in options else ValueError, match=words) as refused:
        gradmesh.simplify(document, **options)
    assert not isinstance(refused.value, gradmesh.InputError)
    assert document.to_bytes() == FRUIT.read_bytes()


def test_the_options_are_listed_with_their_defaults():
    options = gradmesh.options()
    defaults = {"epsilon": 0.01, "resolution": 700, "metric": "flip", "method": "simplest", "visible_only": True}
    assert {name: options[name]["default"] for name in defaults} == defaults
    assert options["method"]["names"] == ["simplest", *METHODS[:7], "lines", "plain", "manual"]


@pytest.mark.module_only
def test_best_is_the_default_of_hemesh_files():
    left = []
    for method in ({}, {"method": "simplest"}, {"method": "best"}):
        document = gradmesh.loads(grid(4, 5), "leaf.hemesh")
        (result,) = gradmesh.simplify(document, resolution=100, **method)
        assert result.method == "best" and result.patches_after < result.patches_before
        left.append(document.to_bytes())
    assert left[0] == left[1] == left[2]


@pytest.mark.module_only
def test_best_is_the_default_of_blocks():
    group = simplified(method="best", resolution=200)[1]
    for method in ({}, {"method": "best"}):
        document = gradmesh.loads(group)
        (result,) = gradmesh.simplify(document, resolution=200, epsilon=0.02, **method)
        assert (result.method, document.meshes[0].simplified) == ("best", True)
        assert result.patches_after < result.patches_before


def mergeable_edge(document):
    """A half-edge whose two patches can be merged, and the result of merging it."""
    for edge in range(4 * 132):
        try:
            (result,) = gradmesh.simplify(document, method="manual", edges=[edge], preview=True)
            return edge, result
        except gradmesh.InputError:
            pass
    raise AssertionError("no edge can be merged")


def test_named_edges_are_merged_after_a_look_at_their_error(tmp_path):
    document = gradmesh.load(FRUIT)
    edge, told = mergeable_edge(document)
    assert document.to_bytes() == FRUIT.read_bytes()
    assert told.patches_after == 131 and told.error > 0
    (result,) = gradmesh.simplify(document, method="manual", edges=[edge], epsilon=1)
    assert (result.patches_after, result.error) == (131, told.error)
    out = tmp_path / "out.svg"
    manual = ["--method", "manual", "--edges", edge]
    done = run("simplify", FRUIT, "--preview", *manual)
    assert f"131 of 132 patches left, {told.objects} objects, FLIP {told.error:.5f}" in done.stdout
    assert list(tmp_path.iterdir()) == []
    assert run("simplify", FRUIT, "-o", out, *manual, "--epsilon", 1).returncode == 0
    assert out.read_bytes() == document.to_bytes()
    # Above epsilon the preview still tells the error; the simplification refuses.
    strict = ["--epsilon", told.error / 2]
    again = run("simplify", FRUIT, "--preview", *manual, *strict)
    assert f"131 of 132 patches left, {told.objects} objects, FLIP {told.error:.5f}" in again.stdout
    refused = run("simplify", FRUIT, "-o", out, *manual, *strict)
    assert refused.returncode == 1 and f"half-edge {edge}" in refused.stderr


def test_a_preview_says_what_a_run_does(tmp_path):
    document = gradmesh.load(FRUIT)
    (told,) = gradmesh.simplify(document, resolution=100, preview=True)
    assert document.to_bytes() == FRUIT.read_bytes() and not document.meshes[0].simplified
    (done,) = gradmesh.simplify(document, resolution=100)
    assert (told.patches_after, told.error) == (done.patches_after, done.error)
    both = run("simplify", FRUIT, "--preview", "-o", tmp_path / "out.svg")
    neither = run("simplify", FRUIT)
    assert (both.returncode, neither.returncode) == (2, 2)


@pytest.mark.parametrize("edges", [[100000], [-1]])
def test_edges_that_are_not_there(edges):
    with pytest.raises(gradmesh.InputError, match=f'"pear": .*half-edge {edges[0]}'):
        gradmesh.simplify(gradmesh.load(FRUIT), method="manual", edges=edges)


def test_edges_are_named_of_one_mesh():
    two = gradmesh.load(SAMPLES / "two.svg")
    with pytest.raises(gradmesh.InputError, match="2 meshes"):
        gradmesh.simplify(two, method="manual", edges=[4])
    with pytest.raises(gradmesh.InputError, match='"cap": there is no half-edge 1000000'):
        gradmesh.simplify(two, "cap", method="manual", edges=[10**6])
