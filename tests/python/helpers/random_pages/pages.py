"""The page itself, the tree in which it is, and the catalog."""

from . import layers
from .matrices import numbers

SIDE = 100


def file_of(draft, drawn):
    """Adds the objects of a file with one page that shows what was drawn. Returns the catalog."""
    values = []
    if draft.maybe("corner of the page", 0.2):
        box = -12, 7, SIDE - 12, SIDE + 17
    else:
        box = 0, 0, SIDE, SIDE
    if draft.maybe("crop box", 0.2):
        left, low, right, high = box
        values.append(f"/CropBox [{numbers(left + 8, low + 12, right - 3, high + 5)}]")
    if draft.maybe("rotated page", 0.25):
        values.append(f"/Rotate {draft.any({90: 3, 180: 1, 270: 1, -90: 1, 450: 0.5})}")
    if draft.maybe("user unit", 0.1):
        values.append(f"/UserUnit {draft.any({2: 1, 0.5: 1})}")
    if draft.annotations:
        values.append(f"/Annots [{' '.join(draft.annotations)}]")
    values.append(f"/Contents {contents(draft, drawn)}")
    inherited = [f"/MediaBox [{numbers(*box)}]", f"/Resources {draft.resources()}"]
    tree, page = draft.objects.reserve(), draft.objects.reserve()
    above = ""
    if draft.maybe("inherited by the page", 0.2):
        above = " ".join(inherited)
    else:
        values += inherited
    draft.objects.set(page, f"<< /Type /Page /Parent {tree} {' '.join(values)} >>")
    draft.objects.set(tree, f"<< /Type /Pages /Kids [{page}] /Count 1 {above} >>")
    return draft.objects.add(f"<< /Type /Catalog /Pages {tree} {layers.catalog_entry(draft)} >>")


def contents(draft, drawn):
    """The stream of a page's operators, or several that are read as one."""
    text = "\n".join(drawn)
    if not draft.maybe("several streams", 0.2):
        return draft.objects.stream(draft, "", text.encode("latin-1"))
    lines = text.split("\n")
    cuts = sorted(draft.chance.randrange(len(lines) + 1) for _ in range(2))
    parts = ["\n".join(lines[a:b]) for a, b in zip([0, *cuts], [*cuts, len(lines)])]
    refs = (draft.objects.stream(draft, "", part.encode("latin-1")) for part in parts)
    return f"[{' '.join(refs)}]"
