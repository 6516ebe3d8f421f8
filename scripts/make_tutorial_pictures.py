#!/usr/bin/env python3
"""Writes the pictures of docs/from-a-photograph.md into docs/images/, all from the real Inkscape.

    make_tutorial_pictures.py       (after scripts/setup)

photograph-path.jpg        the path while the pen tool draws it, and its nodes
photograph-dialog.jpg      the dialog of Trace Picture, with its preview
photograph-result.jpg      the photograph and the mesh, at 100 % and at 200 %
photograph-handles.jpg     the mesh in the mesh tool
photograph-highlight.jpg   the highlight selected, dragged, and what it looks like
photograph-apple.jpg       the photograph, the lines of the mesh, and the mesh, small
photograph-which.jpg       three pictures that make good meshes, and three that do not

All but the last are of one session in one window: a person's steps from an empty page to a dragged highlight.
"""

import base64
import shutil
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "python" / "helpers"))

from make_readme_pictures import MESH_TOOL, below_each_other, shot, side_by_side, with_patches  # noqa: E402
from built import SAMPLES, install_extension  # noqa: E402, makes gradmesh importable
from inkscape_harness import Inkscape  # noqa: E402
from svg_meshes import HREF, SVG, Document, numbers  # noqa: E402

import numpy as np  # noqa: E402
from PIL import Image  # noqa: E402
from skimage import data  # noqa: E402

import gradmesh  # noqa: E402

IMAGES = ROOT / "docs" / "images"
PHOTOGRAPHS = SAMPLES / "photographs"
EMPTY = '<svg xmlns="http://www.w3.org/2000/svg" width="600px" height="450px" viewBox="0 0 600 450"/>\n'

# Where things are on the harness's screen.
CANVAS, CANVAS_HEIGHT = 716 + 523.5j, 755  # the middle, and what "5" and "3" fit the page and the selection into
NO_FILL, AQUA, NOWHERE = (9, 955), (383, 955), ("1000", "930")
LIVE_PREVIEW, APPLY, CLOSE = (24, -57), (656, -20), (566, -20)  # from the lower left corner of the dialog
APPLE, DIALOG = (440, 255, 970, 760), (0, 0, 960, 930)

# In the drawing: its middle, its height, the photograph's highlight with what is around it, and how it is dragged.
PAGE, PAGE_HEIGHT = 300 + 225j, 450
HIGHLIGHT, AWAY = (204 + 168j, 293 + 227j), 16j
AT_100, AT_200, SMALL = (90, 65, 490, 365), (185, 110, 385, 310), (140, 70, 450, 360)

# Handles asked for, sample, outline in it, and its caption; or name, and width; all in pixels.
ASKED, GOOD = 150, (("apple", "apple", "an apple"), ("coffee", "cup", "a cup"), ("cat", "eye", "a cat's eye"))
ASKED_WHOLE, BAD = 400, {"grass": 232, "gravel": 232, "text": 346}
GOOD_WIDTH, MARGIN = 270, 10


class View:
    """Where points of the drawing are on the screen."""

    def __init__(self, middle, height, canvas_height=CANVAS_HEIGHT):
        self.middle, self.zoom = middle, canvas_height / height

    def pixel(self, point):
        place = CANVAS + self.zoom * (point - self.middle)
        return round(place.real), round(place.imag)


def save(picture, name):
    picture.save(IMAGES / name, quality=84, optimize=True)


def unpack(photograph, path):
    """Writes the picture that is embedded in a sample photograph."""
    link = ET.parse(photograph).find(f".//{SVG}image").get(HREF)
    path.write_bytes(base64.b64decode(link.partition(",")[2]))


def without_tips(window):
    """Moves the pointer to where nothing is said about anything."""
    window.xdotool("mousemove", *NOWHERE)
    window.settle()


def focus(window, title):
    own = window.find_window(title)
    window.xdotool("windowfocus", own)
    window.settle()
    return own


def size_of(window, own):
    """The width and the height of a window of Inkscape's, which shows it in the upper left corner."""
    geometry = window.xdotool("getwindowgeometry", "--shell", own)
    values = dict(line.split("=") for line in geometry.split() if "=" in line)
    return int(values["WIDTH"]), int(values["HEIGHT"])


def import_photograph(window, folder, photograph):
    """Imports the photograph as Inkscape offers it, embedded, and makes the page as large."""
    window.key("ctrl+i")
    focus(window, "Select file to import")
    window.key("ctrl+l")
    window.xdotool("type", "--delay", "60", str(photograph))
    window.settle()
    window.key("Return")
    focus(window, "bitmap image import")
    window.key("Return")
    focus(window, "drawing.svg")
    window.key("ctrl+shift+r")
    window.key("5")


