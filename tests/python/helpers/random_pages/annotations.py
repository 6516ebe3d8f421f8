"""Annotations: what a page shows above its content."""

from boxes import Box

from . import layers
from .matrices import numbers, of_any
from .paints import sh

HIDDEN, PRINT, NO_VIEW = 1 << 1, 1 << 2, 1 << 5


def add_annotation(draft, box):
    """Adds an annotation whose appearance is a form with a mesh, in coordinates of its own."""
    inner = Box(0, 0, 60, 40)
    shown = appearance(draft, inner)
    values = f"/N {shown}"
    state = ""
    if draft.maybe("annotation states", 0.3):
        names = ["On", "Off"]
        draft.chance.shuffle(names)
        values = f"/N << /{names[0]} {shown} /{names[1]} {appearance(draft, inner)} >>"
        state = f"/AS /{draft.any({'On': 2, 'Off': 1})}"
    flags = 0
    if draft.maybe("hidden annotation", 0.15):
        flags |= HIDDEN
    if draft.maybe("unseen annotation", 0.15):
        flags |= NO_VIEW
    if draft.maybe("printed annotation", 0.4):
        flags |= PRINT
    layer = f"/OC {layers.optional_content(draft)}" if draft.maybe("layer of an annotation", 0.15) else ""
    ref = draft.objects.add(
        f"<< /Type /Annot /Subtype /Stamp /Rect [{numbers(*box.corners)}] /F {flags} {state} {layer}"
        f" /AP << {values} >> >>"
    )
    draft.annotations.append(ref)


def appearance(draft, box):
    matrix = ""
    if draft.maybe("annotation matrix", 0.4):
        matrix = f"/Matrix [{numbers(*of_any(draft, *box.point(0.5, 0.5)))}]"
    return draft.form(box, lambda: sh(draft, box.grown(-2)), matrix)
