"""A mesh of a picture from Python: gradmesh.trace()."""

import re

import numpy as np
import pytest
from PIL import Image

import gradmesh


@pytest.fixture
def picture(tmp_path):
    """A file with a soft picture of 90 x 70 pixels."""
    y, x = np.mgrid[0:70, 0:90]
    pixels = np.stack([x * 2.5, 255 - y * 3, 128 + 100 * np.sin(x / 20) * np.cos(y / 15)], axis=-1)
    Image.fromarray(pixels.clip(0, 255).astype("uint8")).save(tmp_path / "soft.png")
    return tmp_path / "soft.png"


def test_a_mesh_that_looks_like_the_picture(picture):
    traced = gradmesh.trace(picture, handles=100, epsilon=0)
    (mesh,) = traced.document.meshes
    assert mesh.handles == traced.handles == (traced.rows + 1) * (traced.columns + 1) <= 100
    assert traced.patches == traced.rows * traced.columns == mesh.patches
    assert traced.errors == traced.errors_without_detail
    assert 0 < traced.errors.mean < traced.errors.rmse < 2 and traced.errors.flip < 0.035
    assert traced.advice is None and not traced.stopped


@pytest.mark.full
def test_an_amount_stands_for_an_epsilon(picture):
    gentle, balanced, strong = (gradmesh.trace(picture, amount=name) for name in ("gentle", "balanced", "strong"))
    assert gentle.errors.flip < balanced.errors.flip <= 0.03 < strong.errors.flip
    assert gentle.handles > balanced.handles > strong.handles
    assert gradmesh.trace(picture).handles == balanced.handles


def test_what_is_not_like_the_picture_comes_with_advice(picture):
    traced = gradmesh.trace(picture, handles=4)
    assert traced.handles == 4
    assert traced.advice.startswith("with 4 handles ") and traced.advice.endswith("Trace Bitmap.")


def test_progress_is_told_and_may_end_it(picture):
    seen = []

    def stop_at_fifty(progress):
        seen.append(progress.handles)
        return progress.handles < 50

    traced = gradmesh.trace(picture, epsilon=0, progress=stop_at_fifty)
    assert traced.stopped and traced.handles == seen[-1] < 80
    assert seen == sorted(seen)


def test_a_shape_on_the_picture_becomes_the_mesh(picture, tmp_path):
    outline = tmp_path / "outline.svg"
    outline.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="90" height="70">'
        '<circle id="spot" cx="40" cy="35" r="22"/><rect id="other" width="9" height="9"/></svg>'
    )
    traced = gradmesh.trace(picture, outline=(outline, "spot"), handles=36, epsilon=0)
    assert traced.id == "spot" and traced.handles <= 36 and traced.errors.mean < 1
    assert [mesh.id for mesh in traced.document.meshes] == ["spot"]
    with pytest.raises(gradmesh.InputError, match="no object with the id"):
        gradmesh.trace(picture, outline=(outline, "none"))
    with pytest.raises(gradmesh.InputError, match="it shows no picture"):
        gradmesh.trace(outline=(outline, "spot"))
    with pytest.raises(TypeError):
        gradmesh.trace()


def document_on(picture):
    return gradmesh.loads(
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="90" height="70">'
        f'<image id="photo" width="90" height="70" xlink:href="{picture.name}"/>'
        '<circle id="spot" cx="40" cy="35" r="22"/><circle id="far" cx="400" r="9"/></svg>',
        folders=[picture.parent / "none", picture.parent],
    )


def spotted(path):
    """A picture of 120 x 60 pixels with two spots of equal rings, at (30, 30) and (90, 30)."""
    y, x = np.mgrid[0:60, 0:120]
    away = [np.hypot(x - at, y - 30) for at in (30, 90)]
    pixels = np.repeat((128 + 100 * sum(np.exp(-((r / 12) ** 2)) * np.cos(r / 2) for r in away))[..., None], 3, axis=2)
    Image.fromarray(pixels.clip(0, 255).astype("uint8")).save(path)
    return pixels


# A mesh of the size of such a picture.
PAGE = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="120" height="60"><defs>'
    '<meshgradient id="m" gradientUnits="userSpaceOnUse" x="0" y="0"><meshrow><meshpatch>'
    '<stop path="l120,0" stop-color="#fff"/><stop path="l0,60" stop-color="#fff"/>'
    '<stop path="l-120,0" stop-color="#fff"/><stop path="l0,-60" stop-color="#fff"/>'
    '</meshpatch></meshrow></meshgradient></defs><rect id="page" width="120" height="60" fill="url(#m)"/></svg>'
)


def test_what_counts_more_comes_closer(tmp_path):
    wanted = spotted(tmp_path / "spots.png")
    text = (
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="120" height="60">'
        '<image id="photo" width="120" height="60" xlink:href="spots.png"/>'
        '<circle id="eye" cx="30" cy="30" r="18"/></svg>'
    )
    (tmp_path / "spots.svg").write_text(text)
    page = gradmesh.loads(PAGE, folders=[tmp_path])

    def squares_at_the_eye(document):
        # With the two pixels that are painted around a mesh.
        painted = gradmesh.render(document, resolution=124, framed_as=page)[2:62, 2:122].astype(float)
        return np.square(painted - wanted)[12:48, 12:48].mean()

    documents = [gradmesh.load(tmp_path / "spots.svg") for _ in range(2)]
    for document, weights in zip(documents, (None, {"eye": 4})):
        gradmesh.trace_in(document, ["photo"], handles=80, epsilon=0, weights=weights)
    assert squares_at_the_eye(documents[1]) < 0.6 * squares_at_the_eye(documents[0])


