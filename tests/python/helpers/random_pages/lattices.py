"""Where the patches of a mesh lie: rows and columns of them in a box."""

from typing import NamedTuple


class Lattice(NamedTuple):
    rows: int
    columns: int
    net: list  #: rows of control points, three to a patch and one more

    @property
    def corners(self):
        return {
            (i, j): self.net[3 * i][3 * j] for i in range(self.rows + 1) for j in range(self.columns + 1)
        }

    def patch(self, i, j):
        """The sixteen control points of a patch, each with its place in the lattice."""
        return [[((i + k / 3, j + n / 3), self.net[3 * i + k][3 * j + n]) for n in range(4)] for k in range(4)]


def lattice_of(draft, box, is_curved):
    chance, rows, columns = draft.chance, draft.any({1: 3, 2: 3, 3: 1}), draft.any({1: 3, 2: 3, 3: 1})
    cell = min(box.width / columns, box.height / rows)
    shake = draft.any({0: 2, 0.05: 2, 0.15: 1}) * cell
    if draft.maybe("fold", 0.12):
        shake = 0.7 * cell
    bend = draft.any({0: 1, 0.1: 3}) * cell if is_curved else 0

    def at(i, j, by):
        x, y = box.point(j / (3 * columns), i / (3 * rows))
        return x + chance.uniform(-by, by), y + chance.uniform(-by, by)

    corners = {(i, j): at(3 * i, 3 * j, shake) for i in range(rows + 1) for j in range(columns + 1)}
    if draft.maybe("collapsed side", 0.1):
        i = chance.randrange(rows)
        corners[i, 0] = corners[i + 1, 0]
    if draft.maybe("mirrored", 0.2):
        corners = {(i, columns - j): point for (i, j), point in corners.items()}
    net = [[None] * (3 * columns + 1) for _ in range(3 * rows + 1)]
    for i in range(3 * rows + 1):
        for j in range(3 * columns + 1):
            if i % 3 == 0 or j % 3 == 0:
                net[i][j] = on_side(corners, i, j, lambda: chance.uniform(-bend, bend))
    has_own = is_curved and draft.maybe("inner points", 0.25)
    by = draft.any({0.1: 2, 0.5: 1}) * cell if has_own else 0
    for i in range(rows):
        for j in range(columns):
            add_inner(net, 3 * i, 3 * j, lambda: chance.uniform(-by, by))
    return Lattice(rows, columns, net)


def on_side(corners, i, j, bend):
    if i % 3 == 0 and j % 3 == 0:
        return corners[i // 3, j // 3]
    along = (0, 1) if i % 3 == 0 else (1, 0)
    share = (j if i % 3 == 0 else i) % 3 / 3
    start = i // 3, j // 3
    a, b = corners[start], corners[start[0] + along[0], start[1] + along[1]]
    return tuple(x + share * (y - x) + bend() for x, y in zip(a, b))


def add_inner(net, i, j, move):
    """Puts in the four inner points of the patch that begins at a corner: those of a Coons patch, moved."""
    for k, n in ((1, 1), (1, 2), (2, 1), (2, 2)):
        near_i, near_j = (0, 3) if k == 1 else (3, 0), (0, 3) if n == 1 else (3, 0)

        def p(row, column, near_i=near_i, near_j=near_j):
            rows = {0: near_i[0], 1: k, 3: near_i[1]}
            columns = {0: near_j[0], 1: n, 3: near_j[1]}
            return net[i + rows[row]][j + columns[column]]

        net[i + k][j + n] = tuple(
            (
                -4 * p(0, 0)[c] + 6 * (p(0, 1)[c] + p(1, 0)[c]) - 2 * (p(0, 3)[c] + p(3, 0)[c])
                + 3 * (p(3, 1)[c] + p(1, 3)[c]) - p(3, 3)[c]
            ) / 9 + move()
            for c in (0, 1)
        )  # fmt: skip
