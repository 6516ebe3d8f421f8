"""Prints how far what gradmesh reads of random pages is from what poppler shows:

    python -m random_pages FIRST COUNT [--features "sh,form,clip to text"] [--folder FOLDER]

a line for each page: its seed, FLIP, whether it fails, whether a sentence is told, and what it has; then, for each
feature, how many of its pages fail. FOLDER keeps the pages and their pictures.
"""

import argparse
import collections
import tempfile
from pathlib import Path

import inkscape_harness
from pdf_painters import missing, outcomes

from . import FEATURES, page

LIMIT = 0.02


def main():
    parser = argparse.ArgumentParser(prog="python -m random_pages")
    parser.add_argument("first", type=int)
    parser.add_argument("count", type=int)
    parser.add_argument("--features", type=lambda text: text.split(","), default=FEATURES)
    parser.add_argument("--folder", type=Path)
    given = parser.parse_args()
    if reason := missing() or inkscape_harness.missing():
        parser.exit(1, reason + "\n")
    with tempfile.TemporaryDirectory() as temporary, inkscape_harness.Inkscape() as inkscape:
        folder = given.folder or Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        pages = {seed: page(seed, given.features) for seed in range(given.first, given.first + given.count)}
        paths = {seed: folder / f"page-{seed}.pdf" for seed in pages}
        for seed, path in paths.items():
            path.write_bytes(pages[seed].data)
        found = outcomes(inkscape, paths.values(), timeout=60 + 10 * given.count)
    print_table({seed: (pages[seed].features, found[paths[seed]]) for seed in pages})


def print_table(lines):
    count, failed = collections.Counter(), collections.Counter()
    for seed, (features, outcome) in lines.items():
        passes = outcome.passes(LIMIT)
        count.update(features)
        failed.update(() if passes else features)
        mark = "" if passes else "FAILS"
        told = "told" if outcome.told else ""
        print(f"{seed:6} {outcome.error:.4f} {mark:5} {told:4} {', '.join(sorted(features))}  {outcome.fault}")
    print(f"\n{sum(not outcome.passes(LIMIT) for _, outcome in lines.values())} of {len(lines)} fail")
    for feature in sorted(count, key=lambda each: -failed[each] / count[each]):
        print(f"{failed[feature]:6} of {count[feature]:4}  {feature}")


main()
