"""Pictures by Inkscape and by gradmesh of the same mesh, and how much they differ."""

import copy
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import NamedTuple

import numpy as np
from PIL import Image

import displays
import svg_meshes
from program import error, meshes, printed as gradmesh  # noqa: F401, for all who draw
from svg_meshes import GRADMESH, SVG


def info(svg):
    """What gradmesh says of the meshes in a document, by id."""
    return {mesh["id"]: mesh for mesh in meshes(svg)}


def flip(a, b):
    return error(a, b)


def difference(a, b):
    """The largest difference of each pixel's channels, in levels."""
    with Image.open(a) as first, Image.open(b) as second:
        pair = [np.array(picture.convert("RGB"), int) for picture in (first, second)]
    assert pair[0].shape == pair[1].shape
    return np.abs(pair[0] - pair[1]).max(axis=2)


def on_white(png):
    """Lays a picture on white."""
    with Image.open(png) as picture:
        picture = picture.convert("RGBA")
        page = Image.new("RGBA", picture.size, "white")
        page.alpha_composite(picture)
    page.convert("RGB").save(png)
    return png


def export(inkscape, documents, kind="png", dpi=96):
    """Has Inkscape write all documents, whole pages, in one start; `kind` is png or svg. The
    files lie beside the documents."""
    command = ["inkscape", f"--export-type={kind}", f"--export-dpi={dpi}", "--export-area-page"]
    ending = ".png" if kind == "png" else "_out.svg"
    files = [Path(document).with_name(Path(document).stem + ending) for document in documents]
    done = displays.run([*command, *map(str, documents)], inkscape.env, inkscape.timeout)
    for file in files:
        assert file.exists(), f"Inkscape wrote no {file.name}: {done.stderr}"
    return files


class Frame(NamedTuple):
    """How gradmesh lays a mesh out on a picture."""

    width: int
    height: int
    matrix: tuple  # from the document to pixels


def fit_frame(nets, resolution=700):
    """The frame for the mesh with these nets in the document: the box of its patches' points at
    the eighths, and 1.5 % of the longer side around it."""
    points = np.concatenate([svg_meshes.surface(net, 8) for net in nets])
    low = complex(points.real.min(), points.imag.min())
    size = complex(points.real.max(), points.imag.max()) - low
    longer = max(size.real, size.imag)
    pad = 0.015 * longer
    scale = resolution / (longer + 2 * pad)
    width, height = (int((side + 2 * pad) * scale + 1e-9) for side in (size.real, size.imag))
    corner = low - complex(pad, pad)
    return Frame(width, height, (scale, 0, 0, scale, -scale * corner.real, -scale * corner.imag))


def write_bare_mesh(document, element, path, resolution=700):
    """Writes a document that shows, in gradmesh's frame on white, nothing but the mesh that
    paints `element`, without the shape that holds it: through a rectangle larger than the mesh,
    or the blocks of a simplified mesh through their own paths."""
    blocks = [e for e in element.iter() if e.get(GRADMESH + "face")]
    nets = [
        svg_meshes.apply(document.to_document(e), document.net(e)) for e in blocks or [element]
    ]
    frame = fit_frame(nets, resolution)
    root = copy.deepcopy(document.root)
    for child in list(root):
        if child.tag != SVG + "defs":
            root.remove(child)
    size = {"width": str(frame.width), "height": str(frame.height)}
    root.attrib.update(size, viewBox=f"0 0 {frame.width} {frame.height}")
    ET.SubElement(root, SVG + "rect", size, fill="white")
    first = blocks[0] if blocks else element
    matrix = svg_meshes.compose(frame.matrix, document.to_document(first))
    group = ET.SubElement(root, SVG + "g", transform=matrix_text(matrix))
    if blocks:
        group.extend(copy.deepcopy(blocks))
        if mask := document.opacity_mask(first):
            group.set("mask", f"url(#{mask})")
    else:
        group.append(_large_rectangle(document, element, root))
    ET.ElementTree(root).write(path)


def _large_rectangle(document, element, root):
    gradient_id = document.paint(element).get("id")
    (gradient,) = [e for e in root.iter() if e.get("id") == gradient_id]
    gradient.set("gradientUnits", "userSpaceOnUse")
    gradient.set("gradientTransform", matrix_text(document.units(element)))
    net = document.net(element)
    low = complex(net.real.min(), net.imag.min())
    size = complex(net.real.max(), net.imag.max()) - low
    corner = low - size / 2
    box = {"x": corner.real, "y": corner.imag, "width": 2 * size.real, "height": 2 * size.imag}
    attributes = {name: repr(float(value)) for name, value in box.items()}
    return ET.Element(SVG + "rect", attributes, fill=f"url(#{gradient_id})")


def matrix_text(matrix):
    return f"matrix({','.join(repr(float(v)) for v in matrix)})"