def draw_path(window, folder):
    """Draws the outline of the sample with the pen tool, each node dragged to its handle, and gives it a colour."""
    d = ET.parse(PHOTOGRAPHS / "apple.svg").find(f".//{SVG}path").get("d")
    x, y = np.reshape(numbers(d), (-1, 2)).T
    points = x + 1j * y
    steps = list(zip(points[:-1:3], points[1::3]))
    view = View(PAGE, PAGE_HEIGHT)
    window.key("Escape")
    window.key("b")
    for i, (node, handle) in enumerate([*steps, steps[0]]):
        if i == 8:
            window.xdotool("mousemove", *map(str, view.pixel(node)))
            window.settle()
            drawing = shot(window, folder, APPLE)
        window.drag(*view.pixel(node), *view.pixel(handle))
    window.click(*NO_FILL)
    window.xdotool("keydown", "shift")
    window.click(*AQUA)
    window.xdotool("keyup", "shift")
    window.key("n")
    without_tips(window)
    panels = [("the pen tool at its ninth node", drawing), ("all twelve", shot(window, folder, APPLE))]
    save(side_by_side(panels), "photograph-path.jpg")


def trace(window, folder):
    """Traces the photograph in the path as the dialog offers it."""
    window.key("s")
    window.key("ctrl+a")
    window.key("F10")
    _, height = size_of(window, window.find_window("Trace Picture"))
    preview, apply, close = ((x, height + y) for x, y in (LIVE_PREVIEW, APPLY, CLOSE))
    window.click(*preview)
    save(shot(window, folder, DIALOG), "photograph-dialog.jpg")
    window.click(*apply)
    window.click(*close)
    focus(window, "drawing.svg")
    window.key("ctrl+s")


def mesh_of(svg):
    """The one mesh of the document, and its points at the corners of the patches."""
    (mesh,) = gradmesh.load(svg).meshes
    document = Document(svg)
    return mesh, document.net(document.by_id[mesh.id])[::3, ::3]


def box(inkscape, svg, name):
    """The upper left and the lower right corner of what an object covers, as Inkscape says."""
    lines = (line.split(",") for line in inkscape.run_actions(svg, ["query-all"]).stdout.splitlines())
    x, y, width, height = next(map(float, rest) for found, *rest in lines if found == name)
    return complex(x, y), complex(x + width, y + height)


def show_handles(window, folder, view):
    """Selects the mesh alone, fits it into the window with some space around it, and shows its handles."""
    window.key("Escape")
    window.click(*View(PAGE, PAGE_HEIGHT).pixel(PAGE))
    window.key("3")
    window.key("minus")
    window.click(*MESH_TOOL)
    without_tips(window)
    left, top = view.pixel(130 + 80j)
    right, bottom = view.pixel(455 + 375j)
    save(shot(window, folder, (left, top, right, bottom)), "photograph-handles.jpg")


def drag_highlight(window, folder, view, corners):
    """Selects the points of the highlight and those around it, and drags one of them, which the others follow."""
    left, top = view.pixel(170 + 130j)
    right, bottom = view.pixel(335 + 265j)
    area = (left, top, right, bottom)
    window.drag(*(n for corner in HIGHLIGHT for n in view.pixel(corner)))
    without_tips(window)
    panels = [("selected", shot(window, folder, area))]
    dragged = min(corners.ravel(), key=lambda point: abs(point - sum(HIGHLIGHT) / 2))
    window.drag(*view.pixel(dragged), *view.pixel(dragged + AWAY))
    without_tips(window)
    panels.append(("dragged", shot(window, folder, area)))
    window.key("ctrl+s")
    window.key("Escape")
    window.key("s")
    window.key("Escape")
    without_tips(window)
    panels.append(("what it looks like", shot(window, folder, area)))
    save(side_by_side(panels), "photograph-highlight.jpg")


def session(folder):
    """Goes all the way from an empty page to the dragged highlight; the document with the mesh is returned."""
    photograph, drawing, traced = (folder / name for name in ("apple.jpg", "drawing.svg", "traced.svg"))
    unpack(PHOTOGRAPHS / "apple.svg", photograph)
    drawing.write_text(EMPTY)
    with Inkscape() as inkscape:
        inkscape.install(install_extension(folder / "installed"))
        inkscape.set_key("F10", "app.org.gradmesh.trace")
        with inkscape.window(drawing) as window:
            window.key("5")
            import_photograph(window, folder, photograph)
            draw_path(window, folder)
            trace(window, folder)
            shutil.copy(drawing, traced)
            mesh, corners = mesh_of(traced)
            print(f"{mesh.id}: {mesh.handles} handles")
            low, high = box(inkscape, traced, mesh.id)
            view = View((low + high) / 2, high.imag - low.imag, CANVAS_HEIGHT / 2**0.5)
            show_handles(window, folder, view)
            drag_highlight(window, folder, view, corners)
    return traced


