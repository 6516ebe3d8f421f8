#!/usr/bin/env python3
"""Traces pictures, has Inkscape paint the meshes, and prints the tables of docs/development/quality.md.

    make_trace_pictures.py [--more] [--again [--meshes FOLDER]] [--look FOLDER]      (after scripts/setup)

traced.png   in docs/images/: pictures, the lines of their meshes, and what Inkscape paints of these
outlined.png likewise of what is in an outline

With --more each is traced with few handles and many. With --again all samples, and the authors' meshes, which
FOLDER holds as .hemesh files, are painted and traced too; --look keeps every picture, mesh and result. The
photographs are those of python3-skimage, the middle square of each at 512 x 512 pixels.
"""

import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "python" / "helpers"))

from built import SAMPLES  # noqa: E402, makes gradmesh importable
from inkscape_harness import Inkscape  # noqa: E402
from make_readme_pictures import with_patches  # noqa: E402
from pictures import export, on_white  # noqa: E402

import gradmesh  # noqa: E402

SIDE = 512
#: Of each picture the handles of its goal.
PHOTOGRAPHS = {"coffee": 600, "chelsea": 600, "rocket": 400, "astronaut": 600}
DRAWINGS = {"photo": ("photo.svg", None, 450), "pear": ("fruit.svg", "pear", 200), "face": ("face.svg", None, 400)}
SHOWN = ("photo", "face", "rocket", "coffee")
MORE = (200, 300, 600, 1000)
#: What lies in an outline: the handles of its goal.
OUTLINED = {"pear": 120, "yolk": 270}


