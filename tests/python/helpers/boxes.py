"""Rectangles that lie along the axes."""

from typing import NamedTuple


class Box(NamedTuple):
    x: float
    y: float
    width: float
    height: float

    def grown(self, by):
        return Box(self.x - by, self.y - by, self.width + 2 * by, self.height + 2 * by)

    def point(self, right, up):
        """The point at these shares of the width and the height."""
        return self.x + right * self.width, self.y + up * self.height

    @property
    def corners(self):
        """The points with the least and the largest coordinates, as PDF writes a rectangle."""
        return self.x, self.y, self.x + self.width, self.y + self.height
