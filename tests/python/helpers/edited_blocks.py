"""Edits single blocks of a simplified mesh, as Inkscape's mesh tool does."""

import xml.etree.ElementTree as ET
from collections import Counter

import numpy as np

import svg_meshes
from svg_meshes import GRADMESH, SVG


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
        return [e for e in self.node if e.get(GRADMESH + "face")]

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
            gradient.set("x", repr((start + by).real))
            gradient.set("y", repr((start + by).imag))
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
