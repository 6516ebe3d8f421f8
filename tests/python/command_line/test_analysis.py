"""Analyses kept in a file: what is priced once is never priced again, and strangers are refused."""

import json
import re

import pytest

from built import SAMPLES
from hemesh_files import grid
from program import printed, refused, simplified as reported

import gradmesh

FRUIT = SAMPLES / "fruit.svg"
COARSE = ("--resolution", 150)
DAMAGED, NO_ANALYSIS = "this analysis is damaged or cut off.", "this is no file with an analysis."


@pytest.fixture(scope="module")
def prices(tmp_path_factory):
    """What `analyze` knows of the fruit up to epsilon 0.01: few enough regions for all to grow."""
    path = tmp_path_factory.mktemp("analysis") / "prices.json"
    said = printed("analyze", FRUIT, "-o", path, "--epsilon", 0.01, *COARSE)
    (analysis,) = json.loads(path.read_text())["analyses"]
    assert said == f"{path}: {len(analysis['prices'])} prices\n"
    return path


def listed(path):
    """The prices of all meshes in a file, one below the other."""
    return [price for mesh in json.loads(path.read_text())["analyses"] for price in mesh["prices"]]


def simplified(folder, *options):
    """The document that comes out, and what the report says of its only mesh."""
    (mesh,) = reported(FRUIT, folder / "out.svg", *COARSE, *options)
    return (folder / "out.svg").read_bytes(), mesh


@pytest.mark.parametrize(
    "options",
    [
        ("gqe", "--epsilon", 0.01),
        ("gqe", "--epsilon", 0.005),
        ("gqe", "--epsilon", 0.01, "--omega", 0.3),
        ("gqe1", "--epsilon", 0.008),
    ],
)
@pytest.mark.full(all_but=1)
def test_nothing_is_priced_anew(tmp_path, prices, options):
    options = ("--method", *options)
    alone, loaded = tmp_path / "alone.json", tmp_path / "loaded.json"
    expected, told = simplified(tmp_path, *options, "--save-analysis", alone)
    document, quick = simplified(
        tmp_path, *options, "--load-analysis", prices, "--save-analysis", loaded
    )
    assert document == expected
    assert quick["error"] == told["error"]
    measured = sum(price[4] is not None for price in listed(alone))
    assert measured > 100
    assert quick["evaluations"] == told["evaluations"] - measured
    assert loaded.read_bytes() == prices.read_bytes()


@pytest.mark.parametrize("options", [("--epsilon", 0.02), ("--epsilon", 0.01, "--kappa", 0.3)])
def test_motorcycle_prices_no_edge_anew_that_is_known(tmp_path, prices, options):
    options = ("--method", "motorcycle", *options)
    expected, told = simplified(tmp_path, *options)
    document, quick = simplified(tmp_path, *options, "--load-analysis", prices)
    assert document == expected
    # Edges above the analysis's epsilon are only known to be above it.
    edges = [price for price in listed(prices) if price[2] * price[3] == 2]
    known = sum(price[5] and price[4] is not None for price in edges)
    assert known > 100
    assert quick["evaluations"] == told["evaluations"] - known


def test_a_larger_epsilon_prices_only_what_is_missing(tmp_path, prices):
    more, fresh = tmp_path / "more.json", tmp_path / "fresh.json"
    wide = ("--epsilon", 0.04)
    for path, options in ((more, ["--load-analysis", prices]), (fresh, [])):
        printed("analyze", FRUIT, "-o", path, *options, *wide, *COARSE)

    def exact(path):
        return {tuple(p[:4]): p[4] for p in listed(path) if p[5] and (p[4] or 0) <= 0.04}

    assert exact(prices).items() <= exact(more).items()
    assert exact(fresh).items() <= exact(more).items()
    assert len(exact(fresh)) > len(exact(prices))
    documents = {simplified(tmp_path, *wide, "--load-analysis", p)[0] for p in (more, fresh)}
    assert documents == {simplified(tmp_path, *wide)[0]}


def test_from_python(tmp_path, prices):
    document, path = gradmesh.load(FRUIT), tmp_path / "prices.json"
    count = gradmesh.analyze(document, path, epsilon=0.01, resolution=150)
    assert count == len(listed(path))
    assert path.read_bytes() == prices.read_bytes()
    options = {"method": "gqe", "epsilon": 0.01, "resolution": 150}
    again = tmp_path / "again.json"
    (result,) = gradmesh.simplify(document, load_analysis=path, save_analysis=again, **options)
    assert again.read_bytes() == path.read_bytes()
    untouched = gradmesh.load(FRUIT)
    (expected,) = gradmesh.simplify(untouched, **options)
    assert result.evaluations < expected.evaluations
    assert document.to_bytes() == untouched.to_bytes()
    with pytest.raises(gradmesh.InputError, match="the metric flip, not ssim"):
        gradmesh.analyze(
            gradmesh.load(FRUIT), again, metric="ssim", resolution=150, load_analysis=path
        )


