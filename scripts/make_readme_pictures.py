#!/usr/bin/env python3
"""Writes the pictures of the README and the pages for people into docs/images/, all from the real thing.

    make_readme_pictures.py       (after scripts/setup)

before-after.png   a sample and its patches, painted by Inkscape
dialog.png         the dialog in Inkscape's window, with its preview
by-eye.png         the window of Simplify by Eye, with patches protected and a line pointed at
nodes.png          what the mesh tool shows of the sample, before and after
report.png         the report on it, in Chromium
from-pdf.png       a PDF as Inkscape opens it, and with its mesh put in
pages-dialog.png   the dialog of Meshes of a PDF over it
"""

import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "python" / "helpers"))

import browser  # noqa: E402
from built import SAMPLES, gradmesh as run, install_extension  # noqa: E402, makes gradmesh importable
from displays import run as run_inkscape  # noqa: E402
from inkscape_harness import Inkscape  # noqa: E402
from svg_meshes import SVG, Document  # noqa: E402

import gradmesh  # noqa: E402

SAMPLE, MESH_ID, WIDTH = "fruit", "pear", 340


def curve(points):
    """Path data of a row of Bezier points."""
    text = [f"{z.real:.2f},{z.imag:.2f}" for z in points]
    return f"M {text[0]} C {' '.join(text[1:])}"


def with_patches(svg, out, mesh_id=MESH_ID):
    """Writes the document with the sides of all patches of the mesh, or of all blocks, drawn on top."""
    document = Document(svg)
    nets = list(document.blocks().values()) or [document.net(document.by_id[mesh_id])]
    lines = [line for net in nets for line in (*net[::3], *net.T[::3])]
    for color, width in (("#ffffff", 2.4), ("#1b3a5c", 1)):
        style = f"fill:none;stroke:{color};stroke-width:{width}"
        ET.SubElement(document.root, SVG + "path", d=" ".join(map(curve, lines)), style=style)
    ET.ElementTree(document.root).write(out)
    return out


def simplified(svg, out, ids=(), **options):
    """Writes the document with these meshes simplified, by default all; returns what became of each."""
    document = gradmesh.load(svg)
    results = gradmesh.simplify(document, ids, **options)
    gradmesh.save(document, out)
    return results


def panels(folder):
    """(caption, SVG file) from left to right."""
    before, after = SAMPLES / f"{SAMPLE}.svg", folder / "after.svg"
    (result,) = simplified(before, after, MESH_ID, amount="balanced")
    return [
        ("before", before),
        (f"{result.handles_before} handles", with_patches(before, folder / "before-patches.svg")),
        (f"{result.handles_after} handles", with_patches(after, folder / "after-patches.svg")),
        ("after", after),
    ]


def below_each_other(sheets, gap=12):
    height = sum(sheet.height + gap for sheet in sheets) - gap
    page = Image.new("RGB", (max(sheet.width for sheet in sheets), height), "white")
    top = 0
    for sheet in sheets:
        page.paste(sheet, (0, top))
        top += sheet.height + gap
    return page


