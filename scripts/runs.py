"""Simplifications on one mesh after the other, for the tables and pictures in docs/. Needs a build in build/."""

import json
import os
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(Path(os.environ.get("GRADMESH_BUILD", ROOT / "build")) / "python"))

import gradmesh  # noqa: E402

PAPER = json.loads((ROOT / "scripts" / "paper_numbers.json").read_text())
#: The last is ours alone.
METHODS = ["random", "grid", "dual-grid", "motorcycle", "gqe", "gqe1", "best"]
#: These follow the seed. In the paper motorcycle does not, whose grid method starts at a corner left open.
BY_CHANCE = {"random", "grid", "dual-grid", "motorcycle"}
PRICED_REGIONS = {"gqe", "gqe1", "best"}


class Bench:
    """Runs on the only mesh of a file, or on the one with the id `ids`, by one metric; regions are
    priced once for each epsilon asked."""

    def __init__(self, file, metric, resolution, folder, ids=()):
        self.document = gradmesh.load(file)
        self.ids = ids
        self.common = {"metric": metric, "resolution": resolution}
        self.prices = Path(folder) / f"{file.stem}-{ids or 'mesh'}-{metric}.json"

    def price(self, epsilon):
        """Prices all regions up to epsilon; the seconds that took."""
        start = time.monotonic()
        gradmesh.analyze(self.document, self.prices, self.ids, epsilon=epsilon, **self.common)
        return time.monotonic() - start

    def run(self, method, epsilon, **options):
        if method in PRICED_REGIONS:
            options.update(omega=PAPER["omega"], load_analysis=self.prices)
        if method == "motorcycle":
            options.update(kappa=PAPER["kappa"])
        (result,) = gradmesh.simplify(
            self.document,
            self.ids,
            method=method,
            epsilon=epsilon,
            preview=True,
            **options,
            **self.common,
        )
        if not result.error <= epsilon:
            raise SystemExit(f"{method}: error {result.error} is above epsilon {epsilon}")
        return result
