"""A simplified object that was copied into another document is what it was, or one sentence says why not."""

import copy
import re
import xml.etree.ElementTree as ET

import pytest

pytest.importorskip("numpy")

from built import SAMPLES
from program import meshes
from svg_meshes import GRADMESH, SVG, all_but

import gradmesh

WHOLE = {"resolution": 200, "visible_only": False}
#: The sample and its object, by the kind of what becomes of it: one gradient, blocks, blocks whose
#: opacities are in a mask, blocks of a stroke.
KINDS = {
    "one mesh": ("fruit", "pear", "simplest"),
    "blocks": ("fruit", "pear", "best"),
    "translucent blocks": ("opacity", "bubble", "best"),
    "blocks of a stroke": ("stroke", "loop", "best"),
}
REFERENCE = re.compile(r"url\(#([^)]+)\)")
INKSCAPE = "http://www.inkscape.org/namespaces/inkscape"

pytestmark = pytest.mark.module_only


@pytest.fixture(scope="module", params=KINDS)
def kind(request):
    return request.param


@pytest.fixture(scope="module")
def simplified(kind):
    """The bytes of a sample, the same simplified, and the id of its object."""
    sample, name, method = KINDS[kind]
    document = gradmesh.load(SAMPLES / f"{sample}.svg")
    before = document.to_bytes()
    gradmesh.simplify(document, method=method, epsilon=0.02, **WHOLE)
    return before, document.to_bytes(), name


@pytest.fixture(scope="module")
def other():
    """A document with two meshes of its own."""
    return (SAMPLES / "two.svg").read_bytes()


def first_of_each_id(root):
    found = {}
    for element in root.iter():
        found.setdefault(element.get("id"), element)
    return found


def needed(element, by_id):
    """The elements that `element` refers to, and what these refer to."""
    found = []
    for part in element.iter():
        for value in part.attrib.values():
            for name in REFERENCE.findall(value):
                if name in by_id and by_id[name] not in found:
                    found.append(by_id[name])
                    found += [e for e in needed(by_id[name], by_id) if e not in found]
    return found


def rename(elements, ending):
    """As Inkscape renames what it pastes where its ids are taken."""
    names = {part.get("id") for element in elements for part in element.iter()} - {None}
    for part in (part for element in elements for part in element.iter()):
        for key, value in part.attrib.items():
            if key == "id":
                part.set(key, value + ending)
            else:
                new = lambda m: f"url(#{m[1]}{ending})" if m[1] in names else m[0]  # noqa: E731
                part.set(key, REFERENCE.sub(new, value))


def paste(source, name, into, ending="", transform="", comes_along=lambda element: True):
    """The document `into` with the object `name` of `source`, in a group of its own at the end."""
    prefixes = {"": SVG[1:-1], "inkscape": INKSCAPE, "mesh": GRADMESH[1:-1]}
    for prefix, namespace in prefixes.items():
        ET.register_namespace(prefix, namespace)
    source, target = ET.fromstring(source), ET.fromstring(into)
    by_id = first_of_each_id(source)
    along = [element for element in needed(by_id[name], by_id) if comes_along(element)]
    pasted = [copy.deepcopy(element) for element in (by_id[name], *along)]
    if ending:
        rename(pasted, ending)
    target.find(SVG + "defs").extend(pasted[1:])
    group = ET.SubElement(target, SVG + "g", id="pasted", transform=transform)
    group.append(pasted[0])
    return ET.tostring(target)


def without(data, name):
    """All of a document but the object `name`, which the program may write anew, and definitions."""
    def is_gone(_, child):
        return child.get("id") == name or child.tag == SVG + "defs"

    return all_but(ET.fromstring(data), is_gone)


def error_now(data, name):
    """How far the mesh is from what it remembers."""
    (result,) = gradmesh.simplify(gradmesh.loads(data), name, epsilon=0, preview=True, **WHOLE)
    return result.error


def remembers(data, tmp_path):
    path = tmp_path / "document.svg"
    path.write_bytes(data)
    return [mesh.get("remembers") for mesh in meshes(path)]


def expect_left_alone_in_a_sentence(data, name, words):
    for work in (gradmesh.simplify, gradmesh.update):
        document = gradmesh.loads(data)
        with pytest.raises(gradmesh.InputError, match=words) as refused:
            work(document, name)
        said = str(refused.value)
        assert "\n" not in said and said.endswith(".") and f'"{name}"' in said
        assert document.to_bytes() == data


