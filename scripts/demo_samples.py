#!/usr/bin/env python3
"""Simplifies the samples with the extension, in a real Inkscape with a profile of its own.

    demo_samples.py EXTENSION OUTPUT

EXTENSION is the installed folder of the extension. For each sample OUTPUT gets NAME-before and
NAME-after, as SVG and PNG, and stdout a line: patches, error, seconds.
"""

import json
import os
import re
import shutil
import sys
import time
import xml.etree.ElementTree as ET
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tests" / "python" / "helpers"), str(ROOT / "build" / "python")]

import gradmesh  # noqa: E402
from inkscape_harness import Inkscape, Timeout  # noqa: E402

RAW_ID = "org.gradmesh.simplify"
LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
ERROR = re.compile(r"Gradient mesh: \d+ of \d+ patches, .+ ([0-9.]+)")


def patches(svg):
    return {mesh.id: mesh.patches for mesh in gradmesh.load(svg).meshes}


def outcome(svg):
    """The largest error that the labels of blocks state; one mesh gradient has no such label."""
    labels = (element.get(LABEL, "") for element in ET.parse(svg).iter())
    errors = [float(found[1]) for found in map(ERROR.match, labels) if found]
    return f"error {max(errors):.4f}" if errors else "still one mesh gradient"


def run(inkscape, sample, folder):
    """Runs one sample; returns its line."""
    before, after = (folder / f"{sample.stem}-{when}.svg" for when in ("before", "after"))
    shutil.copy(sample, before)
    after.unlink(missing_ok=True)
    inkscape.export_png(before, before.with_suffix(".png"))
    meshes = patches(before)
    start = time.monotonic()
    became = simplify(inkscape, before, after, list(meshes))
    seconds = time.monotonic() - start
    if became["outcome"] == "unchanged":
        return f"{sum(meshes.values())} patches, nothing to merge"
    if became["outcome"] != "done" or not after.exists():
        raise AssertionError(became["message"] or "Inkscape wrote nothing")
    inkscape.export_png(after, after.with_suffix(".png"))
    return (
        f"{sum(patches(after).values())} of {sum(meshes.values())} patches left, "
        f"{outcome(after)}, {seconds:.1f} s with Inkscape's own start"
    )


def simplify(inkscape, before, after, ids):
    """Runs the extension; returns what it reports."""
    report = Path(os.environ["GRADMESH_REPORT"])
    report.write_text("")
    inkscape.run_extension(RAW_ID, before, after, select=ids)
    line = report.read_text()
    report.unlink()
    if not line:
        raise AssertionError("the extension did not run")
    return json.loads(line)


def main(extension, folder):
    folder.mkdir(parents=True, exist_ok=True)
    failed = 0
    os.environ["GRADMESH_REPORT"] = str((folder / "report.json").resolve())
    with Inkscape(display=os.environ.get("DISPLAY")) as inkscape:
        inkscape.install(extension)
        for sample in sorted((ROOT / "samples").glob("*.svg")):
            try:
                line = run(inkscape, sample, folder)
            except (AssertionError, Timeout) as error:
                line, failed = f"failed: {error}", 1
            print(f"{sample.stem:12} {line}", flush=True)
    print(f"Pictures and documents are in {folder}/.")
    return failed


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), Path(sys.argv[2])))
