"""A rectangular gradient mesh: smooth sides, exact splits, local colours, and its `meshgradient`.

Points are complex numbers (x + 1j*y, y down); a colour is (r, g, b, a), each 0..1.
"""

from dataclasses import dataclass

TOP, RIGHT, BOTTOM, LEFT = range(4)


def mix(a, b, t):
    """a at t = 0, b at t = 1; numbers, points or tuples of numbers."""
    if isinstance(a, tuple):
        return tuple(x + (y - x) * t for x, y in zip(a, b))
    return a + (b - a) * t


def colour(text, alpha=1.0):
    """The colour written as `#rrggbb`."""
    return tuple(int(text[i : i + 2], 16) / 255 for i in (1, 3, 5)) + (alpha,)


def ramp(stops, t):
    """The piecewise linear interpolation of `stops`, pairs (position, value) in rising order."""
    if t <= stops[0][0]:
        return stops[0][1]
    for (t0, a), (t1, b) in zip(stops, stops[1:]):
        if t <= t1:
            return mix(a, b, (t - t0) / (t1 - t0))
    return stops[-1][1]


def falloff(distance):
    """1 at distance 0, falling smoothly to 0 at distance 1 and beyond."""
    return (1 - distance**2) ** 2 if abs(distance) < 1 else 0.0


def smooth_line(corners):
    """Corners and handles (3 n + 1 points) of the smooth curve through n + 1 corners.

    Handles are a third of their side long, as for Inkscape's smooth nodes, so that a short side
    next to a long one does not fold.
    """
    sides = [b - a for a, b in zip(corners, corners[1:])]
    tangents = [
        (a / abs(a) * abs(b) + b / abs(b) * abs(a)) / (abs(a) + abs(b))
        for a, b in zip(sides, sides[1:])
    ]
    if tangents:
        first, last = sides[0] / abs(sides[0]), sides[-1] / abs(sides[-1])
        tangents = [2 * first - tangents[0], *tangents, 2 * last - tangents[-1]]
    else:
        tangents = [sides[0] / abs(sides[0])] * 2
    line = [corners[0]]
    for i, side in enumerate(sides):
        reach = abs(side) / 3
        line += [
            corners[i] + tangents[i] * reach,
            corners[i + 1] - tangents[i + 1] * reach,
            corners[i + 1],
        ]
    return line


def split_cubic(p, t):
    """De Casteljau: the seven Bezier points of the two parts of the cubic p[0..3], cut at t."""
    a, b, c = mix(p[0], p[1], t), mix(p[1], p[2], t), mix(p[2], p[3], t)
    d, e = mix(a, b, t), mix(b, c, t)
    return [p[0], a, d, mix(d, e, t), e, c, p[3]]


def transposed(grid):
    return [list(line) for line in zip(*grid)]


class Mesh:
    """R x C patches on one lattice of Bezier points, as Inkscape holds its meshes.

    `points` is (3 R + 1) x (3 C + 1), `colours` (R + 1) x (C + 1), first index down the rows;
    `tensor` the (row, column) of the patches whose interior points are written.
    """

    def __init__(self, corners, colours):
        """Coons patches with smooth sides through `corners`, a (R + 1) x (C + 1) grid of points."""
        down = transposed([smooth_line(column) for column in transposed(corners)])
        self.points = []
        for i, row in enumerate(down):
            if i % 3:
                row = [point for handle in row for point in (handle, 0, 0)][:-2]
            else:
                row = smooth_line(row)
            self.points.append(row)
        self.colours = [list(row) for row in colours]
        self.tensor = set()
        for row in range(self.rows):
            for column in range(self.columns):
                self._fill_interior(row, column)

    @property
    def rows(self):
        return len(self.colours) - 1

    @property
    def columns(self):
        return len(self.colours[0]) - 1

    def corner(self, row, column):
        return self.points[3 * row][3 * column]

    def _fill_interior(self, row, column):
        """The interior points that make the patch a Coons patch (SVG 2 draft, section 14.2.4)."""
        for i in (1, 2):
            for j in (1, 2):

                def p(down, right):
                    # (0, 0) is the corner nearest to the interior point (i, j).
                    di = down if i == 1 else 3 - down
                    dj = right if j == 1 else 3 - right
                    return self.points[3 * row + di][3 * column + dj]

                self.points[3 * row + i][3 * column + j] = (
                    -4 * p(0, 0)
                    + 6 * (p(0, 1) + p(1, 0))
                    - 2 * (p(0, 3) + p(3, 0))
                    + 3 * (p(3, 1) + p(1, 3))
                    - p(3, 3)
                ) / 9

    def split_column(self, column, *parameters):
        """Inserts whole grid lines into `column`, at parameters 0..1 in rising order."""
        start = 0.0
        for parameter in parameters:
            t = (parameter - start) / (1 - start)
            first = 3 * column
            for line in self.points:
                line[first : first + 4] = split_cubic(line[first : first + 4], t)
            for line in self.colours:
                line.insert(column + 1, mix(line[column], line[column + 1], t))
            self.tensor = {(r, c) for r, c in self.tensor if c <= column} | {
                (r, c + 1) for r, c in self.tensor if c >= column
            }
            column, start = column + 1, parameter

    def split_row(self, row, *parameters):
        """Inserts whole grid lines into `row`, at parameters 0..1 in rising order."""
        self._transpose()
        self.split_column(row, *parameters)
        self._transpose()

    def _transpose(self):
        self.points = transposed(self.points)
        self.colours = transposed(self.colours)
        self.tensor = {(c, r) for r, c in self.tensor}

    def twist(self, row, column, turn):
        """Turns the interior points of one patch about their centre; `turn` is a complex factor."""
        where = [(3 * row + i, 3 * column + j) for i in (1, 2) for j in (1, 2)]
        centre = sum(self.points[i][j] for i, j in where) / 4
        for i, j in where:
            self.points[i][j] = centre + (self.points[i][j] - centre) * turn
        self.tensor.add((row, column))

    def tint(self, paint, weight):
        """Mixes the colour `paint` into every corner by `weight(point)`, 0..1."""
        for i, line in enumerate(self.colours):
            for j, old in enumerate(line):
                line[j] = mix(old, paint, weight(self.corner(i, j)))

    def dab(self, paint, centre, radius_x, radius_y, strength=1.0):
        """A soft elliptic brush: tints the corners around `centre`."""

        def weight(point):
            offset = point - centre
            return strength * falloff(abs(complex(offset.real / radius_x, offset.imag / radius_y)))

        self.tint(paint, weight)


