"""Documents with meshes of equal rectangles, and the elements in them."""

import random_meshes  # noqa: F401, which knows where meshgrid is
from meshgrid import Mesh, colour, meshgradient

BOX = (10, 10, 40, 20)  # where meshes here lie: x, y, width, height
DOCUMENT = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
  xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" width="100" height="80">
<defs id="defs">{defs}</defs>
{body}
</svg>
"""
SHAPE = '<rect id="box" x="12" y="12" width="36" height="16" {}/>'
FILLED = SHAPE.format('fill="url(#m)"')
RED, GREEN, BLUE = "#c02010", "#10a030", "#2030b0"
#: Four colours that no line has in common, so that only a picture shows them.
MANY = [["#203040", "#d0c050"], ["#806020", "#40b0c0"]]


def lattice(colours, box=BOX, turn=1):
    """A mesh of equal rectangles, turned about 0, with these colours at its corners: texts, or pairs
    of a text and an opacity."""
    x, y, width, height = box
    rows, columns = len(colours) - 1, len(colours[0]) - 1
    corners = [
        [turn * complex(x + width * j / columns, y + height * i / rows) for j in range(columns + 1)]
        for i in range(rows + 1)
    ]
    return Mesh(corners, [[colour(*([c] if isinstance(c, str) else c)) for c in line] for line in colours])


def gradient(mesh, name="m", more=""):
    """The element of a mesh, or of a lattice of these colours."""
    mesh = mesh if isinstance(mesh, Mesh) else lattice(mesh)
    return meshgradient(mesh, name, f'gradientUnits="userSpaceOnUse" {more}')


def document(mesh, body=FILLED, defs="", more=""):
    """A document whose gradient `m` is this mesh, or a lattice of these colours."""
    return DOCUMENT.format(defs=gradient(mesh, more=more) + defs, body=body)
