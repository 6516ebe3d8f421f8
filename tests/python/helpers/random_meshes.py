"""Random rectangular meshes by seed, in kinds that differ in what a painter may get wrong."""

import cmath
import sys
from math import pi

from built import SAMPLES

sys.path.append(str(SAMPLES))  # after the tests' own modules of the same names

from meshgrid import Mesh, Notation, meshgradient, mix  # noqa: E402

SIDE = 40.0  # of a patch, before it is shaken


class Kind:
    """`noise`: how far corners are moved, and handles twice as far, in sides of a patch. `inner`:
    how far interior points are, with `tensor` written. `straight`: how likely a side is a line.
    `most`: rows, and columns."""

    def __init__(
        self,
        noise=0.15,
        inner=None,
        opacity=False,
        smooth=False,
        transformed=False,
        straight=0.0,
        most=4,
    ):
        self.noise, self.inner, self.opacity = noise, inner, opacity
        self.smooth, self.transformed = smooth, transformed
        self.straight, self.most = straight, most

    def mesh(self, chance, rows=None, columns=None):
        rows, columns = (count or chance.randint(1, self.most) for count in (rows, columns))
        corners = [
            [complex(SIDE * j, SIDE * i) + _shake(chance, self.noise) for j in range(columns + 1)]
            for i in range(rows + 1)
        ]
        colours = [[self._colour(chance) for _ in range(columns + 1)] for _ in range(rows + 1)]
        mesh = Mesh(corners, colours)
        for i, line in enumerate(mesh.points):
            for j in range(len(line)):
                if (i % 3 == 0) != (j % 3 == 0):
                    line[j] += _shake(chance, 2 * self.noise)
                elif self.inner and i % 3 and j % 3:
                    line[j] += _shake(chance, self.inner)
        if self.straight:
            self._straighten(mesh, chance)
        if self.inner:
            mesh.tensor = {(row, column) for row in range(rows) for column in range(columns)}
        return mesh

    def _straighten(self, mesh, chance):
        points = mesh.points
        for i in range(0, len(points), 3):
            for j in range(0, len(points[0]), 3):
                for down, right in ((0, 1), (1, 0)):
                    inside = i + 3 * down < len(points) and j + 3 * right < len(points[0])
                    if not inside or chance.random() >= self.straight:
                        continue
                    a, b = points[i][j], points[i + 3 * down][j + 3 * right]
                    for k in (1, 2):
                        points[i + k * down][j + k * right] = mix(a, b, k / 3)

    def _colour(self, chance):
        return (*(chance.random() for _ in range(3)), chance.random() if self.opacity else 1.0)

    def gradient(self, chance, name, attributes=""):
        """A `meshgradient` element in user space, with the id `name`."""
        smooth = 'type="bicubic" ' if self.smooth else ""
        attributes = f'gradientUnits="userSpaceOnUse" {smooth}{attributes}'
        notation = Notation(relative=chance.random() < 0.5, digits=4)
        return meshgradient(self.mesh(chance), name, attributes, notation)

    def matrix(self, chance):
        """The linear part of an affine map (a, b, c, d): turned, sheared, scaled, mirrored."""
        if not self.transformed:
            return (1.0, 0.0, 0.0, 1.0)
        turn = cmath.exp(2j * pi * chance.random())
        x, y = chance.uniform(0.3, 3) * turn, chance.uniform(0.3, 3) * turn * 1j
        y = y * chance.choice((1, -1)) + x * chance.uniform(-0.5, 0.5)
        return (x.real, x.imag, y.real, y.imag)


def _shake(chance, reach):
    return SIDE * complex(chance.uniform(-reach, reach), chance.uniform(-reach, reach))


KINDS = {
    "Coons": Kind(),
    "tensor": Kind(inner=0.15),
    "bicubic": Kind(smooth=True),
    "opacity": Kind(opacity=True, inner=0.1),
    "folds": Kind(noise=0.6, inner=0.8),
    "transforms": Kind(inner=0.1, transformed=True),
}
