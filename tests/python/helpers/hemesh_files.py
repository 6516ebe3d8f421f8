"""Writes .hemesh files of our own: grids that are exact parts of one bicubic patch."""

import pytest

from built import ROOT

SHARED = ROOT.parent / "shared" / "meshes"
of_the_authors = pytest.mark.skipif(
    not SHARED.is_dir(), reason="the authors' meshes are not in ../shared/meshes"
)


class Surface:
    """The patch over u (down) and v (to the right), both 0 to 1; its values are (x, y, r, g, b)."""

    def at(self, u, v):
        return (
            2 * v + 0.2 * u * u,
            u + 0.15 * v * v - 0.1 * u * v,
            u * u * (3 - 2 * u),
            0.2 + 0.6 * v**3,
            0.9 - 0.5 * u * u - 0.3 * u * v,
        )

    def along_u(self, u, v):
        return (0.4 * u, 1 - 0.1 * v, 6 * u * (1 - u), 0, -u - 0.3 * v)

    def along_v(self, u, v):
        return (2, 0.3 * v - 0.1 * u, 0, 1.8 * v * v, -0.3 * u)

    #: The mixed derivative, everywhere the same.
    TWIST = (0, -0.1, 0, 0, -0.3)


def numbers(values):
    return " ".join(map(repr, values))


def grid(rows, columns, without=(), surface=Surface()):
    """The surface cut into rows x columns patches, some of them left out, as a .hemesh text."""
    cells = [(i, j) for i in range(rows) for j in range(columns) if (i, j) not in without]
    number = {cell: i for i, cell in enumerate(cells)}
    handles, own = [], {}

    def halfedge(i, j, side):
        return 4 * number[i, j] + side if (i, j) in number else -1

    def add_handle(edge, vector, step):
        handles.append(f"{edge} {numbers(x * step for x in vector)}")
        return len(handles) - 1

    def add_curve(derivative, step, start, end, there, back):
        """The handles of a curve; the two half-edges on it get them, each its own first."""
        if there < 0 and back < 0:
            return
        first = add_handle(there if there >= 0 else back, derivative(*start), step)
        second = add_handle(back if back >= 0 else there, derivative(*end), -step)
        own[there], own[back] = (first, second), (second, first)

    for i in range(rows + 1):
        for j in range(columns):
            ends = (i / rows, j / columns), (i / rows, (j + 1) / columns)
            sides = halfedge(i, j, 0), halfedge(i - 1, j, 2)
            add_curve(surface.along_v, 1 / columns, *ends, *sides)
    for i in range(rows):
        for j in range(columns + 1):
            ends = (i / rows, j / columns), ((i + 1) / rows, j / columns)
            sides = halfedge(i, j - 1, 1), halfedge(i, j, 3)
            add_curve(surface.along_u, 1 / rows, *ends, *sides)

    halfedges, points = [], {}
    for (i, j), patch in number.items():
        corners = (i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)
        across = (i - 1, j, 2), (i, j + 1, 3), (i + 1, j, 0), (i, j - 1, 1)
        for side, (a, b) in enumerate(corners):
            edge = 4 * patch + side
            values = surface.at(a / rows, b / columns)
            origin, _ = points.setdefault((a, b), (len(points), f"{numbers(values[:2])} {edge}"))
            before, after = 4 * patch + (side + 3) % 4, 4 * patch + (side + 1) % 4
            # Derivatives along the sides of the patch: every other corner turns one of them.
            step = (-1) ** side / rows / columns
            twist = numbers(x * step for x in surface.TWIST)
            h = numbers(own[edge])
            halfedges.append(
                f"0 1 {twist} {numbers(values[2:])} {h} "
                f"{halfedge(*across[side])} {before} {after} {patch} -1 0 {h} {origin}"
            )

    patches = [str(4 * patch) for patch in number.values()]
    positions = [text for _, text in points.values()]
    counts = numbers(len(kind) for kind in (positions, handles, patches, halfedges))
    return "\n".join(["HEMESH", counts, *positions, *handles, *patches, *halfedges]) + "\n"
