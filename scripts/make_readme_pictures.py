#!/usr/bin/env python3
"""Writes docs/images/before-after.png: a sample and its patches, painted by a real Inkscape.

    make_readme_pictures.py       (after scripts/setup)
"""

import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "python"))

from built import SAMPLES  # noqa: E402, which also makes gradmesh importable
from inkscape_harness import Inkscape  # noqa: E402
from svg_meshes import SVG, Document  # noqa: E402

import gradmesh  # noqa: E402

SAMPLE, MESH, WIDTH = "fruit", "pear", 340


def curve(points):
    """Path data of a row of Bezier points."""
    text = [f"{z.real:.2f},{z.imag:.2f}" for z in points]
    return f"M {text[0]} C {' '.join(text[1:])}"


def with_patches(svg, out):
    """Writes the document with the sides of all its patches drawn on top."""
    document = Document(svg)
    nets = list(document.blocks().values()) or [document.net(document.by_id[MESH])]
    lines = [line for net in nets for line in (*net[::3], *net.T[::3])]
    for color, width in (("#ffffff", 2.4), ("#1b3a5c", 1)):
        style = f"fill:none;stroke:{color};stroke-width:{width}"
        ET.SubElement(document.root, SVG + "path", d=" ".join(map(curve, lines)), style=style)
    ET.ElementTree(document.root).write(out)
    return out


def panels(folder):
    """(caption, SVG file) from left to right."""
    before, after = SAMPLES / f"{SAMPLE}.svg", folder / "after.svg"
    document = gradmesh.load(before)
    (result,) = gradmesh.simplify(document, MESH)
    gradmesh.save(document, after)
    return [
        ("before", before),
        (f"{result.patches_before} patches", with_patches(before, folder / "before-patches.svg")),
        (f"{result.patches_after} patches", with_patches(after, folder / "after-patches.svg")),
        ("after", after),
    ]


def main(out):
    with tempfile.TemporaryDirectory() as name, Inkscape() as inkscape:
        folder = Path(name)
        pictures = []
        for caption, svg in panels(folder):
            png = inkscape.export_png(svg, folder / "picture.png", width=WIDTH)
            with Image.open(png) as picture:
                pictures.append((caption, picture.convert("RGB")))
    height = max(picture.height for _, picture in pictures)
    sheet = Image.new("RGB", (len(pictures) * (WIDTH + 8) - 8, height + 36), "white")
    draw = ImageDraw.Draw(sheet)
    font = ImageFont.truetype("DejaVuSans.ttf", 18)
    for i, (caption, picture) in enumerate(pictures):
        left = i * (WIDTH + 8)
        sheet.paste(picture, (left, 0))
        draw.text((left + WIDTH // 2, height + 19), caption, "black", font, anchor="mm")
    out.parent.mkdir(parents=True, exist_ok=True)
    sheet.save(out, optimize=True)


if __name__ == "__main__":
    main(ROOT / "docs" / "images" / "before-after.png")
