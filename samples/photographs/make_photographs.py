#!/usr/bin/env python3
"""Writes the two sample photographs that scikit-image's pictures are made into, with an outline each.

    make_photographs.py [FOLDER]      (default: the folder of this script)

The pictures are those of skimage.data; README.md says whose they are.
"""

import sys
from pathlib import Path

from outlined import closed_path, outlined_photograph
from PIL import Image
from skimage import data

CUP = [290 + 20j, 345 + 30j, 388 + 62j, 404 + 106j, 392 + 152j, 352 + 188j]
CUP += [292 + 204j, 236 + 191j, 196 + 158j, 177 + 112j, 190 + 64j, 232 + 31j]
EYE = [275 + 140j, 325 + 155j, 370 + 197j, 381 + 246j, 358 + 290j, 315 + 309j]
EYE += [262 + 302j, 213 + 272j, 190 + 228j, 195 + 182j, 228 + 150j]


def smooth_path(nodes):
    """Returns the path data of a smooth closed path through the nodes, each tangent half of the way past its node."""
    beside = zip(nodes[-1:] + nodes[:-1], nodes[1:] + nodes[:1])
    return closed_path(nodes, [(after - before) / 2 for before, after in beside])


def coffee():
    """Returns the document of an espresso cup seen from above, the outline round its opening."""
    return outlined_photograph(Image.fromarray(data.coffee()), "Coffee", "cup", smooth_path(CUP), "#00e5ff")


def cat():
    """Returns the document of a part of a cat's face, enlarged three times, the outline round the eye."""
    image = Image.fromarray(data.chelsea()).crop((75, 40, 275, 190)).resize((600, 450), Image.BICUBIC)
    return outlined_photograph(image, "Cat", "eye", smooth_path(EYE), "#ff2fd0")


def main(folder):
    """Writes the two documents into the folder."""
    for sample in (coffee, cat):
        (folder / f"{sample.__name__}.svg").write_text(sample())


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent)