def side_by_side(pictures, gap=8):
    """A sheet of (caption, picture), from left to right."""
    height = max(picture.height for _, picture in pictures)
    width = sum(picture.width + gap for _, picture in pictures) - gap
    sheet = Image.new("RGB", (width, height + 36), "white")
    draw = ImageDraw.Draw(sheet)
    font = ImageFont.truetype("DejaVuSans.ttf", 18)
    left = 0
    for caption, picture in pictures:
        sheet.paste(picture, (left, 0))
        draw.text((left + picture.width // 2, height + 19), caption, "black", font, anchor="mm")
        left += picture.width + gap
    return sheet


def painted(panels, folder, width):
    """The panels with pictures instead of files, painted by Inkscape so many pixels wide."""
    pictures = []
    with Inkscape() as inkscape:
        for caption, svg in panels:
            png = inkscape.export_png(svg, folder / "picture.png", width=width)
            with Image.open(png) as picture:
                pictures.append((caption, picture.convert("RGB")))
    return pictures


def before_after(folder, out):
    side_by_side(painted(panels(folder), folder, WIDTH)).save(out, optimize=True)


# Where things are on the harness's screen once the page fits the window.
PEAR, LIVE_PREVIEW = (750, 480), (24, 517)
MESH_TOOL, WINDOW, MESH = (16, 511), (0, 0, 1110, 960), (500, 270, 930, 830)
PANS, BESIDE = 20, (0, 0, 1300, 960)


def shot(window, folder, area):
    with Image.open(window.screenshot(folder / "shot.png")) as picture:
        return picture.convert("RGB").crop(area)


def dialog(folder, out):
    with Inkscape() as inkscape:
        inkscape.install(install_extension(folder / "installed"))
        inkscape.set_key("F10", "app.org.gradmesh.simplify")
        with inkscape.window(SAMPLES / f"{SAMPLE}.svg") as window:
            window.key("5")
            window.click(*PEAR)
            for _ in range(PANS):
                window.key("ctrl+Left")  # so that the dialog covers nothing of the pear
            window.key("F10")
            window.click(*LIVE_PREVIEW)
            shot(window, folder, BESIDE).save(out, optimize=True)


#: Of the window of 1200 x 900 over the sample "face", in the display's corner: around each eye and the
#: mouth, the button Strong, and a line.
PARTS = (198, 304, 363, 426), (462, 304, 627, 426), (296, 573, 512, 690)
STRONG_BY_EYE, CHEEK, BY_EYE = (1128, 287), (216, 526), (0, 0, 1200, 900)


def by_eye(folder, out):
    with Inkscape() as inkscape:
        inkscape.install(install_extension(folder / "installed"))
        inkscape.set_key("F10", "app.org.gradmesh.simplify-by-eye")
        with inkscape.window(SAMPLES / "face.svg") as window:
            window.open_window("F10", "Simplify by Eye")
            for part in PARTS:
                window.drag(*part)
                window.key("p")
            window.click(*STRONG_BY_EYE)
            window.xdotool("mousemove", *map(str, CHEEK))
            window.settle()
            shot(window, folder, BY_EYE).save(out, optimize=True)


def nodes(folder, out):
    """The handles of the mesh, before and after."""
    before, after = SAMPLES / f"{SAMPLE}.svg", folder / "after.svg"
    (result,) = simplified(before, after, MESH_ID, amount="balanced")
    pictures = []
    for handles, svg in ((result.handles_before, before), (result.handles_after, after)):
        with Inkscape() as inkscape, inkscape.window(svg) as window:
            window.key("5")
            window.double_click(*PEAR)
            window.key("ctrl+a")
            window.click(*MESH_TOOL)
            pictures.append((f"{handles} handles", shot(window, folder, MESH)))
    side_by_side(pictures).save(out, optimize=True)


def report(folder, out):
    sample = SAMPLES / f"{SAMPLE}.svg"
    after, done, page = folder / "after.svg", folder / "run.json", folder / "report.html"
    run("simplify", sample, "-o", after, "--id", MESH_ID, "--report", done)
    run("report", sample, after, "-o", page, "--run", done)
    with browser.chromium(1100, 900) as chromium:
        chromium.get(page.as_uri())
        chromium.save_screenshot(str(out))


CODE_LINE = 15  # pixels


def opened_pdf(inkscape, folder):
    """The face as a PDF by Inkscape, and what Inkscape opens that as."""
    pdf, svg = folder / "face.pdf", folder / "opened.svg"
    for made, source in ((pdf, SAMPLES / "face.svg"), (svg, pdf)):
        run_inkscape(["inkscape", f"--export-filename={made}", str(source)], inkscape.env, inkscape.timeout)
    return pdf, svg


def from_pdf(folder, out):
    with Inkscape() as inkscape:
        pdf, svg = opened_pdf(inkscape, folder)
    document = gradmesh.load(svg)
    gradmesh.insert_pages(document, pdf)
    document.save(folder / "meshes.svg")
    sheets = [("File > Open", svg), ("then Meshes of a PDF", folder / "meshes.svg")]
    side_by_side(painted(sheets, folder, 390)).save(out, optimize=True)


def pages_dialog(folder, out):
    with Inkscape() as inkscape:
        pdf, svg = opened_pdf(inkscape, folder)
        inkscape.install(install_extension(folder / "installed"))
        inkscape.set_key("F10", "app.org.gradmesh.pages")
        with inkscape.window(svg) as window:
            window.key("5")
            window.key("F10")
            shot(window, folder, WINDOW).save(out, optimize=True)


def code_for_apps(folder, out):
    """The pear, simplified, and how its code begins."""
    svg, code = folder / "pear.svg", folder / "Pear.swift"
    simplified(SAMPLES / f"{SAMPLE}.svg", svg, MESH_ID, amount="balanced")
    run("publish", svg, "--as", "swift", "-o", code)
    ((_, picture),) = painted([("", svg)], folder, 330)
    text = Image.new("RGB", (560, picture.height), "#f6f6f6")
    lines = code.read_text().splitlines()[: picture.height // CODE_LINE]
    font = ImageFont.truetype("DejaVuSansMono.ttf", 11)
    for number, line in enumerate(lines):
        ImageDraw.Draw(text).text((8, 6 + CODE_LINE * number), line, "#203040", font)
    sheets = [("in Inkscape", picture), (f"{code.name}, {round(code.stat().st_size / 1000)} kB", text)]
    side_by_side(sheets).save(out, optimize=True)


def main(images):
    images.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        before_after(folder, images / "before-after.png")
        dialog(folder, images / "dialog.png")
        by_eye(folder, images / "by-eye.png")
        nodes(folder, images / "nodes.png")
        report(folder, images / "report.png")
        from_pdf(folder, images / "from-pdf.png")
        pages_dialog(folder, images / "pages-dialog.png")
        code_for_apps(folder, images / "code-for-apps.png")


if __name__ == "__main__":
    main(ROOT / "docs" / "images")
