"""Edits single blocks of a simplified mesh, as Inkscape's mesh tool does."""

import xml.etree.ElementTree as ET
from collections import Counter

import numpy as np
import pytest

import random_meshes  # noqa: F401, which knows where meshgrid is
import svg_meshes
from meshgrid import Mesh, Notation, meshgradient
from svg_meshes import GRADMESH, SVG

import gradmesh


class Group:
    """The document at `path`, of one simplified mesh, whose blocks can be edited one by one as
    Inkscape's mesh tool does: each has copies of the points that it shares."""

    def __init__(self, path):
        self.path = path
        self.read()

    def read(self):
        self.document = svg_meshes.Document(self.path)
        self.blocks = self.document.blocks()
        (self.node,) = [e for e in self.document.root.iter() if e.get(GRADMESH + "version")]

    def save(self):
        ET.register_namespace("gradmesh", "urn:gradmesh")
        ET.register_namespace("", SVG[1:-1])
        ET.ElementTree(self.document.root).write(self.path)
        self.read()

    def paths(self):
        """The paths of the blocks, in the order of their faces."""
        return sorted(
            (e for e in self.node if e.get(GRADMESH + "face")), key=lambda e: int(e.get(GRADMESH + "face"))
        )

    def in_face_order(self):
        return [path.get("id") for path in self.paths()]

    def gradient(self, block):
        return self.document.paint(self.document.by_id[block])

    def corners(self):
        """How many blocks have each corner."""
        return Counter(p for net in self.blocks.values() for p in np.unique(net[::3, ::3]))

    def shared_corner(self, blocks):
        """A corner of so many blocks that no block has on a side between corners."""
        found = [p for p, count in self.corners().items() if count == blocks]
        assert found
        return max(found, key=lambda p: min(abs(p - q) for q in self.corners() if q != p))

    def owners(self, corner):
        return [name for name, net in self.blocks.items() if corner in net[::3, ::3]]

    def move(self, block, point, by):
        """Moves all that one block has at a point."""
        gradient, moved = self.gradient(block), 0
        start = complex(float(gradient.get("x")), float(gradient.get("y")))
        if start == point:
            gradient.set("x", repr(float((start + by).real)))
            gradient.set("y", repr(float((start + by).imag)))
            moved += 1
        for stop in gradient.iter(SVG + "stop"):
            # A straight side stays one, with its end alone.
            letter, numbers = stop.get("path")[0], svg_meshes.numbers(stop.get("path"))
            points = [complex(x, y) for x, y in zip(numbers[::2], numbers[1::2])]
            moved += points[-1] == point
            points[-1] += by if points[-1] == point else 0
            text = " ".join(f"{float(p.real)!r},{float(p.imag)!r}" for p in points)
            stop.set("path", f"{letter} {text}")
        assert moved
        self.save()

    def cut(self, block, rows=(), columns=()):
        """Cuts a block as the mesh tool does at a double click: pairs of a row, or a column, and a
        parameter, each of the block as those before have left it."""
        gradient = self.gradient(block)
        mesh = read_mesh(gradient)
        for row, t in rows:
            mesh.split_row(row, t)
        for column, t in columns:
            mesh.split_column(column, t)
        notation = Notation(relative=False, digits=7)
        written = ET.fromstring(meshgradient(mesh, "cut", "", notation))
        gradient[:] = [self._in_svg(row) for row in written]
        self.save()

    def _in_svg(self, row):
        for element in row.iter():
            element.tag = SVG + element.tag
        return row

    def remove(self, block):
        path = self.document.by_id[block]
        self.node.remove(path)
        self.save()


@pytest.fixture
def group(simplified, tmp_path):
    """A copy of the document of the module's fixture `simplified`."""
    path = tmp_path / "mesh.svg"
    path.write_bytes(simplified.read_bytes())
    return Group(path)


def update(group):
    """Updates the document of a group, which is read again; the result."""
    document = gradmesh.load(group.path)
    (result,) = gradmesh.update(document)
    gradmesh.save(document, group.path)
    group.read()
    return result


def read_mesh(gradient):
    """A block's mesh, in the gradient's own space."""
    start = complex(float(gradient.get("x")), float(gradient.get("y")))
    mesh = Mesh.__new__(Mesh)
    mesh.points = [list(line) for line in svg_meshes.read_net(gradient, start)]
    rows = [list(row.iter(SVG + "meshpatch")) for row in gradient.iter(SVG + "meshrow")]
    mesh.colours = [[None] * (len(rows[0]) + 1) for _ in range(len(rows) + 1)]
    mesh.tensor = set()
    for i, row in enumerate(rows):
        for j, patch in enumerate(row):
            stops = [_colour(stop) for stop in patch.iter(SVG + "stop")]
            places = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)]
            # Sides that an earlier patch has given are left out, and what begins there with them.
            given = [k for k in range(4) if (k or i == 0) and (k < 3 or j == 0)]
            for k, colour in zip(given, stops):
                if colour:
                    mesh.colours[places[k][0]][places[k][1]] = colour
            if patch.get("tensor"):
                mesh.tensor.add((i, j))
    assert all(colour for line in mesh.colours for colour in line)
    return mesh


def _colour(stop):
    style = svg_meshes.declared(stop)
    text = style.get("stop-color", stop.get("stop-color"))
    alpha = float(style.get("stop-opacity", stop.get("stop-opacity", 1)))
    return (*(int(text[k : k + 2], 16) / 255 for k in (1, 3, 5)), alpha) if text else None
