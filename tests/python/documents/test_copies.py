"""A drawing is full of copies: what lies, is seen and will be written like another is simplified once."""

import copy
import xml.etree.ElementTree as ET

from built import SAMPLES
from svg_meshes import SVG, declared

import gradmesh

OPTIONS = {"resolution": 200, "epsilon": 0.01}
OBJECT, MESH = "leaf", "leaf-mesh"


def with_copies(**copies):
    """The sample `transformed` with copies of its object and mesh, as Inkscape duplicates them: for each
    one a function that changes the object and the mesh of the copy."""
    root = ET.parse(SAMPLES / "transformed.svg").getroot()
    parents = {child: parent for parent in root.iter() for child in parent}
    by_id = {e.get("id"): e for e in root.iter()}
    for name, change in copies.items():
        thing, mesh = copy.deepcopy(by_id[OBJECT]), copy.deepcopy(by_id[MESH])
        thing.set("id", name)
        mesh.set("id", f"{name}-mesh")
        thing.set("style", thing.get("style").replace(f"#{MESH}", f"#{name}-mesh"))
        change(thing, mesh)
        parents[by_id[OBJECT]].append(thing)
        parents[by_id[MESH]].append(mesh)
    return ET.tostring(root)


def as_it_is(thing, mesh):
    pass


def recoloured(thing, mesh):
    next(mesh.iter(SVG + "stop")).set("style", "stop-color:#123456;stop-opacity:1")


def enlarged_mesh(thing, mesh):
    mesh.set("gradientTransform", "matrix(4,0,0,4,-200,-200) scale(1.01)")


def cut(thing, mesh):
    thing.set("d", "M -200,-60 H 0 V 60 H -200 Z")


def mesh_of(document, name):
    """What the mesh that paints an object looks like, as text."""
    by_id = {e.get("id"): e for e in ET.fromstring(document).iter()}
    paint = declared(by_id[name])["fill"].split("#")[1].split(")")[0]
    mesh = by_id[paint]
    return [mesh.get("x"), mesh.get("y")] + [(e.get("path"), e.get("style")) for e in mesh.iter(SVG + "stop")]


def simplified(document, ids=()):
    opened = gradmesh.loads(document, "copies.svg")
    results = {r.id: r for r in gradmesh.simplify(opened, ids, **OPTIONS)}
    return results, opened.to_bytes()


def test_a_copy_becomes_what_the_first_has_become():
    document = with_copies(second=as_it_is, third=as_it_is)
    results, written = simplified(document)
    first = results[OBJECT]
    assert first.changed and first.evaluations > 0
    for name in ("second", "third"):
        copied = results[name]
        assert copied.evaluations == 0
        assert (copied.handles_after, copied.error) == (first.handles_after, first.error)
        assert mesh_of(written, name) == mesh_of(written, OBJECT) != mesh_of(document, OBJECT)
        alone, written_alone = simplified(document, name)
        assert alone[name].evaluations == first.evaluations
        assert mesh_of(written_alone, name) == mesh_of(written, name)


def test_what_differs_is_simplified_by_itself():
    document = with_copies(recoloured=recoloured, enlarged=enlarged_mesh, cut=cut)
    results, written = simplified(document)
    for name in (OBJECT, "recoloured", "enlarged", "cut"):
        assert results[name].evaluations > 0
        alone, written_alone = simplified(document, name)
        assert alone[name].error == results[name].error
        assert mesh_of(written_alone, name) == mesh_of(written, name)
