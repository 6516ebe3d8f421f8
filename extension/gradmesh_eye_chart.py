# SPDX-License-Identifier: GPL-2.0-or-later
"""The chart of Simplify by Eye: the error of a mesh by its handles, as samples of a picture."""

#: Pixels around a chart.
MARGIN = 6


class Chart:
    """Draws the curve of a mesh."""

    def __init__(self, width, height, is_dark, density=1):
        """density: how many pixels lines have for each on an ordinary screen."""
        self.width, self.height, self.density = width, height, density
        ground, self.ink, self.faint = (
            ((45, 45, 45), (120, 190, 255), (95, 95, 95))
            if is_dark
            else ((255, 255, 255), (0, 90, 180), (205, 205, 205))
        )
        self.dot = (230, 120, 0)
        self.samples = bytearray(bytes(ground) * (width * height))

    def draw(self, states, marks, status):
        if len(states) > 1:
            self._scale(states)
            for state in marks.values():
                x = round(self.x(states[state]))
                for y in range(MARGIN, self.height - MARGIN):
                    self.paint(x, y, self.faint)
            for one, other in zip(states, states[1:]):
                self.line(self.x(one), self.y(one), self.x(other), self.y(other))
            self.square(self.x(status), self.y(status))
        return self.width, self.height, bytes(self.samples)

    def _scale(self, states):
        self.most = max(states[0]["handles"], 1)
        self.least = min(states[-1]["handles"], self.most - 1)
        self.highest = max(state["error"] for state in states) or 1

    def x(self, state):
        share = (self.most - state["handles"]) / (self.most - self.least)
        return MARGIN + min(max(share, 0), 1) * (self.width - 2 * MARGIN - 1)

    def y(self, state):
        # By the root, as what is hardly seen is what is looked for.
        share = min(state["error"] / self.highest, 1) ** 0.5
        return self.height - MARGIN - 1 - share * (self.height - 2 * MARGIN - 1)

    def paint(self, x, y, color):
        if 0 <= x < self.width and 0 <= y < self.height:
            at = 3 * (y * self.width + x)
            self.samples[at : at + 3] = bytes(color)

    def line(self, x0, y0, x1, y1):
        steps = max(abs(round(x1) - round(x0)), abs(round(y1) - round(y0)), 1)
        for n in range(steps + 1):
            x, y = round(x0 + (x1 - x0) * n / steps), round(y0 + (y1 - y0) * n / steps)
            for across in range(2 * self.density):
                self.paint(x, y + across, self.ink)

    def square(self, x, y):
        reach = range(-3 * self.density, 3 * self.density + 1)
        for dx in reach:
            for dy in reach:
                self.paint(round(x) + dx, round(y) + dy, self.dot)
