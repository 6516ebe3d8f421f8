#!/usr/bin/env python3
"""Writes pictures of meshes that a person edits in Inkscape's mesh tool into docs/images/.

    make_handle_pictures.py [NAME ...]       (after scripts/setup)

mesh-tool-ID.png    what the tool shows of samples, before and after
edited.png          a point of the pear dragged: of the sample, by default, and of blocks
amounts.png         what the amounts leave of two samples where that is seen, twice as large
details.png         what the bound on details is for: the worst places of three samples without it

Each picture is taken when every knot that gradmesh counts is drawn; a knot that is drawn where none
is counted, or a count that is not the number of their places, ends the script.
"""

import sys
import tempfile
import time
import xml.etree.ElementTree as ET
from pathlib import Path

from make_readme_pictures import (
    MESH_TOOL,
    ROOT,
    SAMPLES,
    Inkscape,
    below_each_other,
    side_by_side,
    simplified,
)
from PIL import Image

import numpy as np  # noqa: E402, the helpers come with make_readme_pictures
from pages import Page, worst_window  # noqa: E402
from svg_meshes import Document, apply  # noqa: E402

SHOWN = [("fruit", "pear"), ("face", "face"), ("photo", "photo"), ("opacity", "bubble")]
# The page on the harness's screen once it fits the window.
PAGE_MIDDLE, PAGE_TOP, PAGE_HEIGHT = 715, 145, 755
MARGIN = 0.03  # of the mesh, around it
STRAIGHT = 1e-3
COLORS = 256
# The sample's own page, and what is dragged there.
PEAR_PAGE, DRAGGED, DRAG = (0, 0, 480, 600), 170 + 360j, 22 - 16j
DETAILS = ["photo", "two", "face"]
DETAIL_SIDE, ENLARGED = 80, 3
# Where in the samples, painted at 200 %, the amounts are seen.
AMOUNTS = [("photo", (420, 370, 780, 670)), ("smooth", (280, 290, 640, 530))]


def net_of(document, mesh_id):
    element = document.by_id[mesh_id]
    return apply(document.to_document(element), document.net(element))


def framed(svg, mesh_id, frame, out):
    """Writes the document with the frame (x, y, width, height) as its page."""
    root = Document(svg).root
    root.set("viewBox", " ".join(map(str, frame)))
    root.set("width", str(frame[2]))
    root.set("height", str(frame[3]))
    ET.ElementTree(root).write(out)
    return out


def frame_of(net):
    low, high = (complex(f(net.real), f(net.imag)) for f in (np.min, np.max))
    margin = MARGIN * max((high - low).real, (high - low).imag)
    return (
        low.real - margin,
        low.imag - margin,
        (high - low).real + 2 * margin,
        (high - low).imag + 2 * margin,
    )


def knots(net):
    """The places of the knots that the mesh tool draws, and of those that it hides, as sides are
    straight there."""
    drawn, hidden = [*net[::3, ::3].ravel()], []
    for lines in (net[::3], net[:, ::3].T):
        for line in lines:
            for start in range(0, len(line) - 1, 3):
                a, b, c, d = line[start : start + 4]
                straight = max(abs(3 * b - 2 * a - d), abs(3 * c - a - 2 * d)) < 3 * STRAIGHT
                (hidden if straight else drawn).extend((b, c))
    return np.array(drawn), np.array(hidden)


def boxes(picture, places, size):
    """The squares of the picture, 2 * size + 1 pixels wide, around the places."""
    around = np.arange(-size, size + 1)
    x, y = (np.rint(part).astype(int)[:, None, None] for part in (places.real, places.imag))
    return picture[y + around[:, None], x + around]


def pixels(window, folder):
    with Image.open(window.screenshot(folder / "shot.png")) as picture:
        return picture.convert("RGB")