@pytest.mark.parametrize("transform", ["", "translate(50 -30)", "rotate(20) scale(1.5)"])
@pytest.mark.full(all_but=1)
def test_it_is_remembered_in_the_other_document(simplified, other, tmp_path, transform):
    _, source, name = simplified
    pasted = f"{name}-2"
    data = paste(source, name, other, "-2", transform)
    assert remembers(data, tmp_path) == [False, False, True]
    # The pixels are others where it is turned, not the mesh.
    near = 1e-9 if not transform else 0.01
    assert error_now(data, pasted) == pytest.approx(error_now(source, name), abs=near)

    document = gradmesh.loads(data)
    (result,) = gradmesh.simplify(document, pasted, epsilon=0.04, **WHOLE)
    assert result.changed and 0.01 < result.error <= 0.04
    after = document.to_bytes()
    assert remembers(after, tmp_path) == [False, False, True]
    assert without(after, pasted) == without(data, pasted)
    others = [mesh for mesh in gradmesh.loads(data).meshes if mesh.id != pasted]
    assert [mesh for mesh in document.meshes if mesh.id != pasted] == others


@pytest.mark.full(all_but=1)
def test_edited_there_it_is_updated_there(kind, simplified, other):
    _, source, name = simplified
    data = paste(source, name, other, "-2", "scale(2)")
    document = gradmesh.loads(data)
    if kind == "one mesh":
        with pytest.raises(gradmesh.InputError, match="needs no update"):
            gradmesh.update(document, f"{name}-2")
        return
    (result,) = gradmesh.update(document, f"{name}-2")
    assert not result.changed and document.to_bytes() == data
    # A block is moved as a whole.
    root = ET.fromstring(data)
    group = root.find(f".//*[@id='{name}-2']")
    block = next(path for path in group if path.get(GRADMESH + "face") == "0")
    block.set("transform", "translate(3 2)")
    document = gradmesh.loads(ET.tostring(root))
    (result,) = gradmesh.update(document, f"{name}-2")
    assert result.changed
    (result,) = gradmesh.update(document, f"{name}-2")
    assert not result.changed
    assert without(document.to_bytes(), f"{name}-2") == without(data, f"{name}-2")


@pytest.mark.parametrize("into_itself", [True, False])
@pytest.mark.full(all_but=1)
def test_where_ids_are_there_twice_the_other_object_stays(simplified, tmp_path, into_itself):
    before, source, name = simplified
    target = source if into_itself else before
    data = paste(source, name, target)
    assert remembers(data, tmp_path) == [into_itself, True]
    assert error_now(data, "pasted") == error_now(source, name)
    document = gradmesh.loads(data)
    (result,) = gradmesh.simplify(document, "pasted", epsilon=0.04, **WHOLE)
    assert result.changed and result.id == name

    def as_painted(data):
        """The first object of the name, and all it refers to."""
        by_id = first_of_each_id(ET.fromstring(data))
        parts = [by_id[name], *needed(by_id[name], by_id)]
        return [ET.canonicalize(ET.tostring(part), strip_text=True) for part in parts]

    assert as_painted(document.to_bytes()) == as_painted(data)
    assert document.meshes[0] == gradmesh.loads(data).meshes[0]
    assert remembers(document.to_bytes(), tmp_path) == [into_itself, True]


@pytest.mark.full(all_but=1)
def test_where_its_meshes_did_not_come_along_a_sentence_says_so(kind, simplified, other):
    _, source, name = simplified
    gone = []

    def all_but_one_mesh(element):
        if element.tag == SVG + "meshgradient":
            gone.append(element)
        return element.tag != SVG + "meshgradient" or len(gone) > 1

    words = "not painted by a mesh gradient" if kind == "one mesh" else "has lost its mesh gradient"
    for comes_along in (lambda element: False, all_but_one_mesh):
        data = paste(source, name, other, "-2", comes_along=comes_along)
        expect_left_alone_in_a_sentence(data, f"{name}-2", words)
        # The meshes of the document can be simplified all the same.
        document = gradmesh.loads(data)
        (result,) = gradmesh.simplify(document, "stalk", **WHOLE)
        assert result.changed
        assert without(document.to_bytes(), "stalk") == without(data, "stalk")


@pytest.mark.full(all_but=1)
def test_without_its_mask_and_clip_it_is_what_is_seen_then(kind, simplified, other, tmp_path):
    """A mask that held the opacities is missed: nobody knows then what the mesh was."""
    _, source, name = simplified
    only_meshes = lambda element: element.tag == SVG + "meshgradient"  # noqa: E731
    data = paste(source, name, other, "-2", comes_along=only_meshes)
    is_known = kind != "translucent blocks"
    assert remembers(data, tmp_path)[-1] == is_known
    assert (error_now(data, f"{name}-2") > 0) == is_known
