"""Whatever the document is: a result, or one plain sentence. Property tests with fixed seeds."""

import random

import pytest

import built
from lattices import gradient
from random_meshes import Kind

gradmesh = pytest.importorskip("gradmesh", reason="the compiled package is not there")
hypothesis = pytest.importorskip("hypothesis", reason="Debian package python3-hypothesis is absent")
from hypothesis import given, settings, strategies as st  # noqa: E402

SAMPLES = sorted(built.SAMPLES.glob("*.svg"))

thoroughly = settings(max_examples=500, deadline=None, derandomize=True)
moderately = settings(max_examples=120, deadline=None, derandomize=True)


def expect_one_sentence(error, name):
    text = str(error)
    assert "\n" not in text
    assert text.endswith(".")
    assert name in text
    assert "Traceback" not in text and "std::" not in text


def try_all(data, name="drawing.svg"):
    """Reads, paints and simplifies; True where the document was good."""
    try:
        document = gradmesh.loads(data, name)
        for mesh in document.meshes:
            gradmesh.render(document, mesh.id, 32)
        gradmesh.simplify(document, method="grid", resolution=32, epsilon=0.05, time_budget=2)
        assert gradmesh.loads(document.to_bytes(), name).meshes
    except gradmesh.InputError as error:
        expect_one_sentence(error, name)
        return False
    return True


@thoroughly
@given(
    sample=st.sampled_from([p for p in SAMPLES if p.stem in ("tensor", "stroke", "ellipse")]),
    seed=st.integers(0, 2**32),
    kind=st.sampled_from(["cut", "byte", "number", "drop", "double"]),
)
@pytest.mark.full
def test_spoiled_documents(sample, seed, kind):
    chance = random.Random(seed)
    text = sample.read_text()
    at = chance.randrange(len(text))
    if kind == "cut":
        text = text[:at]
    elif kind == "byte":
        text = text[:at] + chance.choice("<>&\"' #\x00é0z-,") + text[at + 1 :]
    else:
        # A token inside a path, a colour or the like, put out, doubled or made extreme.
        tokens = text.split(" ")
        i = chance.randrange(len(tokens))
        extreme = ["1e30", "-1e30", "NaN", "inf", "0", "1e-30", "99999999999999999999", "-0.0"]
        if kind == "drop":
            del tokens[i]
        elif kind == "double":
            tokens.insert(i, tokens[i])
        else:
            tokens[i] = chance.choice(extreme)
        text = " ".join(tokens)
    try_all(text)


def grid_document(chance, rows, columns, noise, opacity):
    """A rectangular mesh with random corners, handles and colours."""
    mesh = Kind(noise=noise).mesh(chance, rows, columns)
    mesh.colours = [[(*colour[:3], opacity) for colour in line] for line in mesh.colours]
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" width="500" height="500">'
        f'<defs>{gradient(mesh)}</defs><rect id="r" width="500" height="500" fill="url(#m)"/></svg>'
    )


@moderately
@given(
    seed=st.integers(0, 2**32),
    rows=st.integers(1, 6),
    columns=st.integers(1, 6),
    noise=st.sampled_from([0.0, 0.02, 0.2, 1.0, 5.0]),
    opacity=st.sampled_from([1, 0.5, 0]),
    epsilon=st.sampled_from([0.0, 0.01, 0.1, 1.0]),
    metric=st.sampled_from(["flip", "ssim"]),
    method=st.sampled_from(["random", "grid", "dual-grid", "motorcycle", "gqe", "gqe1", "best"]),
)
@pytest.mark.full
def test_random_meshes(seed, rows, columns, noise, opacity, epsilon, metric, method):
    data = grid_document(random.Random(seed), rows, columns, noise, opacity)
    document = gradmesh.loads(data)
    (before,) = document.meshes
    assert before.patches == rows * columns
    options = {"method": method, "epsilon": epsilon, "metric": metric, "resolution": 80}
    (result,) = gradmesh.simplify(document, seed=seed, **options)
    assert result.patches_before == before.patches
    assert result.patches_after <= before.patches
    assert 0 <= result.error <= epsilon
    (after,) = gradmesh.loads(document.to_bytes()).meshes
    assert after.patches == result.patches_after
    assert after.id == "r"
    if result.patches_after == before.patches:
        assert document.to_bytes() == data.encode()
        assert result.stopped == "nothing to merge"
    else:
        # Again, on what was written: never more patches, and still a good document.
        (again,) = gradmesh.simplify(document, **options)
        assert again.patches_after <= result.patches_after
        assert gradmesh.loads(document.to_bytes()).meshes[0].patches == again.patches_after


def test_the_samples_themselves_are_good():
    for sample in SAMPLES:
        assert try_all(sample.read_bytes(), sample.name)
