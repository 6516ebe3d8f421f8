#!/usr/bin/env python3
"""Traces pictures, has Inkscape paint the meshes, and prints the tables of docs/quality.md.

    make_trace_pictures.py [--again [--meshes FOLDER]] [--look FOLDER]      (after scripts/setup)

traced.png   in docs/images/: pictures, the lines of their meshes, and what Inkscape paints of these

With --again all samples, and the authors' meshes, which FOLDER holds as .hemesh files, are painted and traced
too; --look keeps every picture, mesh and result. The photographs are those of python3-skimage, the middle square
of each at 512 x 512 pixels.
"""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

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
        f"| {picture.stem} | {tracing.handles} | {rmse:.1f} / {flip:.3f} | {tracing.errors.rmse:.1f} |"
        f" {tracing.seconds:.1f} |",
        flush=True,
    )
    return mesh, result


def with_lines(mesh, inkscape):
    """The picture of a mesh with its lines."""
    lines = mesh.with_name(f"{mesh.stem}-lines.svg")
    with_patches(mesh, lines, "mesh")
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
        if arguments.again:
            samples(folder, arguments.meshes, inkscape)


if __name__ == "__main__":
    main()
