"""Pages as Inkscape paints them, and where two of them differ."""

import numpy as np
from PIL import Image

import gradmesh

NEAR_OUTLINE = 3  # pixels


class Page:
    """The page of a document as Inkscape paints it."""

    def __init__(self, inkscape, svg, folder, pixels):
        self.inkscape, self.folder, self.pixels = inkscape, folder, pixels
        self.dpi = 96.0
        size = self.paint(svg).shape[:2]
        self.dpi *= pixels / max(size)
        self.before = self.paint(svg)
        self.meets_outline = self.outlines(svg)

    def paint(self, svg, actions=()):
        png = self.folder / "page.png"
        png.unlink(missing_ok=True)
        self.inkscape.run_actions(
            svg,
            [*actions, "export-area-page", f"export-dpi:{self.dpi}", f"export-filename:{png}", "export-do"],
        )
        if actions and not png.exists():  # of what shows nothing Inkscape writes nothing
            return np.zeros((*self.before.shape[:2], 4), np.uint8)
        with Image.open(png) as picture:
            picture = picture.convert("RGBA")
        if actions:
            return np.array(picture)
        white = Image.new("RGBA", picture.size, "white")
        white.alpha_composite(picture)
        return np.array(white.convert("RGB"))

    def outlines(self, svg):
        """Pixels at the outline of an object that a mesh paints."""
        near = np.zeros(self.before.shape[:2], bool)
        for mesh in gradmesh.load(svg).meshes:
            alone = self.paint(svg, [f"export-id:{mesh.id}", "export-id-only"])
            painted = alone[..., 3] > 0
            for axis in (0, 1):
                changes = np.diff(painted, axis=axis, prepend=False)
                near |= changes
        return grown(near, NEAR_OUTLINE)

    def errors(self, after):
        return np.where(self.meets_outline, 0, gradmesh.differences(self.before, after))


def grown(mask, by):
    result = mask.copy()
    for y in range(-by, by + 1):
        for x in range(-by, by + 1):
            result |= np.roll(mask, (y, x), (0, 1))
    return result


def worst_window(errors, side):
    """The largest mean in a window, and the window's middle (x, y)."""
    sums = np.pad(errors.astype(float).cumsum(0).cumsum(1), ((1, 0), (1, 0)))
    means = (sums[side:, side:] - sums[:-side, side:] - sums[side:, :-side] + sums[:-side, :-side]) / side**2
    y, x = np.unravel_index(means.argmax(), means.shape)
    return means[y, x], (x + side // 2, y + side // 2)
