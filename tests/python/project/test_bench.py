"""scripts/bench: that it prints its tables and keeps them; and the arithmetic of its goals.

Nothing here is timed: what a figure is does not matter, only what is made of it."""

import json
import sys

import pytest
from built import BUILD, ROOT, script
from program import printed

sys.path.insert(0, str(ROOT / "benchmarks"))

import figures  # noqa: E402
import measure  # noqa: E402
import tables  # noqa: E402
from drawing import cloth  # noqa: E402


def require_benchmarks():
    built = measure.cache(BUILD)
    if not (BUILD / "gradmesh_bench").exists():
        pytest.skip("the benchmarks are not built (libbenchmark-dev)")
    if built.get("CMAKE_BUILD_TYPE") != "Release" or built.get("GRADMESH_SANITIZE"):
        pytest.skip("benchmarks are of Release builds only")


@pytest.mark.full
def test_tables_are_printed_and_kept(tmp_path):
    require_benchmarks()
    kept = tmp_path / "bench.json"
    only = r"^ssim/1-thread$|^skimage|^growth/(ssim/resolution/|gqe/patches/25$)|^candidate/ssim"
    done = script("bench", "--quick", "--no-build", "--only", only, "--json", kept)
    assert done.returncode == 0, done.stderr
    found = json.loads(kept.read_text())

    lines = found["lines"]
    assert "growth/ssim/resolution/350" in lines and "growth/ssim/resolution/1400" not in lines
    assert all(f"| {name} " in done.stdout for name, line in lines.items() if "seconds" in line)
    assert lines["growth/gqe/patches/25"]["patches"] == 25
    assert lines["growth/gqe/patches/25"]["left"] < 25
    assert list(found["growth"]) == ["growth/ssim/resolution"]
    assert "| growth/ssim/resolution | 350 to 700 |" in done.stdout

    goals = {goal["work"]: goal for goal in found["goals"]}
    ssim = goals["SSIM 700x700, one thread, the reference image known, against scikit-image"]
    if "left_out" in lines["skimage/ssim"]:
        assert ssim["reached"] is None
        assert "- skimage/ssim: " in done.stdout
    else:
        # Both have measured the same two images, but for what they do at borders.
        assert lines["skimage/ssim"]["error"] == pytest.approx(lines["ssim/1-thread"]["error"], abs=1e-3)
        assert ssim["reached"] == (ssim["value"] >= 30)
    assert goals["Duck, from the command line"]["reached"] is None


def test_what_cannot_be_selected_is_said():
    require_benchmarks()
    done = script("bench", "--no-build", "--only", "^no such line$")
    assert done.returncode == 1
    assert done.stderr.endswith("No line has a name in which ^no such line$ is found.\n")
    assert script("bench", "--only", "(").returncode == 2


def test_the_exponent_is_that_of_a_power():
    assert figures.fitted_exponent([(n, 3 * n**1.3) for n in (25, 100, 400)]) == pytest.approx(1.3)
    # Slopes 0 and 2 on either side.
    assert figures.fitted_exponent([(1, 1), (2, 1), (4, 4)]) == pytest.approx(1)


def test_growth_is_held_against_patches_and_pixels():
    lines = {f"growth/gqe/patches/{n}": {"seconds": n * n} for n in (100, 25, 400)}
    lines |= {f"growth/paint/resolution/{n}": {"seconds": n * n} for n in (350, 700)}
    lines |= {"growth/flip/resolution/700": {"seconds": 1}, "growth/ssim/resolution/350": {"left_out": "why"}}
    found = figures.exponents(lines)
    assert set(found) == {"growth/gqe/patches", "growth/paint/resolution"}
    assert found["growth/gqe/patches"]["exponent"] == pytest.approx(2)
    assert found["growth/gqe/patches"]["points"][0] == (25, 625)
    assert found["growth/paint/resolution"]["exponent"] == pytest.approx(1)


def test_ratios_to_a_peer_at_hand_and_by_the_bridge():
    lines = {
        "ours": {"seconds": 0.01, "clock": "cpu"},
        figures.SKIMAGE: {"seconds": 0.2, "clock": "cpu"},
    }
    assert figures.RatioGoal("", "ours", figures.SKIMAGE, 30).value(lines) == pytest.approx(20)
    # Twice the bridge's seconds there are 0.4 s here.
    there = 2 * figures.SKIMAGE_SECONDS
    assert figures.RatioGoal("", "ours", figures.SKIMAGE, 30, there).value(lines) == pytest.approx(40)
    assert figures.RatioGoal("", "absent", figures.SKIMAGE, 30).value(lines) is None
    lines[figures.SKIMAGE] = {"left_out": "absent"}
    assert figures.RatioGoal("", "ours", figures.SKIMAGE, 30).value(lines) is None


def test_goals_are_reached_from_either_side():
    ratio, limit = figures.RatioGoal("a", "", "", 30), figures.LimitGoal("b", "", "", 1.3, " s")
    assert ratio.reached(30) and not ratio.reached(29.9)
    assert limit.reached(1.3) and not limit.reached(1.31)
    text = "\n".join(tables.goals_table([(ratio, 29.9), (limit, 1.25), (ratio, None)]))
    assert "| a    |  at least 30x |  29.9x |  not reached |" in text
    assert "| b    | at most 1.3 s | 1.25 s |      reached |" in text
    assert "not measured" in text


def test_every_goal_has_its_lines():
    require_benchmarks()
    names = {measure.line_name(name) for name in measure.native_names(BUILD / "gradmesh_bench")}
    if not any(name.startswith("cairo/") for name in names):
        names.add("cairo/paint/duck")
    names |= {figures.SKIMAGE, "growth/gqe/patches", "cli/100-patches", "cli/duck", "cli/1520-patches"}
    for goal in figures.GOALS:
        wanted = {goal.line} if isinstance(goal, figures.LimitGoal) else {goal.ours, goal.peer}
        assert wanted <= names


@pytest.mark.parametrize(
    ("seconds", "text"),
    [(12.345, "12.3 s"), (1, "1.00 s"), (0.12345, "123 ms"), (0.00123, "1.23 ms"), (4.5e-7, "0.45 µs")],
)
def test_times_have_three_digits(seconds, text):
    assert tables.seconds_text(seconds) == text


def test_revisions_side_by_side():
    text = tables.comparison([("a", 0.5, 1.0), ("b", 1.0, None), ("c", None, 1.0)], "new", "old")
    assert "| a | 1.00 s | 500 ms |   2.00x |" in text
    assert "- b: not in old\n- c: not in new\n" in text


def test_drawings_have_their_patches(tmp_path):
    file = tmp_path / "cloth.svg"
    file.write_text(cloth(5, 6))
    assert printed("info", file).startswith("cloth (fill): 579 handles, 120 patches, ")
    assert cloth(5, 6) == cloth(5, 6)
