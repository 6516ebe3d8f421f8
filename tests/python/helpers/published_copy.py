"""A published document taken apart: its pictures, and all that it draws in one line."""

import base64
import io
import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest

import gradmesh
import svg_meshes
from svg_meshes import HREF, SVG

Image = pytest.importorskip("PIL.Image")

PLACE = ("x", "y", "width", "height")


class Copy:
    """A document after it was published, with what was told of each mesh. Nothing of meshes is left,
    unless something is `left` as it cannot be read; nothing names what is gone, and no id is there twice."""

    def __init__(self, text, left=False, **options):
        document = gradmesh.loads(text)
        self.told = gradmesh.publish(document, **options)
        self.bytes = document.to_bytes()
        self.root = ET.fromstring(self.bytes)
        self.by_id = {e.get("id"): e for e in self.root.iter() if e.get("id")}
        self.images = list(self.root.iter(SVG + "image"))
        self.known = {e.get("id") for e in ET.fromstring(text).iter()}
        assert left or not [e.tag for e in self.root.iter() if "mesh" in str(e.tag)]
        assert b"urn:gradmesh" not in self.bytes
        values = [value for e in self.root.iter() for value in [*e.attrib.values(), e.text or ""]]
        names = {name for value in values for name in re.findall(r"url\(['\"]?#([^)'\"]+)", value)}
        names |= {e.get(HREF)[1:] for e in self.root.iter() if e.get(HREF, "").startswith("#")}
        assert names <= set(self.by_id)
        assert len(self.by_id) == len([e for e in self.root.iter() if e.get("id")])
        for told in self.told:
            assert told.shown_as == "picture" or (told.width, told.height, told.bytes) == (0, 0, 0)

    @property
    def only(self):
        (told,) = self.told
        return told

    @property
    def image(self):
        (image,) = self.images
        return image

    def named(self, element, attribute):
        """The element that url(#...) in an attribute names."""
        return self.by_id[re.fullmatch(r"url\(#(.+)\)", element.get(attribute))[1]]

    @property
    def drawing(self):
        """What is told of the meshes, and all that is drawn, in one line."""
        sizes = {mesh: f" {mesh.width} x {mesh.height}" if mesh.width else "" for mesh in self.told}
        told = ", ".join(f"{mesh.id} {mesh.shown_as}{size}" for mesh, size in sizes.items())
        return f"{told}: " + ", ".join(self._outline(e) for e in self.root if e.get("id") != "defs")

    def _outline(self, element):
        """An element: its tag, its id where that is no new one, the colour of a picture's first pixel,
        its place (of a path the corners of its box), other attributes, with what new ids name, and what
        is in it."""
        name, tag = element.get("id"), element.tag.removeprefix(SVG)
        words = [f"{tag}#{name}" if name and name in self.known else tag]
        if tag == "image":
            words.append("#" + "".join(f"{level:02x}" for level in pixels(element)[0, 0]))
        rest = {key: value for key, value in element.attrib.items() if key not in ("id", "preserveAspectRatio", HREF)}
        if all(side in rest for side in PLACE):
            words += [rest.pop(side) for side in PLACE]
        if "d" in rest:
            numbers = svg_meshes.numbers(rest.pop("d"))
            words += [f"{end(numbers[i::2]):g}" for end in (min, max) for i in (0, 1)]
        for key, value in rest.items():
            found = re.fullmatch(r"url\(#(.+)\)", value)
            if found and found[1] not in self.known:
                (inside,) = self.by_id[found[1]]
                value = f"<{self._outline(inside)}>"
            words.append(f"{key}={value}")
        words += [element.get(HREF)] if tag == "use" else []
        words += [repr(element.text)] if (element.text or "").strip() else []
        inside = ", ".join(map(self._outline, element))
        return " ".join(words) + (f" [{inside}]" if inside else "")


def pixels(image):
    """Those of a picture's file."""
    kind, _, text = image.get(HREF).partition(",")
    assert kind == "data:image/png;base64"
    with Image.open(io.BytesIO(base64.b64decode(text, validate=True))) as picture:
        return np.array(picture, int)


def area(image):
    """Where a picture lies in the user space of its object: x, y, width, height."""
    return [float(image.get(name)) for name in PLACE]
