"""Traces of pictures with few handles and many: none has slivers, and more handles are never worse."""

import base64
import io
import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from svg_meshes import Document, apply

import gradmesh

SAMPLES = Path(__file__).parents[3] / "samples"
DRAWINGS = {"pear": "fruit.svg", "face": "face.svg", "photo": "photo.svg"}
SIDE = 320
HANDLES = (200, 300, 600, 1000)


def picture_of(name):
    """A drawing as it is painted, or a photograph, SIDE pixels along its longer side."""
    if name in DRAWINGS:
        return Image.fromarray(gradmesh.render(gradmesh.load(SAMPLES / DRAWINGS[name]), name, SIDE))
    held = re.search(r"base64,([^\"]+)", (SAMPLES / "photographs" / f"{name}.svg").read_text())[1]
    photograph = Image.open(io.BytesIO(base64.b64decode(held)))
    photograph.thumbnail((SIDE, SIDE))
    return photograph


def patches_of(document):
    """The corners of the patches of the only mesh, in turn around each, in pixels of its picture."""
    read = Document(document)
    (path,) = [e for e in read.root.iter() if "url(#" in (e.get("style") or e.get("fill") or "")]
    points = apply(read.to_document(path), read.net(path))[::3, ::3]
    around = [points[:-1, :-1], points[:-1, 1:], points[1:, 1:], points[1:, :-1]]
    return np.stack(around, axis=-1).reshape(-1, 4)


def widths_and_angles(patches):
    """The width of each patch in the units of its corners, across whichever side it is least, and the corner
    of it that is nearest to 0 or 180 degrees."""
    sides = np.roll(patches, -1, axis=1) - patches
    opposite = [np.roll(patches, -k, axis=1) - patches for k in (2, 3)]
    away = [np.abs((sides.conj() * way).imag) / np.abs(sides) for way in opposite]
    back = np.roll(patches, 1, axis=1) - patches
    angles = np.abs(np.angle(back / sides, deg=True))
    return np.maximum(*away).min(axis=1), np.minimum(angles, 180 - angles).min(axis=1)


def share(are):
    return np.count_nonzero(are) / len(are)


@pytest.mark.full(all_but=1)
@pytest.mark.parametrize("name", ["pear", "face", "photo", "cat", "coffee"])
def test_more_handles_are_never_worse_and_no_patch_is_a_sliver(name, tmp_path):
    picture_of(name).save(tmp_path / "picture.png")
    errors = []
    for handles in HANDLES:
        traced = gradmesh.trace(tmp_path / "picture.png", handles=handles, epsilon=0)
        traced.document.save(tmp_path / "traced.svg")
        widths, angles = widths_and_angles(patches_of(tmp_path / "traced.svg"))
        assert share(widths < 1) <= 0.01 and share(angles < 5) <= 0.05, handles
        errors.append((traced.errors.rmse, traced.errors.flip))
    # A picture of hard outlines is as close as patches of a pixel let it be with 300 handles, and more only
    # change how lines happen to begin.
    chance = 1.03
    for (rmse, flip), (next_rmse, next_flip) in zip(errors, errors[1:]):
        assert next_rmse <= chance * rmse and next_flip <= chance * flip, errors
