"""Reads mesh gradients as Inkscape does, on its own: what the core reads is checked against it.

Points are complex numbers x + 1j * y; an affine map is (a, b, c, d, e, f) as in SVG's matrix().
"""

import copy
import re
import xml.etree.ElementTree as ET
from math import cos, radians, sin, tan

import numpy as np

SVG = "{http://www.w3.org/2000/svg}"
HREF = "{http://www.w3.org/1999/xlink}href"
GRADMESH = "{urn:gradmesh}"
LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
IDENTITY = (1, 0, 0, 1, 0, 0)
# Which corners of a patch's 4 x 4 net begin its sides, and the steps along them.
SIDES = (((0, 0), (0, 1)), ((0, 3), (1, 0)), ((3, 3), (0, -1)), ((3, 0), (-1, 0)))


def numbers(text):
    return [float(found) for found in NUMBER.findall(text)]


def declared(element):
    """What the style of an element declares."""
    parts = [part.split(":", 1) for part in element.get("style", "").split(";") if part.strip()]
    return {name.strip(): value.strip() for name, value in parts}


def all_but(root, is_gone, painted=()):
    """A document as a text that is the same for equal documents, without the elements of which
    `is_gone(parent, child)` is true, and with empty places for those with ids in `painted`."""
    root = copy.deepcopy(root)
    for parent in list(root.iter()):
        for child in list(parent):
            if is_gone(parent, child):
                parent.remove(child)
            elif child.get("id") in painted:
                place = ET.Element("place", id=child.get("id"))
                place.tail = child.tail
                parent[list(parent).index(child)] = place
    return ET.canonicalize(ET.tostring(root), strip_text=True, rewrite_prefixes=True)


def apply(matrix, points):
    """The images of complex points, one or an array."""
    a, b, c, d, e, f = matrix
    x, y = np.real(points), np.imag(points)
    return a * x + c * y + e + 1j * (b * x + d * y + f)


def compose(outer, inner):
    a, b, c, d, e, f = outer
    p, q, r, s, t, u = inner
    linear = (a * p + c * q, b * p + d * q, a * r + c * s, b * r + d * s)
    return (*linear, a * t + c * u + e, b * t + d * u + f)


def parse_transform(text):
    result = IDENTITY
    for name, inside in re.findall(r"(\w+)\s*\(([^)]*)\)", text or ""):
        v = numbers(inside)
        if name == "matrix":
            step = tuple(v)
        elif name == "translate":
            step = (1, 0, 0, 1, v[0], v[1] if len(v) > 1 else 0)
        elif name == "scale":
            step = (v[0], 0, 0, v[-1], 0, 0)
        elif name == "rotate" and len(v) == 1:
            angle = radians(v[0])
            step = (cos(angle), sin(angle), -sin(angle), cos(angle), 0, 0)
        elif name == "skewX":
            step = (1, 0, tan(radians(v[0])), 1, 0, 0)
        else:
            raise ValueError(f"no reader for the transform {name}({inside})")
        result = compose(result, step)
    return result