def placed(frame):
    """The scale of the page on the screen, and where the origin of the document lies there."""
    scale = PAGE_HEIGHT / frame[3]
    left = PAGE_MIDDLE - scale * frame[2] / 2
    return scale, complex(left, PAGE_TOP) - scale * complex(*frame[:2])


def page_area(frame):
    half = round(PAGE_HEIGHT / frame[3] * frame[2] / 2)
    return (PAGE_MIDDLE - half, PAGE_TOP, PAGE_MIDDLE + half, PAGE_TOP + PAGE_HEIGHT)


def wait_until(seen, window, folder, timeout):
    """The first picture of the screen of which `seen` finds nothing missing."""
    end = time.monotonic() + timeout
    while True:
        picture = pixels(window, folder)
        missing = seen(np.array(picture, int))
        if not missing:
            return picture
        if time.monotonic() > end:
            raise SystemExit(f"{missing} on the screen")


def shown(svg, mesh_id, count, frame, folder):
    """What the mesh tool shows of a mesh, once all of its knots are drawn."""
    drawn, hidden = knots(net_of(Document(svg), mesh_id))
    if len(drawn) != count:
        raise SystemExit(f"{mesh_id}: {count} handles are counted, and {len(drawn)} have a place")
    scale, origin = placed(frame)
    drawn, hidden = scale * drawn + origin, scale * hidden + origin
    far = np.array([place for place in hidden if abs(drawn - place).min() > 12])
    page = framed(svg, mesh_id, frame, folder / "page.svg")
    with Inkscape() as inkscape, inkscape.window(page) as window:
        window.key("5")
        window.click(PAGE_MIDDLE, PAGE_TOP + PAGE_HEIGHT // 2)
        before = np.array(pixels(window, folder), int)

        def missing(now):
            changed = abs(now - before).max(axis=2) > 30
            absent = np.count_nonzero(~boxes(changed, drawn, 3).any(axis=(1, 2)))
            return absent and f"{mesh_id}: {absent} of {count} knots are missing"

        window.click(*MESH_TOOL)
        picture = wait_until(missing, window, folder, inkscape.timeout)
    # A handle is a white disc, on which lines are drawn: blue, or its mixture with white.
    after = np.array(picture, int)
    white = (after[..., 2] > 225) & (abs(after - before).max(axis=2) > 30)
    if len(far) and (discs := (boxes(white, far, 3).mean(axis=(1, 2)) > 0.95).sum()):
        raise SystemExit(f"{mesh_id}: {discs} knots are drawn that are not counted")
    return picture.crop(page_area(frame))


def mesh_tool(sample, mesh_id, folder):
    before, after = SAMPLES / f"{sample}.svg", folder / "after.svg"
    (result,) = simplified(before, after, mesh_id, amount="balanced")
    frame = frame_of(net_of(Document(before), mesh_id))
    return side_by_side(
        [
            (f"{count} handles", shown(svg, mesh_id, count, frame, folder))
            for svg, count in ((before, result.handles_before), (after, result.handles_after))
        ]
    )


def dragged(svg, folder, out):
    """Drags a point of the pear, saves, and returns what the tool shows around it."""
    document = Document(svg)
    nets = [*document.blocks().values()] or [net_of(document, "pear")]
    corners = np.concatenate([net[::3, ::3].ravel() for net in nets])
    point = corners[np.argmin(abs(corners - DRAGGED))]
    scale, origin = placed(PEAR_PAGE)
    start, end = (scale * place + origin for place in (point, point + DRAG))
    out.write_bytes(Path(svg).read_bytes())
    with Inkscape() as inkscape, inkscape.window(out) as window:
        window.key("5")
        window.double_click(PAGE_MIDDLE, PAGE_TOP + PAGE_HEIGHT // 2)
        window.key("ctrl+a")
        window.click(*MESH_TOOL)
        before = np.array(pixels(window, folder), int)
        window.drag(*(round(v) for v in (start.real, start.imag, end.real, end.imag)))

        def missing(now):
            changed = abs(now - before).max(axis=2) > 30
            return not boxes(changed, np.array([end]), 3).any() and "the dragged point is missing"

        picture = wait_until(missing, window, folder, inkscape.timeout)
        window.key("ctrl+s")
        wait_until(
            lambda _: out.read_bytes() == Path(svg).read_bytes() and "nothing is saved",
            window,
            folder,
            inkscape.timeout,
        )
        painted = inkscape.export_png(out, folder / "dragged.png", dpi=96 * scale)
    around = [round(v) for v in (start.real, start.imag)]
    x, y, wide, high = around[0] - 110, around[1] - 110, 320, 240
    with Image.open(painted) as bare:
        left, top = round(origin.real), PAGE_TOP
        below = bare.convert("RGB").crop((x - left, y - top, x - left + wide, y - top + high))
    return below_each_other([picture.crop((x, y, x + wide, y + high)), below], gap=6)


def edited(folder):
    panels = []
    for method in (None, "simplest", "best"):
        svg, handles = SAMPLES / "fruit.svg", "the sample"
        if method:
            bounds = {"count": "handles", "max_local_error": 0.1}
            before, svg = svg, folder / f"{method}.svg"
            (result,) = simplified(before, svg, "pear", method=method, **bounds)
            handles = f"{result.handles_after} handles" + (", blocks" if result.objects > 1 else "")
        panels.append((handles, dragged(svg, folder, folder / "edited.svg")))
    return side_by_side(panels)


def amounts(folder):
    columns = []
    for caption, amount in (("the sample", None), ("Balanced", "balanced"), ("Strong", "strong")):
        column = []
        for sample, area in AMOUNTS:
            svg = SAMPLES / f"{sample}.svg"
            if amount:
                before, svg = svg, folder / f"{sample}.svg"
                simplified(before, svg, amount=amount)
            with Inkscape() as inkscape:
                png = inkscape.export_png(svg, folder / "picture.png", dpi=192)
            with Image.open(png) as picture:
                column.append(picture.convert("RGB").crop(area))
        columns.append((caption, below_each_other(column, gap=6)))
    return side_by_side(columns)


def details(folder):
    columns = {"the sample": [], "0.01 in the mean": [], "Balanced": []}
    bounds = [{"epsilon": 0.01, "max_local_error": 0.1}, {"amount": "balanced"}]
    for sample in DETAILS:
        svg, out = SAMPLES / f"{sample}.svg", folder / "after.svg"
        with Inkscape() as inkscape:
            page = Page(inkscape, svg, folder, 1400)
            pictures = [page.before]
            for options in bounds:
                simplified(svg, out, **options)
                pictures.append(page.paint(out))
        _, middle = worst_window(page.errors(pictures[1]), 8)
        x, y = (max(0, v - DETAIL_SIDE // 2) for v in middle)
        for column, picture in zip(columns.values(), pictures):
            part = Image.fromarray(picture).crop((x, y, x + DETAIL_SIDE, y + DETAIL_SIDE))
            size = (DETAIL_SIDE * ENLARGED,) * 2
            column.append(part.resize(size, Image.Resampling.NEAREST))
    return side_by_side([(name, below_each_other(column, gap=6)) for name, column in columns.items()])


def save(sheet, file):
    sheet.quantize(COLORS, kmeans=2, dither=Image.Dither.NONE).save(file, optimize=True)


def main(images, names):
    pictures = {f"mesh-tool-{shown[1]}": (mesh_tool, shown) for shown in SHOWN}
    pictures.update(edited=(edited, ()), amounts=(amounts, ()), details=(details, ()))
    for name in names or pictures:
        make, of = pictures[name]
        with tempfile.TemporaryDirectory() as folder:
            save(make(*of, Path(folder)), images / f"{name}.png")


if __name__ == "__main__":
    main(ROOT / "docs" / "images", sys.argv[1:])
