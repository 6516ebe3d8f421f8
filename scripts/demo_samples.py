#!/usr/bin/env python3
"""Simplifies the samples, and traces the photograph of an apple, with the extension in a real Inkscape with a
profile of its own.

    demo_samples.py EXTENSION OUTPUT

EXTENSION is the installed folder of the extension. For each sample OUTPUT gets NAME-before and
NAME-after, as SVG and PNG, and stdout a line: handles, patches, objects, error, kB, seconds.
"""

import json
import os
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tests" / "python" / "helpers"), str(ROOT / "build" / "python")]

import gradmesh  # noqa: E402
from displays import Timeout  # noqa: E402
from inkscape_harness import Inkscape  # noqa: E402

APPLE = ROOT / "samples" / "photographs" / "apple.svg"


def patches(svg):
    return {mesh.id: mesh.patches for mesh in gradmesh.load(svg).meshes}


def kilobytes(path):
    return f"{path.stat().st_size / 1000:.1f}"


def copies(inkscape, sample, folder):
    """Paths of the sample as Inkscape saves it, and of what will become of it."""
    before, after = (folder / f"{sample.stem}-{when}.svg" for when in ("before", "after"))
    after.unlink(missing_ok=True)
    # Inkscape gives every row, patch and stop an id and a line of its own: what it saved is compared
    # with what it saved.
    inkscape.run_actions(sample, [f"export-filename:{before}", "export-do"])
    inkscape.export_png(before, before.with_suffix(".png"))
    return before, after


def simplify(inkscape, sample, folder):
    """Simplifies all meshes of a sample; returns its line."""
    before, after = copies(inkscape, sample, folder)
    meshes = patches(before)
    start = time.monotonic()
    became = run(inkscape, "simplify", before, after, list(meshes))
    seconds = time.monotonic() - start
    if became["outcome"] == "unchanged":
        return f"{sum(meshes.values())} patches, nothing to take out"
    check(became, after)
    inkscape.export_png(after, after.with_suffix(".png"))
    left = {
        name: sum(mesh[name] for mesh in became["meshes"])
        for name in ("handles_before", "handles_after", "patches_before", "patches_after", "objects")
    }
    return (
        "{handles_after} of {handles_before} handles, {patches_after} of {patches_before} patches left, "
        "objects {objects}, ".format(**left)
        + f"error {max(mesh['error'] for mesh in became['meshes']):.4f}, "
        f"{kilobytes(before)} > {kilobytes(after)} kB as Inkscape saves them, "
        f"{seconds:.1f} s with Inkscape's own start"
    )


def trace(inkscape, sample, folder):
    """Makes a mesh of what the outline of a sample photograph surrounds; returns its line."""
    before, after = copies(inkscape, sample, folder)
    became = run(inkscape, "trace", before, after, ["photograph", sample.stem])
    check(became, after)
    inkscape.export_png(after, after.with_suffix(".png"))
    (mesh,) = became["meshes"]
    return "a photograph: {handles} handles, {patches} patches, {mean:.1f} of 255 levels off in the mean".format(**mesh)


def run(inkscape, item, before, after, ids):
    """Runs an item of the extension; returns what it reports."""
    report = Path(os.environ["GRADMESH_REPORT"])
    report.write_text("")
    inkscape.run_extension(f"org.gradmesh.{item}", before, after, select=ids)
    line = report.read_text()
    report.unlink()
    if not line:
        raise AssertionError("the extension did not run")
    return json.loads(line)


def check(became, after):
    if became["outcome"] != "done" or not after.exists():
        raise AssertionError(became["message"] or "Inkscape wrote nothing")


def main(extension, folder):
    folder.mkdir(parents=True, exist_ok=True)
    failed = 0
    os.environ["GRADMESH_REPORT"] = str((folder / "report.json").resolve())
    with Inkscape(display=os.environ.get("DISPLAY")) as inkscape:
        inkscape.install(extension)
        samples = [(simplify, sample) for sample in sorted((ROOT / "samples").glob("*.svg"))]
        for work, sample in [*samples, (trace, APPLE)]:
            try:
                line = work(inkscape, sample, folder)
            except (AssertionError, Timeout) as error:
                line, failed = f"failed: {error}", 1
            print(f"{sample.stem:12} {line}", flush=True)
    print(f"Pictures and documents are in {folder}/.")
    return failed


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), Path(sys.argv[2])))
