#!/usr/bin/env python3
"""Writes the pictures of docs/development/quality.md into docs/images/.

    make_quality_pictures.py --meshes FOLDER [--json RUNS.json]      (after scripts/setup)

curves-flip.png, curves-ssim.png   patches against error, by every method, on every mesh
quality.png                        our samples before and after, painted by Inkscape

FOLDER holds the authors' meshes as .hemesh files. The runs take a quarter of an hour; what is in
RUNS.json is not run again, and what is run is added. Needs Matplotlib (python3-matplotlib).
"""

import argparse
import json
import tempfile
from pathlib import Path

import matplotlib
from make_readme_pictures import below_each_other, painted, side_by_side, simplified, with_patches
from runs import METHODS, PAPER, ROOT, Bench, gradmesh

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

SAMPLES = ROOT / "samples"
EPSILONS = [0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.03]
METRICS = {"flip": "FLIP", "ssim": "1 \u2212 SSIM"}
#: From the palette of Okabe and Ito, which people tell apart however they see colours.
COLORS = dict(
    zip(METHODS, ["#999999", "#56b4e9", "#0072b2", "#009e73", "#e69f00", "#cc79a7", "#d55e00"])
)


def meshes(folder):
    """(name, file, ids) of the authors' meshes that are there, and of our samples."""
    for name, stem in PAPER["files"].items():
        if (folder / f"{stem}.hemesh").is_file():
            yield name, folder / f"{stem}.hemesh", ()
    for file in sorted(SAMPLES.glob("*.svg")):
        for mesh in gradmesh.load(file).meshes:
            if not mesh.smooth:
                yield mesh.id, file, mesh.id


def run_all(folder, known):
    """Adds what is missing: known[metric][name] = {"before": N, method: [[error, patches], ...]}."""
    with tempfile.TemporaryDirectory() as scratch:
        for metric in METRICS:
            runs = known.setdefault(metric, {})
            for name, file, ids in meshes(folder):
                if name not in runs:
                    bench = Bench(file, metric, PAPER["resolution"], scratch, ids)
                    bench.price(max(EPSILONS))
                    runs[name] = curves(bench)
                    print(metric, name, runs[name]["best"], flush=True)
                    yield


def curves(bench):
    found = {}
    for method in METHODS:
        results = [bench.run(method, epsilon) for epsilon in EPSILONS]
        found["before"] = results[0].patches_before
        found[method] = [[r.error, r.patches_after] for r in results]
    return found


def draw_curves(runs, metric, out):
    columns = 5
    rows = -(-len(runs) // columns)
    figure, axes = pyplot.subplots(rows, columns, figsize=(13, 2.45 * rows), sharex=True)
    for axis in axes.flat[len(runs) :]:
        axis.axis("off")
    for axis, (name, found) in zip(axes.flat, runs.items()):
        for method in METHODS:
            # No error at all has no place on a logarithmic axis.
            points = [(max(error, EPSILONS[0] / 2), patches) for error, patches in found[method]]
            axis.plot(*zip(*points), ".-", color=COLORS[method], lw=1.4, ms=4, label=method)
        axis.set(title=f"{name}, {found['before']} patches", xscale="log", ylim=(0, None))
        axis.set_xlim(EPSILONS[0] / 2.2, 0.035)
        axis.set_xticks([0.001, 0.01], ["0.001", "0.01"])
        axis.title.set_fontsize(10)
        axis.grid(alpha=0.3)
    figure.legend(*axes.flat[0].get_legend_handles_labels(), loc="lower right", ncol=2, fontsize=11)
    figure.supxlabel(f"error measured, {METRICS[metric]}", fontsize=11)
    figure.supylabel("patches left", fontsize=11)
    figure.tight_layout()
    figure.savefig(out, dpi=80)


def before_after(file, mesh_id, folder):
    """A sample before and after, with its patches and those that gqe and best leave."""
    before = SAMPLES / file
    panels = [("before", before)]
    patches = []
    for method in ("gqe", "best"):
        after = folder / f"{method}.svg"
        (result,) = simplified(before, after, mesh_id, method=method)
        caption = f"{method}: {result.patches_after}, FLIP {result.error:.4f}"
        patches.append((caption, with_patches(after, folder / f"{method}-patches.svg")))
    original = with_patches(before, folder / "before-patches.svg", mesh_id)
    panels += [(f"{result.patches_before} patches", original), *patches, ("after best", after)]
    return side_by_side(painted(panels, folder, width=250))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--meshes", type=Path, required=True, help="folder of .hemesh files")
    parser.add_argument("--json", type=Path, help="runs made before; new ones are added")
    options = parser.parse_args()
    images = ROOT / "docs" / "images"
    known = json.loads(options.json.read_text()) if options.json and options.json.exists() else {}
    for _ in run_all(options.meshes, known):
        if options.json:
            options.json.write_text(json.dumps(known))
    for metric in METRICS:
        draw_curves(known[metric], metric, images / f"curves-{metric}.png")
    with tempfile.TemporaryDirectory() as folder:
        shown = [("fruit.svg", "pear"), ("face.svg", "face"), ("opacity.svg", "bubble")]
        sheets = [before_after(file, mesh, Path(folder)) for file, mesh in shown]
    below_each_other(sheets).save(images / "quality.png", optimize=True)


if __name__ == "__main__":
    main()
