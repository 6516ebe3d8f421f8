"""Published documents: what becomes of samples and simplified meshes, and what is refused."""

import base64
import math
import os
import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest

from bad_documents import RAGGED
from built import SAMPLES, gradmesh as run
from hemesh_files import grid
from lattices import DOCUMENT, FILLED, MANY, SHAPE, document
from published_copy import Copy, area, pixels
from sample_meshes import OBJECTS, PAINTED

import gradmesh
import svg_meshes
from pictures import fit_frame
from svg_meshes import GRADMESH, HREF, LABEL, SVG, all_but

TRANSLUCENT = ("opacity", "smooth")  # samples


# --- the samples ---


@pytest.fixture(scope="module", params=PAINTED)
def sample(request):
    """The name of a sample, its document, and the published copy."""
    text = (SAMPLES / f"{request.param}.svg").read_text()
    return request.param, ET.fromstring(text), Copy(text)


@pytest.mark.full(all_but=1)
def test_everything_but_the_painted_objects_stays_as_it_was(sample):
    name, before, after = sample
    gone = {e for mesh in before.iter(SVG + "meshgradient") for e in mesh.iter()}
    stay = {e.get("id") for e in before.iter() if e.get("id") and e not in gone}
    assert gone and len(stay) > 3 and stay <= set(after.by_id)
    known = {e.get("id") for e in before.iter()}

    def is_of_a_mesh(parent, child):
        return child.tag == SVG + "meshgradient" or parent.tag == SVG + "defs" and child.get("id") not in known

    expected, found = (all_but(root, is_of_a_mesh, PAINTED[name]) for root in (before, after.root))
    assert found == expected
    # Something else is there, and the objects themselves.
    assert expected.count(" id=") > 3 and expected.count("place") >= len(PAINTED[name])


@pytest.mark.full(all_but=1)
def test_what_is_told_is_what_is_there(sample):
    name, _, after = sample
    assert {told.id for told in after.told} == set(PAINTED[name])
    for told in after.told:
        assert (told.shown_as, told.refused) == ("picture", None)
        (image,) = after.by_id[told.id].iter(SVG + "image")
        height, width, channels = pixels(image).shape
        assert (told.width, told.height, channels) == (width, height, 4 if name in TRANSLUCENT else 3)
        assert told.bytes == len(base64.b64decode(image.get(HREF).partition(",")[2]))


@pytest.mark.module_only
@pytest.mark.parametrize("name, painted", [pair for pair in OBJECTS if pair[0] not in TRANSLUCENT])
@pytest.mark.full(all_but=1)
def test_a_picture_shows_what_the_mesh_shows_there(name, painted):
    """Each pixel of gradmesh's own picture is found in the published one, of about as many pixels."""
    file = SAMPLES / f"{name}.svg"
    source = svg_meshes.Document(file)
    place = source.to_document(source.by_id[painted])
    net = source.net(source.by_id[painted])
    frame = fit_frame([svg_meshes.apply(place, net)], 700)
    expected = gradmesh.render(gradmesh.load(file), painted, 700, like_inkscape=True).astype(int)
    assert expected.shape[:2] == (frame.height, frame.width)
    (image,) = Copy(file.read_text(), scale=2).by_id[painted].iter(SVG + "image")
    found, (x, y, width, height) = pixels(image), area(image)

    scale, _, _, _, left, top = frame.matrix
    page = (np.arange(frame.width) + 0.5 - left) / scale
    page = page + 1j * (np.arange(frame.height)[:, None] + 0.5 - top) / scale
    a, b, c, d, e, f = place
    inverse = np.linalg.inv([[a, c, e], [b, d, f], [0, 0, 1]])
    user = svg_meshes.apply((*inverse[:2, :2].T.ravel(), *inverse[:2, 2]), page)
    column = np.floor((user.real - x) / width * found.shape[1]).astype(int)
    line = np.floor((user.imag - y) / height * found.shape[0]).astype(int)
    inside = (column >= 0) & (line >= 0) & (column < found.shape[1]) & (line < found.shape[0])
    painted_there = inside & (expected < 255).any(axis=2)
    assert painted_there.mean() > 0.2
    levels = np.abs(found[line[painted_there], column[painted_there]] - expected[painted_there]).max(axis=1)
    assert np.median(levels) <= 2 and (levels > 16).mean() <= 0.02


# --- simplified meshes ---

SMALL = {"resolution": 200, "epsilon": 0.02}


@pytest.fixture(scope="module")
def simplified():
    """The fruit as a group of blocks, with the hidden original beside it."""
    document = gradmesh.load(SAMPLES / "fruit.svg")
    gradmesh.simplify(document, method="best", keep_original=True, **SMALL)
    assert document.meshes[0].simplified
    return document.to_bytes().decode()


def test_blocks_are_one_picture_which_is_that_of_the_mesh(simplified):
    before = ET.fromstring(simplified)
    blocks = {e.get("id") for e in before.iter() if e.get(GRADMESH + "face")}
    assert len(blocks) > 1 and [e for e in before.iter() if e.get(GRADMESH + "kept-for")]
    after = Copy(simplified)
    assert (after.only.id, after.only.shown_as) == ("pear", "picture")
    pear = after.by_id["pear"]
    assert [e.tag for e in pear] == [SVG + "image"] and list(pear) == after.images
    assert pear.get(LABEL) is None and b"Gradient mesh:" not in after.bytes
    assert not {*blocks, "pear-original"} & set(after.by_id)
    assert {"layer1", "background", "shadow", "stem", "leaf", "title1"} <= set(after.by_id)

    images = Copy((SAMPLES / "fruit.svg").read_text()).image, after.image
    assert area(images[0]) == area(images[1])
    assert 0 < np.abs(pixels(images[0]) - pixels(images[1])).mean() < 8


