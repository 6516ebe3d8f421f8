"""Pages of PDF as poppler paints them, and as Inkscape paints what gradmesh reads of them."""

import json
import shutil
import subprocess
import xml.etree.ElementTree as ET
from typing import NamedTuple

import numpy as np
from PIL import Image

from built import gradmesh as run
from pictures import on_white

import gradmesh  # which is where `built` has said

#: Along the longer side of what is painted. Inkscape paints edges of meshes in whole pixels, so that pictures of half
#: that side are compared.
PIXELS = 600
#: So far off is what is only rounded in another way.
LEVELS = 6
#: How much larger poppler paints a page once more that differs by more than so much.
LARGER, ENOUGH = 8, 0.01
NO_MESH = "there is no gradient mesh on its pages."


def missing():
    """Why pages cannot be painted by poppler here; empty if they can."""
    return "" if shutil.which("pdftoppm") else "not installed: pdftoppm (poppler-utils)"


class Read(NamedTuple):
    """What gradmesh makes of a page: a document, or a sentence why there is none, and what it tells beside that."""

    svg: object
    refusal: str
    left_out: list


class Outcome(NamedTuple):
    error: float  #: mean FLIP of both pictures
    told: list  #: sentences
    fault: str  #: what went wrong otherwise

    def passes(self, limit):
        return not self.fault and (self.error <= limit or bool(self.told))


def read(pdf):
    svg = pdf.with_suffix(".svg")
    svg.unlink(missing_ok=True)
    done = run("convert", pdf, svg)
    if done.returncode == 1:
        return Read(None, done.stderr.strip(), [])
    assert done.returncode == 0, f"{done.returncode}: {done.stderr}"
    return Read(svg, "", json.loads(run("info", "--json", pdf).stdout)["left_out"])


def painted_by_poppler(pdf, times=1):
    """The picture, `times` as large."""
    png = pdf.with_name(f"{pdf.stem}-poppler-{times}.png")
    how = ["-q", "-png", "-cropbox", "-singlefile", "-aaVector", "yes" if times == 1 else "no"]
    subprocess.run(
        ["pdftoppm", *how, "-scale-to", str(times * PIXELS), pdf, png.with_suffix("")], check=True, timeout=60
    )
    return png


def dots_per_inch(svg):
    """With which a document that gradmesh wrote is as large as it is painted here."""
    root = ET.parse(svg).getroot()
    return 96 * PIXELS / max(float(root.get(side).removesuffix("px")) for side in ("width", "height"))


def outcomes(inkscape, paths, timeout=600):
    """Of each PDF how much its two pictures differ, all painted by one Inkscape."""
    found, reads, pictures, dpi = {}, {}, {}, {}
    for path in paths:
        try:
            reads[path] = read(path)
        except (AssertionError, subprocess.TimeoutExpired) as error:
            found[path] = Outcome(1, [], f"gradmesh did not end well: {error}")
            continue
        if svg := reads[path].svg:
            pictures[svg], dpi[svg] = svg.with_suffix(".png"), dots_per_inch(svg)
    unpainted = inkscape.export_pages(pictures, dpi, timeout)
    for path, its in reads.items():
        if its.svg is None:
            says_nothing = its.refusal.endswith(NO_MESH)
            found[path] = Outcome(error_of(path, None), [] if says_nothing else [its.refusal], "")
        elif its.svg in unpainted:
            found[path] = Outcome(1, its.left_out, unpainted[its.svg])
        else:
            found[path] = Outcome(error_of(path, pixels(pictures[its.svg])), its.left_out, "")
    return found


def error_of(pdf, picture):
    """How much a picture, or an empty page, differs from what poppler shows.

    Poppler paints patches of the types 6 and 7 as small polygons which overlap by a pixel. Where they are translucent
    that is seen, the less the larger the picture is. So a page that differs is compared with a larger one.
    """
    for times in (1, LARGER):
        reference = pixels(painted_by_poppler(pdf, times), times)
        found = difference(reference, np.full_like(reference, 255) if picture is None else picture)
        if found <= ENOUGH:
            break
    return found


def pixels(png, times=1):
    with Image.open(on_white(png)) as picture:
        return np.array(picture.convert("RGB").reduce(2 * times))


def difference(before, after):
    """The mean FLIP of two pictures. A pixel does not count where each of them has a colour that the other one has
    there or beside it, or between such colours: edges lie a pixel off, or are smoothed."""
    height, width = (min(sides) for sides in zip(before.shape[:2], after.shape[:2]))
    for picture in (before, after):
        assert picture.shape[0] - height < 3 and picture.shape[1] - width < 3, (before.shape, after.shape)
    before, after = before[:height, :width], after[:height, :width]
    same = is_near(before, after) & is_near(after, before)
    return gradmesh.compare(before, np.where(same[..., None], before, after))


def is_near(picture, other):
    """Whether each pixel is among what the other picture has there and in the eight pixels around."""
    ends = np.pad(other.astype(int), ((1, 1), (1, 1), (0, 0)), mode="edge")
    height, width = picture.shape[:2]
    around = [ends[y : y + height, x : x + width] for y in range(3) for x in range(3)]
    low, high = np.minimum.reduce(around), np.maximum.reduce(around)
    return ((picture >= low - LEVELS) & (picture <= high + LEVELS)).all(axis=2)
