"""By default no mesh has more handles than before, nor a document of others more bytes."""

import random
from typing import NamedTuple

import pytest

pytest.importorskip("numpy")

from built import ROOT
from random_meshes import Kind

import gradmesh

REAL = sorted((ROOT.parent / "shared" / "real").glob("*.svg"))
KINDS = {
    "curved": Kind(most=8),
    "of lines": Kind(most=8, straight=1.0),
    "of curves and lines": Kind(noise=0.1, most=8, straight=0.5),
    "hardly curved": Kind(noise=0.01, most=8, straight=0.5),
    "tensor": Kind(inner=0.15, most=6, straight=0.2),
    "translucent": Kind(opacity=True, most=8, straight=0.3),
    "translucent tensor": Kind(opacity=True, inner=0.1, most=5),
    "folded": Kind(noise=0.6, most=6, straight=0.2),
    "folded tensor": Kind(noise=0.6, inner=0.8, most=5),
    "smooth": Kind(smooth=True, most=6, straight=0.3),
}
SEEDS = range(6)
OPTIONS = [
    {"epsilon": 0.01, "max_local_error": 0.1},
    {"epsilon": 0.02},
    {"epsilon": 0.002, "visible_only": False},
    {"epsilon": 0.1},
]
RESOLUTION = 100


class Painted(NamedTuple):
    gradient: str
    element: str


def painted(kind, chance, name):
    """An object that a random mesh paints, or outlines, under the transforms of all around it."""
    matrix = lambda: "matrix({} {} {} {} {} {})".format(  # noqa: E731
        *(round(number, 4) for number in Kind(transformed=True).matrix(chance)), 7, -3
    )
    own = f'gradientTransform="{matrix()}"' if chance.random() < 0.3 else ""
    gradient = kind.gradient(chance, f"{name}-mesh", own)
    transform = f'transform="{matrix()}"' if chance.random() < 0.3 else ""
    paint = f'fill="url(#{name}-mesh)"'
    if chance.random() < 0.2:
        paint = f'fill="none" stroke="url(#{name}-mesh)" stroke-width="60"'
    shape = chance.choice(
        (
            '<rect id="{}" x="-300" y="-300" width="900" height="900" {} {}/>',
            '<ellipse id="{}" cx="60" cy="60" rx="90" ry="70" {} {}/>',
        )
    )
    element = shape.format(name, paint, transform)
    if chance.random() < 0.3:
        element = f'<g transform="{matrix()}">{element}</g>'
    return Painted(gradient, element)


def document(kind, seed):
    """One to three objects, each painted by a random mesh of its own."""
    chance = random.Random(f"{kind} {seed}")
    count = chance.choice((1, 2, 2, 3))
    parts = [painted(KINDS[kind], chance, f"object{i}") for i in range(count)]
    defs = "".join(part.gradient for part in parts)
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" width="400" height="400">'
        f"<defs>{defs}</defs>{''.join(part.element for part in parts)}</svg>"
    ).encode()


def meshes_in(data):
    document = gradmesh.loads(data)
    return document.meshes if document.ids else []


def expect_not_more(before, after, results):
    """What is told, and what is found in the documents, object by object."""
    found, left = ({mesh.id: mesh for mesh in meshes_in(data)} for data in (before, after))
    assert found.keys() == left.keys() == {result.id for result in results}
    for result in results:
        if result.refused:
            continue
        told = result.handles_before, result.handles_after
        assert told == (found[result.id].handles, left[result.id].handles), result
        assert told[1] <= told[0] and left[result.id].objects == result.objects, result
        if not result.changed:
            assert told[0] == told[1] and result.error == 0, result


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.full(all_but=1)
def test_random_meshes(kind, seed):
    before = document(kind, seed)
    changed = gradmesh.loads(before)
    options = OPTIONS[seed % len(OPTIONS)]
    results = gradmesh.simplify(changed, resolution=RESOLUTION, **options)
    expect_not_more(before, changed.to_bytes(), results)


def test_most_random_meshes_get_simpler():
    """So that the others hold something."""
    changed = []
    for kind in ("curved", "hardly curved", "translucent"):
        document_ = gradmesh.loads(document(kind, 1))
        results = gradmesh.simplify(document_, resolution=RESOLUTION, epsilon=0.1, preview=True)
        changed += [result.changed for result in results]
    assert all(changed)


@pytest.mark.skipif(not REAL, reason="the documents are not in ../shared/real")
@pytest.mark.parametrize("name", [path.stem for path in REAL])
@pytest.mark.full(all_but=1)
def test_documents_of_others(name):
    (path,) = [path for path in REAL if path.stem == name]
    before = path.read_bytes()
    if all(mesh.refused for mesh in meshes_in(before)):
        pytest.skip("it has no mesh that can be read")
    for options in OPTIONS[:2]:
        document = gradmesh.loads(before)
        results = gradmesh.simplify(document, resolution=200, **options)
        expect_not_more(before, document.to_bytes(), results)
        assert len(document.to_bytes()) <= len(before)
