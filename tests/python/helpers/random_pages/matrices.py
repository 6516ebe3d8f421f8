"""Matrices of six numbers, as PDF writes them, and numbers as text."""

import math

IDENTITY = 1, 0, 0, 1, 0, 0


def product(outer, inner):
    """The matrix that maps by `inner` first."""
    a, b, c, d, e, f = inner
    x, y, z, w, u, v = outer
    return (
        a * x + b * z, a * y + b * w, c * x + d * z, c * y + d * w, e * x + f * z + u, e * y + f * w + v
    )  # fmt: skip


def around(linear, x, y):
    """The matrix with these four numbers that leaves a point where it is."""
    a, b, c, d = linear
    return a, b, c, d, x - a * x - c * y, y - b * x - d * y


def turned(degrees):
    cos, sin = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return cos, sin, -sin, cos


def inverse(matrix):
    a, b, c, d, e, f = matrix
    n = a * d - b * c
    return d / n, -b / n, -c / n, a / n, (c * f - d * e) / n, (b * e - a * f) / n


def of_any(draft, x, y):
    """A matrix that moves what lies around a point a little."""
    if draft.maybe("stretched", 0.35):
        return around(draft.any({(0.8, 0, 0, 1.1): 2, (1, 0.2, -0.3, 0.9): 1}), x, y)
    return around(draft.any({turned(draft.between(-30, 30)): 3, (-1, 0, 0, 1): 1, (0.9, 0, 0, 0.9): 1}), x, y)


def numbers(*values):
    return " ".join(f"{value:.5f}".rstrip("0").rstrip(".") or "0" for value in values)
