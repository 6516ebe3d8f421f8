"""Labels that tell of a mesh are brought up to date; those that a person gave stay."""

import re
import xml.etree.ElementTree as ET

import pytest

from built import SAMPLES
from svg_meshes import LABEL

import gradmesh

NAMES = 'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
FEW = {"resolution": 100, "amount": "strong"}
#: As older versions wrote them, without a mark.
STALE = ["Gradient mesh: 2236 of 14108 handles, 80 of 132 patches", "Verlaufsgitter: 9 Anfasser, 3 Felder"]


def fruit(label):
    text = (SAMPLES / "fruit.svg").read_text()
    return text.replace('id="pear"', f'id="pear" {NAMES} inkscape:label="{label}"', 1)


def german(text):
    return text.replace("Gradient mesh", "Verlaufsgitter").replace("handles", "Anfasser").replace("patches", "Felder")


def simplified(text, method, translation=german):
    document = gradmesh.loads(text, "fruit.svg", translation)
    gradmesh.simplify(document, "pear", method=method, **FEW)
    return document.to_bytes().decode()


def label(text):
    (pear,) = [element for element in ET.fromstring(text).iter() if element.get("id") == "pear"]
    return pear.get(LABEL)


def counts(text):
    (mesh,) = [mesh for mesh in gradmesh.loads(text).meshes if mesh.id == "pear"]
    return f"Verlaufsgitter: {mesh.handles} Anfasser, {mesh.patches} Felder"


@pytest.mark.parametrize("stale", STALE)
@pytest.mark.full(all_but=1)
def test_a_label_of_ours_is_brought_up_to_date(stale):
    one = simplified(fruit(stale), "plain")
    assert label(one) == counts(one)
    blocks = simplified(fruit(stale), "gqe")
    assert re.match(r"Verlaufsgitter: \d+ of 660 Anfasser", label(blocks))


def test_what_we_wrote_in_any_language_is_known(tmp_path):
    """The second run knows none but English."""
    one = simplified(fruit(STALE[0]), "plain")
    again = gradmesh.loads(one)
    gradmesh.simplify(again, "pear", method="plain", resolution=100, handles=20)
    (mesh,) = again.meshes
    assert label(again.to_bytes()) == f"Gradient mesh: {mesh.handles} handles, {mesh.patches} patches"


@pytest.mark.parametrize("method", ["plain", "gqe"])
@pytest.mark.full(all_but=1)
def test_a_label_of_a_person_stays(method):
    text = simplified(fruit("my pear"), method)
    assert label(text) == "my pear"
    again = gradmesh.loads(text)
    gradmesh.simplify(again, "pear", method=method, resolution=100, patches=9)
    assert label(again.to_bytes()) == "my pear"


def test_a_label_that_a_person_gave_blocks_stays():
    text = simplified((SAMPLES / "fruit.svg").read_text(), "gqe")
    named = text.replace(f'inkscape:label="{label(text)}"', 'inkscape:label="my pear"')
    assert label(simplified(named, "gqe")) == "my pear"


def test_where_there_is_none_one_mesh_gets_none():
    assert label(simplified((SAMPLES / "fruit.svg").read_text(), "plain")) is None
