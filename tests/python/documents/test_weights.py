"""Errors count more or less often in what shapes cover: the same from every side, and in sentences where
that cannot be."""

import json
import math

import pytest

from built import PROGRAM, SAMPLES
from program import printed, refused, simplified

import gradmesh
from gradmesh import core as cores
from gradmesh import helper as helpers

FACE = (SAMPLES / "face.svg").read_text()
#: Over the eyes of the sample, inside that, over all of it, and what is no shape.
SHAPES = (
    '<rect id="eyes" x="165" y="275" width="190" height="40" fill="none"/>'
    '<rect id="brow" x="180" y="280" width="90" height="30" fill="none"/>'
    '<rect id="all" width="520" height="620" fill="none"/>'
    '<g id="nothing"/>'
)
SIZE = {"resolution": 100}
OPTIONS = ("--resolution", 100)


@pytest.fixture
def svg(tmp_path):
    file = tmp_path / "face.svg"
    file.write_text(FACE.replace("</svg>", SHAPES + "</svg>"))
    return file


def by_python(svg, **options):
    document = gradmesh.load(svg)
    (result,) = gradmesh.simplify(document, **SIZE, **options)
    return result, document.to_bytes()


@pytest.mark.parametrize("method", ["plain", "gqe"])
@pytest.mark.full
def test_the_same_from_every_side(svg, tmp_path, monkeypatch, method):
    out = tmp_path / "out.svg"
    weights = {"all": 0.5, "eyes": 4}
    flags = [part for id, factor in weights.items() for part in ("--weigh", f"{id}={factor}")]
    (told,) = simplified(svg, out, *OPTIONS, "--method", method, *flags)
    assert told["weights"] == [{"id": "all", "factor": 0.5}, {"id": "eyes", "factor": 4}]
    (plain,) = simplified(svg, tmp_path / "plain.svg", *OPTIONS, "--method", method)
    assert "weights" not in plain and plain["handles_after"] != told["handles_after"]

    result, written = by_python(svg, method=method, weights=weights)
    assert written == out.read_bytes() and result.error == told["error"]
    assert result.run["weights"] == told["weights"] and result.renderer == "software"
    helper = cores.Core(helpers.Helper(PROGRAM, cores.PROTOCOL))
    monkeypatch.setattr(cores, "_core", helper)
    assert by_python(svg, method=method, weights=weights)[1] == written


@pytest.mark.full
def test_a_factor_of_one_changes_nothing(svg):
    assert by_python(svg, weights={"eyes": 1})[1] == by_python(svg)[1] == by_python(svg, weights={})[1]


@pytest.mark.full
def test_more_is_kept_where_errors_count_more(svg):
    numpy = pytest.importorskip("numpy")
    size = {"resolution": 300}
    original = gradmesh.load(svg)
    before = gradmesh.render(original, "face", **size)
    left, top, right, bottom = gradmesh.Session(original, "face", **size).box
    height, width = before.shape[:2]
    # The frame is the box of the mesh with a padding all around.
    scale = height / (1.03 * (bottom - top))
    x, y = (width - scale * (left + right)) / 2, (height - scale * (top + bottom)) / 2

    def handles_and_error_of_eyes(**weights):
        document = gradmesh.load(svg)
        (result,) = gradmesh.simplify(document, method="plain", amount="balanced", weights=weights, **size)
        after = gradmesh.render(document, "face", framed_as=original, **size)
        errors = gradmesh.differences(before, after)
        (x0, y0), (x1, y1) = [(round(x + scale * a), round(y + scale * b)) for a, b in ((165, 275), (355, 315))]
        return result.handles_after, float(numpy.mean(errors[y0:y1, x0:x1]))

    handles, error = handles_and_error_of_eyes()
    assert handles_and_error_of_eyes(eyes=4)[1] < error / 2
    fewer, larger = handles_and_error_of_eyes(all=0.25)
    assert fewer < handles and larger > error


@pytest.mark.full
def test_where_shapes_overlap_the_last_one_counts(svg):
    alone = by_python(svg, weights={"all": 0.25})[1]
    assert by_python(svg, weights={"eyes": 4, "all": 0.25})[1] == alone
    assert by_python(svg, weights={"all": 0.25, "eyes": 4})[1] != alone
    assert by_python(svg, weights={"eyes": 4, "brow": 4})[1] == by_python(svg, weights={"eyes": 4})[1]


