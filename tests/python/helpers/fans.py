"""Documents with a fan: patches around one point, as in the backgrounds of icons."""

import cmath
from math import pi, tan

CENTRE, RADIUS = complex(100, 100), 150.0
OVERS = """<circle cx="100" cy="104" r="62" fill="#e8c060"/>
<rect x="30" y="150" width="140" height="26" rx="8" fill="#803020"/>"""


class Fan:
    """`rings` x `rays` patches; the corners on the rays `clear` have opacity 0. With `turns` above 1
    the last patches lie over the first. Rows are rings; their inner sides have no length at the
    centre."""

    def __init__(self, rings=8, rays=8, clear=(1, 4, 6), turns=1.0):
        self.rings, self.rays, self.clear, self.turns = rings, rays, clear, turns

    def _corner(self, ring, ray):
        angle = 2j * pi * self.turns * ray / self.rays
        return CENTRE + RADIUS * ring / self.rings * cmath.exp(angle)

    def _colour(self, ring, ray):
        out = ring / self.rings
        shade = 20 * cmath.exp(2j * pi * ray / self.rays).real
        mixed = (round(a + (b - a) * out + shade) for a, b in ((60, 120), (90, 180), (170, 230)))
        opacity = 0 if ray % self.rays in self.clear else 1
        return "stop-color:#%02x%02x%02x;stop-opacity:%d" % (*mixed, opacity)

    def _side(self, start, end):
        a, b = self._corner(*start), self._corner(*end)
        (ring, ray), (other_ring, other_ray) = start, end
        if ring != other_ring:
            return _path("L", b)
        reach = 4 / 3 * tan(2 * pi * self.turns * (other_ray - ray) / self.rays / 4)
        return _path("C", a + 1j * reach * (a - CENTRE), b - 1j * reach * (b - CENTRE), b)

    def gradient(self, name="m"):
        rows = ""
        for ring in range(self.rings):
            rows += "<meshrow>"
            for ray in range(self.rays):
                corners = [(ring, ray), (ring, ray + 1), (ring + 1, ray + 1), (ring + 1, ray)]
                rows += "<meshpatch>"
                for side in range(1 if ring else 0, 3 if ray else 4):
                    given = (side == 0 and ray) or (side == 1 and ring)
                    style = "" if given else f' style="{self._colour(*corners[side])}"'
                    path = self._side(corners[side], corners[(side + 1) % 4])
                    rows += f'<stop path="{path}"{style}/>'
                rows += "</meshpatch>"
            rows += "</meshrow>"
        start = f'x="{CENTRE.real:g}" y="{CENTRE.imag:g}"'
        return f'<meshgradient id="{name}" gradientUnits="userSpaceOnUse" {start}>{rows}</meshgradient>'

    def document(self, shape='<rect {} x="4" y="4" width="192" height="192" rx="36"/>', over=OVERS):
        """An icon of 200 x 200: `shape`, painted by the fan, and other objects over it."""
        painted = shape.format('id="fan" style="fill:url(#m)"')
        return (
            '<svg xmlns="http://www.w3.org/2000/svg" width="200" height="200">'
            f"<defs>{self.gradient()}</defs>{painted}{over}</svg>\n"
        )


def _path(letter, *points):
    return letter + " " + " ".join(f"{p.real:.6g},{p.imag:.6g}" for p in points)