@dataclass
class Notation:
    """How a mesh is spelled; every variant means the same to Inkscape."""

    relative: bool = True  # c and l, or C and L
    comma: bool = True  # "x,y" or "x y"
    closing_point: bool = True  # the last side of a patch names its known end, as Inkscape does
    style: bool = True  # colours in `style`, or in presentation attributes
    digits: int = 3


def number(value, digits):
    return f"{round(value, digits) + 0.0:.{digits}f}".rstrip("0").rstrip(".")


def _pair(point, notation):
    separator = "," if notation.comma else " "
    return number(point.real, notation.digits) + separator + number(point.imag, notation.digits)


def _rounded(point, digits):
    return complex(round(point.real, digits), round(point.imag, digits))


def _segment(side, closing, notation):
    """The path data of one side, four Bezier points."""
    rounding = 1e-9 * abs(side[3] - side[0])
    straight = all(abs(side[i] - mix(side[0], side[3], i / 3)) <= rounding for i in (1, 2))
    rounded = [_rounded(p, notation.digits) for p in side]
    letter, points = ("l", rounded[3:]) if straight else ("c", rounded[1:])
    if closing and not straight and not notation.closing_point:
        points = points[:2]
    if notation.relative:
        # Differences of rounded points: the errors of successive sides do not add up.
        points = [p - rounded[0] for p in points]
    else:
        letter = letter.upper()
    return " ".join([letter] + [_pair(p, notation) for p in points])


def _stop(path, rgba, notation):
    if rgba is None:
        return f'<stop path="{path}"/>'
    paint = "#" + "".join(f"{round(255 * min(max(v, 0), 1)):02x}" for v in rgba[:3])
    opacity = number(rgba[3], 3)
    if notation.style:
        return f'<stop path="{path}" style="stop-color:{paint};stop-opacity:{opacity}"/>'
    if opacity != "1":
        return f'<stop path="{path}" stop-color="{paint}" stop-opacity="{opacity}"/>'
    return f'<stop path="{path}" stop-color="{paint}"/>'


def _patch(mesh, row, column, notation):
    """One `meshpatch`: only the sides and colours that no earlier patch has given."""
    top, left = 3 * row, 3 * column
    points, colours = mesh.points, mesh.colours
    sides = {
        TOP: (points[top][left : left + 4], colours[row][column]),
        RIGHT: ([points[top + i][left + 3] for i in range(4)], colours[row][column + 1]),
        BOTTOM: (points[top + 3][left : left + 4][::-1], colours[row + 1][column + 1]),
        LEFT: ([points[top + 3 - i][left] for i in range(4)], colours[row + 1][column]),
    }
    if row > 0:
        del sides[TOP]
    if column > 0:
        del sides[LEFT]
    known = {TOP} if column > 0 else set()
    if row > 0:
        known.add(RIGHT)
    closing = LEFT if column == 0 else BOTTOM
    stops = [
        _stop(_segment(side, name == closing, notation), None if name in known else rgba, notation)
        for name, (side, rgba) in sides.items()
    ]
    tensor = ""
    if (row, column) in mesh.tensor:
        corners = [(0, 0, 1, 1), (0, 3, 1, 2), (3, 3, 2, 2), (3, 0, 2, 1)]
        offsets = [
            points[top + i][left + j] - points[top + ci][left + cj] for ci, cj, i, j in corners
        ]
        tensor = ' tensor="' + " ".join(_pair(p, Notation(digits=notation.digits)) for p in offsets)
        tensor += '"'
    return f"<meshpatch{tensor}>" + "".join(stops) + "</meshpatch>"


def meshgradient(mesh, name, attributes='gradientUnits="userSpaceOnUse"', notation=Notation()):
    """The `meshgradient` element with the id `name`."""
    start = mesh.points[0][0]
    x, y = number(start.real, notation.digits), number(start.imag, notation.digits)
    lines = [f'<meshgradient id="{name}" x="{x}" y="{y}" {attributes}>']
    for row in range(mesh.rows):
        lines.append("<meshrow>")
        lines += [_patch(mesh, row, column, notation) for column in range(mesh.columns)]
        lines.append("</meshrow>")
    lines.append("</meshgradient>")
    return "\n".join(lines)
