#!/usr/bin/env python3
"""Writes the sample documents: what artists draw with Inkscape's mesh gradient tool.

    make_samples.py [FOLDER]      (default: the folder of this script)

The same bytes on every run. Most meshes start coarse and are refined the only way the mesh tool
knows, by whole rows and columns, before small details are coloured in: so large parts of them
carry no information, and small parts must be kept.
"""

import sys
from pathlib import Path

from motifs import ellipse, face, fruit, photo
from variants import opacity, smooth, stroke, tensor, transformed, two

SAMPLES = [fruit, face, ellipse, photo, opacity, stroke, two, transformed, tensor, smooth]


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for sample in SAMPLES:
        (folder / f"{sample.__name__}.svg").write_bytes(sample().encode())


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent)