class Document:
    """An SVG file with its objects by id and the transform of each to the document."""

    def __init__(self, path):
        self.root = ET.parse(path).getroot()
        self.by_id = {e.get("id"): e for e in self.root.iter() if e.get("id")}
        self._parent = {child: parent for parent in self.root.iter() for child in parent}

    def to_document(self, element):
        matrix = IDENTITY
        while element is not None:
            matrix = compose(parse_transform(element.get("transform")), matrix)
            element = self._parent.get(element)
        return matrix

    def paint(self, element):
        """The mesh gradient that fills the element, or else is its stroke."""
        style = declared(element)
        for role in ("fill", "stroke"):
            found = re.match(r"url\(#([^)]+)\)", style.get(role, element.get(role, "")))
            if found and self.by_id[found[1]].tag == SVG + "meshgradient":
                return self.by_id[found[1]]
        raise ValueError(f"no mesh paints {element.get('id')}")

    def units(self, element):
        """From the gradient's own space to the element's user space."""
        gradient = self.paint(element)
        own = parse_transform(gradient.get("gradientTransform"))
        if gradient.get("gradientUnits") == "userSpaceOnUse":
            return own
        assert element.tag == SVG + "ellipse", "the box of an ellipse only"
        cx, cy, rx, ry = (float(element.get(name)) for name in ("cx", "cy", "rx", "ry"))
        return compose((2 * rx, 0, 0, 2 * ry, cx - rx, cy - ry), own)

    def net(self, element):
        """The Bezier points of the element's mesh in the element's user space, an array of
        3 rows + 1 by 3 columns + 1."""
        gradient = rows = self.paint(element)
        while rows.get(HREF):
            rows = self.by_id[rows.get(HREF)[1:]]
        # The start is the gradient's own: Inkscape takes only the rows from another.
        start = complex(float(gradient.get("x", 0)), float(gradient.get("y", 0)))
        return apply(self.units(element), read_net(rows, start))

    def opacity_mask(self, block):
        """The id of the mask that holds the opacities of a block's group, if there is one."""
        found = re.match(r"url\(#([^)]+)\)", self._parent[block].get("mask", ""))
        return found[1] if found and self.by_id[found[1]].get(GRADMESH + "opacity") else None

    def blocks(self):
        """The nets of all blocks in the document, by the id of their path, in the document."""
        paths = [
            e
            for e in self.root.iter(SVG + "path")
            if e.get(GRADMESH + "face") and self._parent[e].tag != SVG + "mask"
        ]
        return {p.get("id"): apply(self.to_document(p), self.net(p)) for p in paths}


def read_net(gradient, start):
    rows = [list(row.iter(SVG + "meshpatch")) for row in gradient.iter(SVG + "meshrow")]
    net = np.full((3 * len(rows) + 1, 3 * len(rows[0]) + 1), np.nan, complex)
    net[0, 0] = start
    for i, row in enumerate(rows):
        for j, patch in enumerate(row):
            _read_patch(patch, net[3 * i : 3 * i + 4, 3 * j : 3 * j + 4], i, j)
    assert not np.isnan(net).any()
    return net


def _read_patch(patch, net, row, column):
    given = [side for side in range(4) if (side or row == 0) and (side < 3 or column == 0)]
    for side, stop in zip(given, patch.iter(SVG + "stop")):
        (i, j), (di, dj) = SIDES[side]
        letter, points = stop.get("path").strip()[0], numbers(stop.get("path"))
        points = np.array(points[::2]) + 1j * np.array(points[1::2])
        if letter.islower():
            points = points + net[i, j]
        closing = side == (3 if column == 0 else 2)
        end = net[i + 3 * di, j + 3 * dj] if closing else points[-1]
        net[i + 3 * di, j + 3 * dj] = end
        for k in (1, 2):
            on_line = net[i, j] + (end - net[i, j]) * k / 3
            net[i + k * di, j + k * dj] = on_line if letter in "lL" else points[k - 1]
    corners = ((0, 0), (0, 3), (3, 3), (3, 0))
    offsets = numbers(patch.get("tensor", ""))
    for k, (i, j) in enumerate(corners):
        inner = (1 if i == 0 else 2, 1 if j == 0 else 2)
        if offsets:
            net[inner] = net[i, j] + complex(*offsets[2 * k : 2 * k + 2])
        else:
            net[inner] = _coons(net if j == 0 else net[:, ::-1], i == 3)


def _coons(p, upside_down):
    """The interior point next to p[0][0] that makes the patch a Coons patch."""
    p = p[::-1] if upside_down else p
    near = -4 * p[0, 0] + 6 * (p[0, 1] + p[1, 0]) - 2 * (p[0, 3] + p[3, 0])
    return (near + 3 * (p[3, 1] + p[1, 3]) - p[3, 3]) / 9


def _bernstein(t):
    s = 1 - t
    return np.stack([s**3, 3 * s * s * t, 3 * s * t * t, t**3])


def surface(net, steps):
    """Points of every patch, at the same (steps + 1)^2 parameters, as one flat array."""
    basis = _bernstein(np.linspace(0, 1, steps + 1))
    found = []
    for i in range(0, net.shape[0] - 1, 3):
        for j in range(0, net.shape[1] - 1, 3):
            found.append((basis.T @ net[i : i + 4, j : j + 4] @ basis).ravel())
    return np.concatenate(found)
