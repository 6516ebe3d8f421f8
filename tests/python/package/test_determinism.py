"""The same input, options and seed give the same bytes, on any number of threads and in any run."""

import pytest

import built
from sample_meshes import OBJECTS

gradmesh = pytest.importorskip("gradmesh", reason="the compiled package is not there")

METHODS = ("random", "grid", "dual-grid", "motorcycle", "gqe", "gqe1", "best", "lines")
OPTIONS = {"resolution": 48, "seed": 5, "epsilon": 0.02}


LARGE = ("bubble", "cap", "photo")
PRICED = ("motorcycle", "gqe", "gqe1", "best")

pytestmark = pytest.mark.module_only


def simplified(sample, painted, method, threads, **more):
    """The bytes, the error, and how many merges were tried."""
    document = gradmesh.load(built.SAMPLES / f"{sample}.svg")
    options = {**OPTIONS, "method": method, "threads": threads, **more}
    (result,) = gradmesh.simplify(document, painted, **options)
    assert result.patches_after < result.patches_before
    return document.to_bytes(), result.error, result.evaluations


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    "sample, painted",
    [pytest.param(*pair, marks=pytest.mark.long) if pair[1] in LARGE else pair for pair in OBJECTS],
)
@pytest.mark.full(all_but=1)
def test_the_same_bytes_on_any_number_of_threads(sample, painted, method):
    alone = simplified(sample, painted, method, 1)
    for threads in (2, 4):
        assert simplified(sample, painted, method, threads) == alone


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.full(all_but=1)
def test_the_same_bytes_in_every_run(tmp_path, method):
    """Another process has its memory elsewhere."""
    sample, out = built.SAMPLES / "tensor.svg", tmp_path / "out.svg"
    options = [text for name, value in OPTIONS.items() for text in (f"--{name}", value)]
    for threads in (0, 3):
        arguments = ["-o", out, "--method", method, "--threads", threads, *options]
        assert built.gradmesh("simplify", sample, *arguments).returncode == 0
        assert out.read_bytes() == simplified("tensor", "silk", method, 0)[0]


@pytest.mark.parametrize("method", PRICED)
def test_the_same_prices_on_any_number_of_threads(tmp_path, method):
    files = [tmp_path / f"{threads}.json" for threads in (1, 4)]
    for threads, file in zip((1, 4), files):
        simplified("tensor", "silk", method, threads, save_analysis=file)
    assert files[0].read_bytes() == files[1].read_bytes()