def photograph(name, path):
    from skimage import data

    picture = Image.fromarray(getattr(data, name)()).convert("RGB")
    side = min(picture.size)
    left, top = ((length - side) // 2 for length in picture.size)
    picture.crop((left, top, left + side, top + side)).resize((SIDE, SIDE), Image.Resampling.LANCZOS).save(path)


def drawing(document, element, path):
    """Has Inkscape paint a document, or one object of it alone, SIDE pixels along the longer side, on white."""
    for side in ("-w", "-h"):
        command = ["inkscape", "--export-type=png", side, str(SIDE), "-o", str(path), str(document)]
        command[1:1] = ["--export-id", element, "--export-id-only"] if element else ["--export-area-page"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        if max(Image.open(path).size) == SIDE:
            break
    on_white(path)


def yolk(path):
    """Renders the yolk of an egg from above: a dome under a lamp, with two highlights and light through its rim. Its
    outline is returned as path data."""
    y, x = (np.mgrid[0:SIDE, 0:SIDE] + 0.5) / SIDE * 2 - 1

    def radius(a):
        return 0.82 + 0.03 * np.cos(2 * a + 0.5) + 0.02 * np.cos(3 * a) + 0.012 * np.sin(5 * a)

    share = np.hypot(x, y) / radius(np.arctan2(y, x))
    height = np.sqrt(np.clip(1.02 - share**2, 0.02, None)) ** 0.8 * 0.6
    slope_y, slope_x = np.gradient(height, 2 / SIDE)
    normal = np.stack([-slope_x, -slope_y, np.ones_like(x)], axis=-1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)

    def towards(*way):
        return np.clip(normal @ (np.array(way) / np.linalg.norm(way)), 0, 1)

    light = 0.45 + 0.6 * towards(-0.5, -0.6, 0.9)
    shine = 200 * towards(-0.35, -0.4, 1) ** 60 + 60 * towards(0.5, 0.45, 1) ** 30
    rim = 40 * np.clip(share, 0, 1) ** 6
    base = np.array([236, 158, 22]) * light[..., None] + shine[..., None] + rim[..., None] * [0.6, 0.5, 0.1]
    inside = (share <= 1)[..., None]
    Image.fromarray(np.where(inside, base, 255).clip(0, 255).astype("uint8")).save(path)
    angles = np.linspace(0, 2 * np.pi, 240, endpoint=False)
    around = (np.stack([np.cos(angles), np.sin(angles)], axis=-1) * radius(angles)[:, None] + 1) * SIDE / 2
    return "M" + " ".join(f"{px:.2f},{py:.2f}" for px, py in around) + "Z"


def pear_outline():
    """The outline of the pear as path data, and the page that its picture fills."""
    d = ElementTree.parse(SAMPLES / "fruit.svg").find(".//*[@id='pear']").get("d")
    numbers = [float(n) for n in re.findall(r"-?[\d.]+", d)]
    (left, right), (top, bottom) = ((min(n), max(n)) for n in (numbers[::2], numbers[1::2]))
    return d, f"{left} {top} {right - left} {bottom - top}"


def outlined(name, handles, folder, inkscape):
    """Traces what is in an outline, and prints how Inkscape's painting of it differs."""
    picture = folder / f"{name}.png"
    path, page = (yolk(picture), f"0 0 {SIDE} {SIDE}") if name == "yolk" else pear_outline()
    width, height = Image.open(picture).size
    outline = folder / f"{name}-outline.svg"
    outline.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="{page}"'
        f' preserveAspectRatio="none"><path id="{name}" d="{path}" fill="none" stroke="red"/></svg>'
    )
    mesh = folder / f"{name}-in-outline.svg"
    tracing = gradmesh.trace(picture, outline=(outline, name), handles=handles, epsilon=0)
    tracing.document.save(mesh)
    (result,) = export(inkscape, [mesh])
    flip = gradmesh.compare(pixels(picture), pixels(on_white(result)))
    print(
        f"| {name} | {tracing.handles} | {tracing.errors.mean:.2f}, {tracing.errors.rmse:.2f} |"
        f" {tracing.errors.flip:.3f} | {flip:.4f} | {tracing.seconds:.1f} |",
        flush=True,
    )
    return [picture, with_lines(mesh, inkscape, name), result]


def pixels(path):
    return np.asarray(Image.open(path).convert("RGB")).copy()


def traced(picture, handles, inkscape):
    """What is told of the mesh of a picture, and how Inkscape's painting of it differs."""
    mesh = picture.with_name(f"{picture.stem}-mesh.svg")
    tracing = gradmesh.trace(picture, handles=handles, epsilon=0)
    tracing.document.save(mesh)
    (result,) = export(inkscape, [mesh])
    painted, wanted = pixels(on_white(result)), pixels(picture)
    rmse = np.sqrt(np.mean((painted.astype(float) - wanted) ** 2))
    flip = gradmesh.compare(wanted, painted)
    print(
        f"| {picture.stem} | {tracing.handles} | {rmse:.1f}, {20 * np.log10(255 / rmse):.1f} dB, {flip:.3f} |"
        f" {tracing.errors.rmse:.1f} | {tracing.seconds:.1f} |",
        flush=True,
    )
    return mesh, result


def with_lines(mesh, inkscape, element="mesh"):
    """The picture of a mesh with its lines."""
    lines = mesh.with_name(f"{mesh.stem}-lines.svg")
    with_patches(mesh, lines, element)
    return on_white(export(inkscape, [lines])[0])


def side_by_side(rows, out):
    """Writes pictures beside and below each other, at half of their size."""
    half = [[Image.open(path).convert("RGB") for path in row] for row in rows]
    half = [[p.resize((p.width // 2, p.height // 2), Image.Resampling.LANCZOS) for p in row] for row in half]
    width = max(sum(p.width for p in row) + 8 * (len(row) - 1) for row in half)
    page = Image.new("RGB", (width, sum(row[0].height for row in half) + 8 * (len(half) - 1)), "white")
    y = 0
    for row in half:
        x = 0
        for picture in row:
            page.paste(picture, (x, y))
            x += picture.width + 8
        y += row[0].height + 8
    page.save(out, optimize=True)


def goals(folder, inkscape):
    rows = {}
    for name, (file, element, handles) in DRAWINGS.items():
        drawing(SAMPLES / file, element, folder / f"{name}.png")
        rows[name] = traced(folder / f"{name}.png", handles, inkscape)
    for name, handles in PHOTOGRAPHS.items():
        photograph(name, folder / f"{name}.png")
        rows[name] = traced(folder / f"{name}.png", handles, inkscape)
    return rows


def more(folder, inkscape):
    for name in (*DRAWINGS, *PHOTOGRAPHS):
        for handles in MORE:
            traced(folder / f"{name}.png", handles, inkscape)


def samples(folder, meshes, inkscape):
    """All samples, and the authors' meshes, painted and traced again with as many handles as they had."""
    for file in sorted(SAMPLES.glob("*.svg")):
        for mesh in gradmesh.load(file).meshes:
            picture = folder / f"again-{mesh.id}.png"
            drawing(file, mesh.id, picture)
            traced(picture, mesh.handles, inkscape)
    for file in sorted(meshes.glob("*.hemesh")) if meshes else ():
        document = gradmesh.load(file)
        picture = folder / f"again-{file.stem}.png"
        Image.fromarray(gradmesh.render(document, resolution=SIDE)).save(picture)
        traced(picture, document.meshes[0].handles, inkscape)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--more", action="store_true", help="trace each with few handles and many")
    parser.add_argument("--again", action="store_true", help="trace the samples, too")
    parser.add_argument("--meshes", type=Path, help="the authors' meshes")
    parser.add_argument("--look", type=Path, help="where every picture, mesh and result is kept")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch, Inkscape() as inkscape:
        folder = arguments.look or Path(scratch)
        folder.mkdir(exist_ok=True)
        rows = goals(folder, inkscape)
        shown = []
        for name in SHOWN:
            mesh, result = rows[name]
            shown.append([folder / f"{name}.png", with_lines(mesh, inkscape), result])
        side_by_side(shown, ROOT / "docs" / "images" / "traced.png")
        shown = [outlined(name, handles, folder, inkscape) for name, handles in OUTLINED.items()]
        side_by_side(shown, ROOT / "docs" / "images" / "outlined.png")
        if arguments.more:
            more(folder, inkscape)
        if arguments.again:
            samples(folder, arguments.meshes, inkscape)


if __name__ == "__main__":
    main()
