#!/usr/bin/env python3
"""Tells where people may see what simplifying changed: the table and the pictures of docs/development/quality.md.

    look_at_amounts.py [--amounts NAME...] [--pixels N] [--pictures FOLDER] [DOCUMENT...]     (after scripts/setup)

Simplifies all meshes of each document, by default of the samples, by each amount, has Inkscape paint the
page before and after, N pixels along its longer side (1400, twice as many as errors are measured at), and
prints the mean of FLIP, the largest mean in any window of 5, 8, 16 and 32 pixels and the middle of the worst
window of 8. Pixels at the outlines of the objects, where anti-aliasing flickers, do not count. FOLDER gets
both pages of each, to be flickered, and the worst place of each, enlarged, before and after.
"""

import argparse
import sys
import tempfile
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "python" / "helpers"))

from built import SAMPLES  # noqa: E402, makes gradmesh importable
from inkscape_harness import Inkscape  # noqa: E402
from pages import Page, worst_window  # noqa: E402

import gradmesh  # noqa: E402

AMOUNTS = ["gentle", "balanced", "strong"]
WINDOWS = [5, 8, 16, 32]
CROP, ENLARGED = 80, 6


def enlarged(pictures, middle):
    """A part of each picture around a place, side by side."""
    x, y = (max(0, v - CROP // 2) for v in middle)
    size = CROP * ENLARGED
    sheet = Image.new("RGB", (size * len(pictures) + 8 * (len(pictures) - 1), size), "white")
    for i, picture in enumerate(pictures):
        part = Image.fromarray(picture).crop((x, y, x + CROP, y + CROP)).resize((size, size), Image.NEAREST)
        sheet.paste(part, (i * (size + 8), 0))
    return sheet


def look_at(inkscape, svg, amounts, folder, pixels, pictures):
    page = Page(inkscape, svg, folder, pixels)
    for amount in amounts:
        document = gradmesh.load(svg)
        results = gradmesh.simplify(document, amount=amount)
        out = folder / f"{svg.stem}-{amount}.svg"
        gradmesh.save(document, out)
        after = page.paint(out)
        errors = page.errors(after)
        windows = [worst_window(errors, side) for side in WINDOWS]
        middle = windows[WINDOWS.index(8)][1]
        before, left = (sum(getattr(r, f"handles_{when}") for r in results) for when in ("before", "after"))
        means = " ".join(f"{mean:.3f}" for mean, _ in windows)
        print(
            f"{svg.stem:30} {amount:9} {before:6} {left:6}  {errors.mean():.4f}  {means}  {middle}", flush=True
        )
        if pictures:
            name = pictures / f"{svg.stem}-{amount}"
            enlarged([page.before, after], middle).save(f"{name}-worst.png")
            Image.fromarray(page.before).save(pictures / f"{svg.stem}.png")
            Image.fromarray(after).save(f"{name}.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--amounts", nargs="+", choices=AMOUNTS, default=AMOUNTS)
    parser.add_argument("--pixels", type=int, default=1400, help="along the longer side of the page")
    parser.add_argument("--pictures", type=Path, help="folder for pictures")
    parser.add_argument("documents", nargs="*", type=Path, help="SVG documents, by default the samples")
    options = parser.parse_args()
    if options.pictures:
        options.pictures.mkdir(parents=True, exist_ok=True)
    print(f"{'document':30} {'amount':9} {'before':>6} {'after':>6}  FLIP    " + " ".join(f"{n:5}" for n in WINDOWS))
    with tempfile.TemporaryDirectory() as folder, Inkscape() as inkscape:
        for svg in options.documents or sorted(SAMPLES.glob("*.svg")):
            look_at(inkscape, svg, options.amounts, Path(folder), options.pixels, options.pictures)


if __name__ == "__main__":
    main()