@pytest.mark.full
def test_curves_and_sessions_are_weighted(svg, tmp_path):
    curve, state = tmp_path / "curve.json", tmp_path / "state.svg"
    printed("simplify", svg, "--curve", curve, *OPTIONS, "--weigh", "eyes=4")
    (found,) = json.loads(curve.read_text())["meshes"]
    document = gradmesh.load(svg)
    session = gradmesh.Session(document, weights={"eyes": 4}, **SIZE)
    status = session.refresh(wait=True)
    assert status["curves"]["one gradient"]["states"] == found["states"]
    balanced = found["marks"]["balanced"]
    printed("simplify", svg, "-o", state, "--state", balanced, *OPTIONS, "--weigh", "eyes=4")
    session.show("one gradient", balanced)
    session.write()
    assert document.to_bytes() == state.read_bytes()
    assert state.read_bytes() == by_python(svg, amount="balanced", weights={"eyes": 4})[1]


@pytest.mark.full
def test_blocks_of_a_weighted_mesh_become_as_simple(svg, tmp_path):
    """Weights raise the errors of details, which no price of a merge knows. What an amount leaves is the
    curve's state of that amount, unless one with a smaller error has fewer handles already."""
    weighted = ("--weigh", "eyes=4", "--resolution", 250, "--method", "best")
    curve, state, out = tmp_path / "curve.json", tmp_path / "state.svg", tmp_path / "out.svg"
    printed("simplify", svg, "--curve", curve, *weighted)
    (found,) = json.loads(curve.read_text())["meshes"]
    assert set(found["marks"]) == {"gentle", "balanced", "strong"}
    for amount, marked in found["marks"].items():
        (told,) = simplified(svg, out, *weighted, "--count", "handles", "--amount", amount)
        assert told["handles_after"] < 0.7 * told["handles_before"]
        handles = found["states"][marked]["handles"]
        assert handles <= told["handles_after"]
        if handles < told["handles_after"]:
            assert found["states"][marked]["error"] < told["error"]
            continue
        printed("simplify", svg, "-o", state, "--state", marked, *weighted)
        assert out.read_bytes() == state.read_bytes()


def test_prices_are_of_their_weights_alone(svg, tmp_path):
    saved, out = tmp_path / "prices", tmp_path / "out.svg"
    priced = (*OPTIONS, "--method", "gqe", "--quiet")
    printed("simplify", svg, "-o", out, *priced, "--weigh", "eyes=4", "--save-analysis", saved)
    again = tmp_path / "again.svg"
    printed("simplify", svg, "-o", again, *priced, "--weigh", "eyes=4", "--load-analysis", saved)
    assert again.read_bytes() == out.read_bytes()
    for others in ((), ("--weigh", "eyes=2"), ("--weigh", "brow=4")):
        assert saved.name in refused("simplify", svg, "-o", again, *priced, *others, "--load-analysis", saved)


@pytest.mark.parametrize(
    "given, words",
    [
        ("nose=4", 'face.svg: there is no object with the id "nose".'),
        ("nothing=4", 'face.svg: "nothing" is no shape, so it covers nothing.'),
    ],
)
def test_shapes_that_are_none_are_named(svg, tmp_path, given, words):
    out = tmp_path / "out.svg"
    assert words in refused("simplify", svg, "-o", out, "--weigh", given)
    assert not out.exists()
    id, factor = given.split("=")
    with pytest.raises(gradmesh.InputError, match=words):
        by_python(svg, weights={id: float(factor)})


@pytest.mark.parametrize("factor", [0.2, 4.1, 0, -1, math.inf, math.nan])
def test_factors_out_of_range(svg, tmp_path, factor):
    words = "the weight of eyes must be between 0.25 and 4."
    said = refused("simplify", svg, "-o", tmp_path / "out.svg", "--weigh", f"eyes={factor}", code=2)
    assert said == words
    with pytest.raises(ValueError, match=words):
        by_python(svg, weights={"eyes": factor})
    with pytest.raises(ValueError, match=words):
        gradmesh.Session(gradmesh.load(svg), weights={"eyes": factor})


@pytest.mark.parametrize("text", ["eyes", "eyes=", "=4", "eyes=much", "eyes=4x"])
def test_what_is_no_factor_on_the_command_line(svg, tmp_path, text):
    said = refused("simplify", svg, "-o", tmp_path / "out.svg", "--weigh", text, code=2)
    assert said == f'--weigh needs an id and a number, as in eyes=4, not "{text}".'


@pytest.mark.parametrize("weights", [{"eyes": "4"}, {"eyes": None}, {4: 4}, "eyes", 4, [["eyes"]]])
def test_what_is_no_factor_in_python(svg, weights):
    with pytest.raises(TypeError):
        by_python(svg, weights=weights)


def test_only_svg_has_shapes(svg, tmp_path):
    hemesh = tmp_path / "face.hemesh"
    printed("convert", svg, hemesh, "--id", "face")
    said = refused("simplify", hemesh, "-o", tmp_path / "out.hemesh", "--weigh", "eyes=4")
    assert said == f"{hemesh}: shapes that cover parts of a mesh are known in SVG documents only."
