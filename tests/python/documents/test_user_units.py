"""What is handed to a canvas has meshes of shapes that the canvas would lose in user units, and is the same else."""

import re
import xml.etree.ElementTree as ET

import pytest

pytest.importorskip("numpy")
gradmesh = pytest.importorskip("gradmesh", reason="the compiled package is not there")

from shape_documents import NEVER_IN_A_BOX, SHAPES, mesh_gradient, shapes_document

PAINT = re.compile(r"(?:fill|stroke):url\(#([^)]*)\)")
#: Inkscape reads the outlines of these as they stand.
STAYS = {"path", "polygon", "polyline", "stroked-path", "stroked-polyline"}


def simplified(text, ids=()):
    document = gradmesh.loads(text)
    gradmesh.simplify(document, ids, amount="gentle", method="plain", resolution=100)
    return document


def elements(document):
    return {element.get("id"): element for element in ET.fromstring(document).iter()}


def gradient_of(found, name):
    return found[PAINT.search(found[name].get("style"))[1]]


def same_meshes(document, other):
    """The pictures of all meshes, each of which is the same in both documents."""
    for mesh in gradmesh.loads(document).meshes:
        before, after = (gradmesh.render(gradmesh.loads(text), mesh.id, resolution=100) for text in (document, other))
        if (abs(before.astype(int) - after) > 1).any():
            return False
    return True


def test_only_shapes_that_a_canvas_loses_get_user_units():
    text, names = shapes_document("box")
    document = simplified(text)
    plain, handed = document.to_bytes(), document.to_bytes(over=text.encode())
    assert b"userSpaceOnUse" not in plain and document.to_bytes() == plain
    found = elements(handed)
    for name in (name.replace(" ", "-") for name in names):
        units = gradient_of(found, name).get("gradientUnits")
        assert (units == "objectBoundingBox") == (name in STAYS), name
    assert same_meshes(plain, handed)
    # Nothing is left over, and the mesh is still the one that was written.
    again = gradmesh.loads(handed)
    assert again.ids == document.ids and not gradmesh.info(again).get("unused")
    assert NEVER_IN_A_BOX < SHAPES.keys()


def test_shapes_that_share_a_gradient_get_one_each_where_their_boxes_differ():
    document = simplified(shapes_document("box")[0], ["two-of-one-gradient-cell"])
    found = elements(document.to_bytes(over=shapes_document("box")[0].encode()))
    both = [gradient_of(found, f"two-of-one-gradient{other}") for other in ("", "-other")]
    assert [each.get("gradientTransform") for each in both] == ["matrix(80 0 0 30 10 10)", "matrix(40 0 0 40 30 50)"]


def drawing(transform=""):
    """Two rectangles of one gradient; `transform` is the attribute of the gradient."""
    gradient = mesh_gradient("m", "box").replace("<meshgradient", f"<meshgradient {transform}", 1)
    rect = '<rect id="{}" x="{}" y="10" width="50" height="40" style="fill:url(#m)"/>'
    body = rect.format("a", 10) + rect.format("b", 100)
    return f'<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100"><defs>{gradient}</defs>{body}</svg>'


def test_what_has_not_changed_stays_byte_for_byte():
    text = drawing()
    assert gradmesh.loads(text).to_bytes(over=text.encode()) == text.encode()
    handed = simplified(text, ["a"]).to_bytes(over=text.encode())
    found, before = elements(handed), elements(text)
    assert gradient_of(found, "a").get("gradientTransform") == "matrix(50 0 0 40 10 10)"
    assert ET.tostring(gradient_of(found, "b")) == ET.tostring(before["m"])


def test_the_box_is_composed_with_a_transform():
    text = drawing('gradientTransform="matrix(.5 0 0 1 .25 0)"')
    document = simplified(text, ["a"])
    handed = document.to_bytes(over=text.encode())
    assert gradient_of(elements(handed), "a").get("gradientTransform") == "matrix(25 0 0 40 22.5 10)"
    assert same_meshes(document.to_bytes(), handed)


def test_the_original_is_remembered():
    text = shapes_document("box")[0]
    document = simplified(text, ["rect"])
    handed = gradmesh.loads(document.to_bytes(over=text.encode()))
    remembers = [
        {mesh["id"]: mesh["remembers"] for mesh in gradmesh.info(each)["meshes"]}
        for each in (document, handed)
    ]
    assert remembers[0] == remembers[1] and remembers[0]["rect"]


def test_the_document_that_is_shown_has_to_be_one():
    with pytest.raises(gradmesh.InputError):
        gradmesh.loads(drawing()).to_bytes(over=b"HEMESH")