def test_several_meshes_share_a_file(tmp_path):
    two, path, options = SAMPLES / "two.svg", tmp_path / "prices.json", (*COARSE, "--epsilon", 0.002)
    printed("analyze", two, "-o", path, *options)
    assert len(json.loads(path.read_text())["analyses"]) == 2
    only = ("--method", "gqe", "--id", "cap", "--load-analysis", path)
    printed("simplify", two, "-o", tmp_path / "out.svg", *options, *only)


def size(resolution):
    height, width = gradmesh.render(gradmesh.load(FRUIT), resolution=resolution).shape[:2]
    return f"{width} x {height}"


def test_other_options_and_damage_are_refused(tmp_path, prices):
    text, path, out = prices.read_text(), tmp_path / "prices.json", tmp_path / "out.svg"
    arguments = ("simplify", FRUIT, "-o", out, "--method", "gqe", "--load-analysis", path)
    at = f"this analysis was made at {size(150)} pixels, not {size(151)} pixels."
    for written, options, sentence in (
        (text, ["--metric", "ssim", *COARSE], "this analysis was made with the metric flip, not ssim."),
        (text, ["--resolution", 151], at),
        (text[: len(text) // 2], [], DAMAGED),
        (text.replace('"prices":[[0', '"prices":[[1', 1), [], DAMAGED),
        ("", [], NO_ANALYSIS),
        ("<svg/>", [], NO_ANALYSIS),
    ):
        path.write_text(written)
        assert refused(*arguments, *options) == f"{path}: {sentence}"
    path.unlink()
    assert refused(*arguments) == f"{path} cannot be read: No such file or directory."
    assert not out.exists()


def test_a_changed_mesh_is_refused(tmp_path, prices):
    changed, out = tmp_path / "fruit.svg", tmp_path / "out.svg"
    color = r"(<meshpatch.*?stop-color:)#\w{6}"
    changed.write_text(re.sub(color, r"\1#123456", FRUIT.read_text(), count=1, flags=re.DOTALL))
    said = refused("draw", changed, "-o", out, "--show", "errors", *COARSE, "--load-analysis", prices)
    assert said == f"{prices}: this analysis is of another mesh, or the mesh was changed since."


def test_what_cannot_be_saved_leaves_the_document_alone(tmp_path):
    missing, simplify = tmp_path / "missing" / "prices.json", ("simplify", FRUIT, "-o", tmp_path / "out.svg")
    said = refused(*simplify, "--method", "grid", "--save-analysis", tmp_path / "prices.json", code=2)
    assert said == "the method grid needs no analysis, so there is none to save."
    said = refused(*simplify, "--method", "motorcycle", *COARSE, "--save-analysis", missing)
    assert said == f"{missing} cannot be written: No such file or directory."
    assert not list(tmp_path.iterdir())


def test_the_color_model_counts(tmp_path):
    leaf, path = tmp_path / "leaf.hemesh", tmp_path / "prices.json"
    leaf.write_text(grid(3, 3))
    bilinear = ("--color-model", "bilinear")
    printed("analyze", leaf, "-o", path, *COARSE, *bilinear)
    loaded = ("draw", leaf, "-o", tmp_path / "out.svg", "--show", "regions", *COARSE, "--load-analysis", path)
    assert refused(*loaded) == f"{path}: this analysis was made in the color model bilinear, not bicubic."
    printed(*loaded, *bilinear)


@pytest.mark.full
def test_a_cache_keeps_what_was_priced(tmp_path):
    def left(**options):
        document = gradmesh.load(SAMPLES / "two.svg")
        results = gradmesh.simplify(document, method="best", resolution=150, **options)
        return document.to_bytes(), sum(result.evaluations for result in results)

    cache = tmp_path / "cache"
    cache.mkdir()
    alone, all_of_them = left()
    assert left(analysis_cache=cache) == (alone, all_of_them)
    files = sorted(cache.iterdir())
    assert len(files) == 2  # one for each mesh
    again, few = left(analysis_cache=cache)
    assert again == alone and few < all_of_them / 2

    files[0].write_text("no analysis")
    mended, some = left(analysis_cache=cache)
    assert mended == alone and few < some < all_of_them
    assert left(analysis_cache=cache) == (alone, few)
    assert left(analysis_cache=tmp_path / "nowhere") == (alone, all_of_them)