def test_a_persons_own_label_stays(simplified):
    label = re.search(r'inkscape:label="(Gradient mesh: [^"]*)"', simplified)[0]
    assert simplified.count(label) == 1
    after = Copy(simplified.replace(label, 'inkscape:label="My pear"'))
    assert after.by_id["pear"].get(LABEL) == "My pear"


def test_of_a_mesh_that_stays_one_gradient_goes_what_it_remembers():
    document = gradmesh.load(SAMPLES / "fruit.svg")
    gradmesh.simplify(document, method="plain", keep_original=True, **SMALL)
    assert not document.meshes[0].simplified and b"gradmesh:" in document.to_bytes()
    assert Copy(document.to_bytes().decode()).image is not None


@pytest.mark.module_only
@pytest.mark.parametrize("name", ["opacity", "stroke", "two", "transformed"])
@pytest.mark.full(all_but=1)
def test_blocks_of_other_samples(name):
    document = gradmesh.load(SAMPLES / f"{name}.svg")
    gradmesh.simplify(document, method="best", **SMALL)
    assert all(mesh.simplified for mesh in document.meshes)
    before = ET.fromstring(document.to_bytes())
    after = Copy(document.to_bytes().decode())
    assert {told.id for told in after.told} == set(PAINTED[name])
    for painted in PAINTED[name]:
        assert len(list(after.by_id[painted].iter(SVG + "image"))) == 1
        assert not list(after.by_id[painted].iter(SVG + "path"))
    # What masked each block's opacity is in the picture.
    masks = [len(list(root.iter(SVG + "mask"))) for root in (before, after.root)]
    assert masks[1] == masks[0] - (name == "opacity")


def test_a_converted_mesh():
    converted = gradmesh.convert(gradmesh.loads(grid(3, 3), "grid.hemesh"), "svg").document
    assert converted.meshes[0].simplified
    after = Copy(converted.to_bytes().decode())
    assert after.only.shown_as == "picture" and len(after.images) == 1


# --- refusals ---

BAD = '<rect id="bad" x="12" y="12" width="36" height="16" fill="url(#n)"/>'


def test_a_mesh_that_cannot_be_read_stays_beside_others():
    text = document(MANY, FILLED + BAD, RAGGED)
    after = Copy(text, left=True)
    good, bad = sorted(after.told, key=lambda told: told.id == "bad")
    assert (good.id, good.shown_as, good.refused) == ("box", "picture", None)
    assert (bad.id, bad.shown_as) == ("bad", "nothing")
    assert isinstance(bad.refused, gradmesh.InputError) and 'meshgradient "n"' in str(bad.refused)
    before = {e.get("id"): e for e in ET.fromstring(text).iter()}
    for name in ("bad", "n"):
        assert ET.tostring(after.by_id[name]).strip() == ET.tostring(before[name]).strip()
    assert "m" not in after.by_id


@pytest.mark.parametrize(
    "text, words",
    [
        (DOCUMENT.format(defs=RAGGED, body=BAD), ['meshgradient "n"']),
        (DOCUMENT.format(defs="", body=SHAPE.format('fill="red"')), ["no object"]),
        (grid(2, 2), ["grid.hemesh", "only SVG documents", "gradmesh convert"]),
        *((document(MANY), scale) for scale in (0, -1, 17, 16.01, math.nan, math.inf)),
    ],
)
def test_what_is_refused_stays_as_it_was(text, words):
    document = gradmesh.loads(text, "grid.hemesh" if text.startswith("HEMESH") else "document")
    before, is_a_scale = document.to_bytes(), not isinstance(words, list)
    with pytest.raises(ValueError if is_a_scale else gradmesh.InputError) as raised:
        gradmesh.publish(document, **{"scale": words} if is_a_scale else {})
    sentence = str(raised.value)
    assert all(word in sentence for word in (["scale"] if is_a_scale else words)), sentence
    assert sentence.endswith(".") and "\n" not in sentence
    assert document.to_bytes() == before


# --- the same again ---


@pytest.mark.module_only
@pytest.mark.parametrize("name", ["fruit", "two"])
@pytest.mark.full(all_but=1)
def test_the_same_bytes_in_every_run_and_on_any_number_of_cores(tmp_path, name):
    source, file = SAMPLES / f"{name}.svg", tmp_path / "copy.svg"
    expected = Copy(source.read_text()).bytes
    assert Copy(source.read_text()).bytes == expected

    def on_one_core():
        os.sched_setaffinity(0, [min(os.sched_getaffinity(0))])

    assert run("publish", source, "-o", file, preexec_fn=on_one_core).returncode == 0
    assert file.read_bytes() == expected


def test_a_published_document_is_saved_and_read_again(tmp_path):
    document = gradmesh.load(SAMPLES / "two.svg")
    gradmesh.publish(document)
    for name in ("copy.svg", "copy.svgz"):
        gradmesh.save(document, tmp_path / name)
        assert gradmesh.load(tmp_path / name).to_bytes() == document.to_bytes()
    with pytest.raises(gradmesh.InputError, match="no object"):
        gradmesh.publish(document)
