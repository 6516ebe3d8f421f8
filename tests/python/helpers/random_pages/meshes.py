"""Shadings of the types 4 to 7: where their patches lie, and the bytes that say so."""

from typing import NamedTuple

from .color_spaces import space
from .functions import FUNCTIONS
from .lattices import lattice_of
from .matrices import numbers


class Record(NamedTuple):
    """What follows a flag: points, and as which of all corners each colour is counted."""

    flag: int
    points: list
    corners: list


class Mesh(NamedTuple):
    type: int
    records: list
    columns: int  #: of vertices
    box: tuple  #: left, right, bottom, top


def free_triangles(draft, net):
    corners = net.corners

    def strip(i):
        """The triangles between two rows of corners, each of which goes on from the one before."""
        zigzag = [(i + k, j) for j in range(net.columns + 1) for k in (0, 1)]
        return [Record(0 if n < 3 else 1, [corners[at]], [at]) for n, at in enumerate(zigzag)]

    def fan(i, j):
        cycle = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)]
        for n, at in enumerate(cycle):
            yield Record(0 if n < 3 else 2, [corners[at]], [at])

    def separate(i, j):
        a, b, c, d = (i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)
        for at in draft.any({(a, b, c, c, d, a): 1, (a, b, d, b, d, c): 1}):
            yield Record(0, [corners[at]], [at])

    records = []
    if draft.maybe("flags", 0.3):
        for i in range(net.rows):
            records += strip(i)
        return records
    for i in range(net.rows):
        for j in range(net.columns):
            records += (fan if draft.maybe("flags", 0.5) else separate)(i, j)
    return records


def lattice_of_triangles(draft, net):
    return [
        Record(0, [net.corners[i, j]], [(i, j)]) for i in range(net.rows + 1) for j in range(net.columns + 1)
    ]


def coons_patches(draft, net):
    return patches(draft, net, has_inner=False)


def tensor_patches(draft, net):
    return patches(draft, net, has_inner=True)


TYPES = {free_triangles: 2, lattice_of_triangles: 2, coons_patches: 3, tensor_patches: 3}
#: Poppler's triangles overlap so that it is seen wherever they are translucent, its patches hardly in a large picture.
PATCHES = {coons_patches: 1, tensor_patches: 1}
NUMBERS = {free_triangles: 4, lattice_of_triangles: 5, coons_patches: 6, tensor_patches: 7}


def around(patch):
    """The twelve outer points of a patch of four rows, in the order of PDF."""
    top, last = patch[0], patch[3]
    return [*top, patch[1][3], patch[2][3], *reversed(last), patch[2][0], patch[1][0]]


def turns(patch):
    """A patch from each of its corners in both directions."""
    for turned in (patch, [list(row) for row in zip(*patch)]):
        for _ in range(4):
            yield turned
            turned = [list(row) for row in zip(*turned[::-1])]


def patches(draft, net, has_inner):
    """Each patch from any of its corners, and where it may go on from a side of the last one, at times so."""
    records, last = [], None
    cells = [(i, j) for i in range(net.rows) for j in range(net.columns)]
    if draft.maybe("flags", 0.3):
        cells = [(i, j if i % 2 == 0 else net.columns - 1 - j) for i, j in cells]
    for i, j in cells:
        choices = list(turns(net.patch(i, j)))
        flag, patch = 0, draft.chance.choice(choices)
        if last and draft.maybe("flags", 0.7):
            for f in (1, 2, 3):
                side = [last[(3 * f + k) % 12] for k in range(4)]
                for choice in choices:
                    if [at for at, _ in choice[0]] == [at for at, _ in side]:
                        flag, patch = f, choice
        outer = around(patch)
        points = outer[4 if flag else 0 :]
        if has_inner:
            points = [*points, patch[1][1], patch[1][2], patch[2][2], patch[2][1]]
        corners = [outer[k][0] for k in (0, 3, 6, 9)][2 if flag else 0 :]
        records.append(Record(flag, [point for _, point in points], corners))
        last = outer
    return records


def mesh(draft, box):
    """A mesh that fills a box, more or less."""
    kind = draft.pick(PATCHES if draft.is_seen_through else TYPES)
    net = lattice_of(draft, box, is_curved=NUMBERS[kind] > 5)
    records = kind(draft, net)
    points = [point for record in records for point in record.points]
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return Mesh(NUMBERS[kind], records, net.columns + 1, (min(xs), max(xs), min(ys), max(ys)))


class Bits:
    def __init__(self):
        self.text = ""

    def add(self, value, low, high, count):
        most = (1 << count) - 1
        share = (value - low) / (high - low) if high > low else 0
        self.text += f"{round(min(max(share, 0), 1) * most):0{count}b}"

    def fill_byte(self):
        self.text += "0" * (-len(self.text) % 8)

    def bytes(self):
        self.fill_byte()
        return int("1" + self.text, 2).to_bytes(len(self.text) // 8 + 1, "big")[1:] if self.text else b""


def shading(draft, mesh, of=None):
    """The object of a shading with the patches of a mesh, in a colour space, by default any one."""
    own = of or space(draft)
    ranges, function = own.ranges, ""
    if not of and draft.chance.random() < 0.25:
        made = draft.pick({no_function: 0.01, **FUNCTIONS})(draft, own.ranges)
        if made:
            ranges, function = [(0, 1)], f"/Function {made}"
    coordinate = draft.any({8: 0.3, 12: 0.3, 16: 3, 24: 2, 32: 2})
    component, flag = draft.any({4: 0.2, 8: 4, 12: 0.3, 16: 2}), draft.any({2: 1, 4: 1, 8: 4})
    left, right, bottom, top = mesh.box
    colors, bits = {}, Bits()
    for record in mesh.records:
        if mesh.type != 5:
            bits.add(record.flag, 0, (1 << flag) - 1, flag)
        for x, y in record.points:
            bits.add(x, left, right, coordinate)
            bits.add(y, bottom, top, coordinate)
        for at in record.corners:
            color = colors.setdefault(at, [draft.between(*each) for each in ranges])
            for value, (low, high) in zip(color, ranges):
                bits.add(value, low, high, component)
        bits.fill_byte()
    decode = numbers(*mesh.box, *(end for each in ranges for end in each))
    values = (
        f"/ShadingType {mesh.type} /ColorSpace {own.text} /BitsPerCoordinate {coordinate}"
        f" /BitsPerComponent {component} /Decode [{decode}] {function}"
    )
    values += f" /VerticesPerRow {mesh.columns}" if mesh.type == 5 else f" /BitsPerFlag {flag}"
    if draft.maybe("shading box" if not of else "box of a mask", 0.07):
        width, height = right - left, top - bottom
        values += f" /BBox [{numbers(left + width / 4, bottom, right, top - height / 4)}]"
    return draft.objects.stream(draft, values, bits.bytes())


def no_function(draft, ranges):
    return ""


def any_shading(draft, box):
    return shading(draft, mesh(draft, box))
