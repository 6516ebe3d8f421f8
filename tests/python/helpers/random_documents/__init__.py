"""Random documents by seed: small pages with mesh gradients, written in the ways that people and programs write.

Each way is a line of a table: a function with its weight. Lengths are in hundredths of the page's side until
`Draft.length` writes them in the user units of the document.
"""

from .draft import Draft
from .file_bytes import ENCODINGS
from .markup import attributes, element, moved
from .paints import PAINTS, PARTS
from .places import PLACES
from .shapes import SHAPES
from .style_sheets import SHEETS

XLINK = 'xmlns:xlink="http://www.w3.org/1999/xlink"'
SVG = 'xmlns="http://www.w3.org/2000/svg"'


def document(seed):
    """The bytes of one document; the same for the same seed."""
    draft = Draft(seed)
    drawn = [draw(draft) for _ in range(draft.pick({1: 4, 2: 3, 3: 1}))]
    sheets = draft.pick(SHEETS)(draft) if draft.rules else ""
    body = f"{sheets}<defs>{''.join(draft.defs)}</defs>\n" + "\n".join(drawn)
    root = attributes({**draft.page.root, "id": "page"})
    return draft.pick(ENCODINGS)(draft, f"<svg {SVG} {XLINK} {root}>\n{body}\n</svg>\n")


def draw(draft):
    """One object in its place."""
    box = draft.box()
    tag, values, content = draft.pick(SHAPES)(draft, box)
    values["id"] = id = draft.name("o")
    if draft.maybe(0.2):
        values["transform"] = moved(draft, draft.length(box.x + box.width / 2), draft.length(box.y + box.height / 2))
    paint = draft.pick(PARTS)(draft, box)
    around = draft.pick(PAINTS)(draft, tag, values, paint)
    drawn = around.format(element(tag, values, content))
    return draft.pick(PLACES)(draft, drawn, id)