def without(svg, out, tag):
    """Writes the document without the elements of this name at its top."""
    root = ET.parse(svg).getroot()
    for element in root.findall(SVG + tag):
        root.remove(element)
    ET.ElementTree(root).write(out)
    return out


def part(inkscape, svg, folder, area, **how):
    """A part of a document as Inkscape paints it, on white."""
    with Image.open(inkscape.export_png(svg, folder / "part.png", area=area, **how)) as picture:
        page = Image.new("RGBA", picture.size, "white")
        page.alpha_composite(picture.convert("RGBA"))
        return page.convert("RGB")


def result(traced, folder):
    """The photograph beside the mesh on it, at two sizes and, with the lines of the mesh, small."""
    mesh, _ = mesh_of(traced)
    photograph = without(traced, folder / "photograph.svg", "path")
    rows = []
    with Inkscape() as inkscape:
        for percent, area in ((100, AT_100), (200, AT_200)):
            panels = [
                (f"{name}, {percent} %", part(inkscape, svg, folder, area, dpi=0.96 * percent))
                for name, svg in (("the photograph", photograph), ("the mesh", traced))
            ]
            rows.append(side_by_side(panels))
        lines = with_patches(traced, folder / "lines.svg", mesh.id)
        documents = (("a photograph", photograph), (f"{mesh.handles} handles", lines), ("the mesh", traced))
        small = [(caption, part(inkscape, svg, folder, SMALL, width=270)) for caption, svg in documents]
    save(below_each_other(rows), "photograph-result.jpg")
    save(side_by_side(small), "photograph-apple.jpg")


def good(inkscape, folder, name, outline):
    """What an outline in a sample surrounds, the mesh of it as Inkscape paints it, and what is told of it."""
    sample, out = PHOTOGRAPHS / f"{name}.svg", folder / f"{name}-mesh.svg"
    tracing = gradmesh.trace(None, outline=(sample, outline), handles=ASKED, epsilon=0)
    tracing.document.save(out)
    low, high = box(inkscape, sample, outline)
    area = (low.real - MARGIN, low.imag - MARGIN, high.real + MARGIN, high.imag + MARGIN)
    photograph = without(sample, folder / "photograph.svg", "path")
    mesh = without(out, folder / "mesh.svg", "image")
    return *(part(inkscape, svg, folder, area, width=GOOD_WIDTH) for svg in (photograph, mesh)), told(tracing)


def bad(inkscape, folder, name, width):
    """A picture of scikit-image's, the mesh of it as Inkscape paints it, and what is told of it."""
    file, out = folder / f"{name}.png", folder / f"{name}-mesh.svg"
    picture = Image.fromarray(getattr(data, name)()).convert("RGB")
    picture.save(file)
    tracing = gradmesh.trace(file, handles=ASKED_WHOLE, epsilon=0)
    tracing.document.save(out)
    small = picture.resize((width, round(width * picture.height / picture.width)), Image.Resampling.LANCZOS)
    return small, part(inkscape, out, folder, (0, 0, *picture.size), width=width), told(tracing)


def told(tracing):
    return f"{tracing.handles} handles, {tracing.errors.mean:.1f} of 255"


def as_high(pictures):
    """The pictures in the middle of white ones that are as high as the highest."""
    height = max(picture.height for picture in pictures)
    pages = [Image.new("RGB", (picture.width, height), "white") for picture in pictures]
    for page, picture in zip(pages, pictures):
        page.paste(picture, (0, (height - picture.height) // 2))
    return pages


def which(folder):
    """Good and bad pictures, the mesh of each below it."""
    with Inkscape() as inkscape:
        rows = [
            [(caption, *good(inkscape, folder, name, outline)) for name, outline, caption in GOOD],
            [(name, *bad(inkscape, folder, name, width)) for name, width in BAD.items()],
        ]
    sheets = []
    for row in rows:
        captions, pictures, meshes, words = zip(*row)
        print(*map(": ".join, zip(captions, words)), sep="\n")
        sheets += [side_by_side(list(zip(*line))) for line in ((captions, as_high(pictures)), (words, as_high(meshes)))]
    save(below_each_other(sheets), "photograph-which.jpg")


def main():
    IMAGES.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        result(session(folder), folder)
        which(folder)


if __name__ == "__main__":
    main()