def test_pictures_of_a_document_become_meshes_in_place(picture, tmp_path):
    document = document_on(picture)
    spot, whole = gradmesh.trace_in(document, ["spot", "photo"], handles=36)
    assert spot.id == "spot" and whole.id.startswith("photo-mesh")
    assert document.ids == [whole.id, "spot"]
    assert spot.document is whole.document is document
    assert spot.handles <= 36 and spot.errors.mean < 1 and whole.handles <= 36 and whole.errors.mean < 4


def test_a_document_stays_as_it_was_where_one_mesh_of_several_cannot_be_made(picture, tmp_path):
    document = document_on(picture)
    before = document.to_bytes()
    with pytest.raises(gradmesh.InputError, match='"far" does not lie on the picture'):
        gradmesh.trace_in(document, ["spot", "far"], handles=16)
    with pytest.raises(gradmesh.InputError, match='no picture with the id "spot"'):
        gradmesh.trace_in(document, ["spot"], image="spot", handles=16)
    with pytest.raises(ValueError):
        gradmesh.trace_in(document, ["spot"], handles=3)
    assert document.to_bytes() == before and document.ids == []


def test_what_is_ended_early_leaves_the_meshes_after_it(picture, tmp_path):
    document = document_on(picture)
    seen = []

    def stop_in_the_second(progress):
        seen.append((progress.mesh, progress.meshes))
        return progress.mesh == 0

    made = gradmesh.trace_in(
        document, ["spot", "photo", "spot"], handles=16, progress=stop_in_the_second
    )
    assert [each.stopped for each in made] == [False, True]
    assert seen[0] == (0, 3) and seen[-1] == (1, 3)


def test_what_the_mesh_looks_like_so_far_is_shown(picture, tmp_path):
    document, shown = document_on(picture), []
    gradmesh.trace_in(document, ["photo"], handles=60, show=lambda *seen: shown.append(seen))
    with Image.open(picture) as file:
        wanted = np.asarray(file, dtype=float)
    for width, height, pixels in shown:
        painted = np.frombuffer(pixels, dtype="uint8").reshape(height, width, 3)
        assert np.abs(painted - wanted).mean() < 20
    without = document_on(picture)
    gradmesh.trace_in(without, ["photo"], handles=60)
    assert shown and document.to_bytes() == without.to_bytes()


def as_simple_as(document, id, **options):
    (result,) = gradmesh.simplify(document, [id], method="plain", **options)
    return result


def test_a_traced_mesh_is_measured_against_its_picture(picture, tmp_path):
    """Also when the document was saved, and by the error that the trace had told."""
    document = document_on(picture)
    (traced,) = gradmesh.trace_in(document, ["photo"], handles=60)
    saved = gradmesh.loads(document.to_bytes(), folders=[tmp_path])
    here, there = (as_simple_as(each, traced.id, handles=30) for each in (document, saved))
    assert here.error == there.error > 0.8 * traced.errors.flip
    # Against the mesh itself it would be less than what the trace had left out.
    (tmp_path / picture.name).rename(tmp_path / "away.png")
    without = as_simple_as(gradmesh.loads(document.to_bytes(), folders=[tmp_path]), traced.id, handles=29)
    assert without.error < here.error


@pytest.mark.full
def test_an_amount_is_beyond_what_the_trace_left_out(picture):
    document = document_on(picture)
    (traced,) = gradmesh.trace_in(document, ["photo"], handles=150, epsilon=0)
    results = [as_simple_as(document, traced.id, amount=amount, preview=True) for amount in ("gentle", "strong")]
    assert results[1].handles_after < results[0].handles_after < traced.handles
    for result, more in zip(results, (0.005, 0.02)):
        assert traced.errors.flip - 0.01 < result.error < traced.errors.flip + more + 0.005


@pytest.mark.parametrize(
    "change",
    (
        lambda text: text.replace('<image id="photo"', '<image id="other"'),
        lambda text: text.replace('<circle id="spot"', '<circle id="spot" transform="translate(3)"'),
        lambda text: text.replace('<image id="photo"', '<image id="photo" x="2"'),
        lambda text: re.sub(r"(stop-color(?:=.|:))#[0-9a-f]{6}", r"\1#102030", text, count=1),
    ),
)
@pytest.mark.full(all_but=1)
def test_what_was_changed_since_is_its_own_original(picture, tmp_path, change):
    document = document_on(picture)
    (traced,) = gradmesh.trace_in(document, ["spot"], handles=40)
    text = document.to_bytes().decode()
    changed = change(text)
    assert changed != text
    errors = [
        as_simple_as(gradmesh.loads(each, folders=[tmp_path]), "spot", handles=36).error for each in (text, changed)
    ]
    assert errors[1] < errors[0]


def test_errors_are_python_s_own(picture, tmp_path):
    amounts = ({"amount": "some"}, {"amount": "strong", "epsilon": 0.1})
    for wrong in ({"handles": 3}, {"epsilon": -1}, {"detail": 0}, {"resolution": 1}, *amounts):
        with pytest.raises(ValueError):
            gradmesh.trace(picture, **wrong)
    with pytest.raises(gradmesh.InputError, match="none.png"):
        gradmesh.trace(tmp_path / "none.png")
