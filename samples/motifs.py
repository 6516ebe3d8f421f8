"""Pictures as artists draw them: a fruit, a face, a planet and a landscape."""

from math import cos, hypot, pi, sin, sqrt

from meshgrid import Mesh, Notation, colour, falloff, meshgradient, mix, ramp
from page import document, grid, linear, radial

PEAR = (
    "M 240,116 C 276,116 298,138 304,184 C 314,258 384,296 384,390 C 384,468 322,516 240,516 "
    "C 158,516 96,468 96,390 C 96,296 166,258 176,184 C 182,138 204,116 240,116 Z"
)


def fruit():
    """A pear, 7 x 6 patches refined to 11 x 12 for a highlight, a blush and a bruise."""
    half_widths = [(110, 34), (140, 56), (184, 71), (250, 97)]
    half_widths += [(310, 132), (390, 151), (460, 131), (522, 92)]
    tilts = [(116, -0.75), (184, -0.1), (250, -0.25), (310, -0.3), (390, 0.1), (516, 0.85)]
    light = (-0.50, -0.42, 0.76)

    def point(down, right):
        y, half = half_widths[round(7 * down)]
        bend = 22 * sin(pi * down) * cos(pi * (right - 0.5))
        return complex(240 + half * sin(pi * (right - 0.5)), y + bend)

    def shade(down, right):
        y, _ = half_widths[round(7 * down)]
        side = 0.97 * sin(pi * (right - 0.5))
        tilt = ramp(tilts, y)
        front = sqrt(1 - side * side) * cos(tilt)
        lit = max(0, side * light[0] + tilt * light[1] + front * light[2])
        skin = mix(colour("#c6cf3a"), colour("#f0cf45"), down)
        deep = mix(colour("#5d7a1c"), colour("#8a5a14"), down)
        glow = 0.25 * max(0, side - 0.55)
        return mix(mix(deep, skin, 0.12 + 0.9 * lit), colour("#ffd98a"), glow)

    mesh = Mesh(grid(7, 6, point), grid(7, 6, shade))
    mesh.dab(colour("#d9532b"), 330 + 400j, 95, 120, 0.75)
    for column in (5, 4, 3, 2, 1, 0):
        mesh.split_column(column, 0.5)
    for row in (6, 5, 4, 3):
        mesh.split_row(row, 0.5)
    mesh.dab(colour("#fffbe6"), 182 + 372j, 38, 62, 1.0)
    mesh.dab(colour("#fff3c0"), 208 + 200j, 24, 44, 0.7)
    mesh.dab(colour("#8c4a1d"), 290 + 458j, 26, 20, 0.7)
    defs = [
        meshgradient(mesh, "pear-mesh"),
        radial("table", (240, 300, 240, 300), (0, "#fdf3df", 1), (1, "#e3c9a0", 1)),
        radial("shade", (262, 508, 176, 36), (0, "#4a2b10", 0.65), (0.6, "#4a2b10", 0.3), (1, "#4a2b10", 0)),
        linear("leaf-green", (0, "#8fb93c", 1), (1, "#3f6f1d", 1)),
    ]
    body = f"""<rect id="background" width="480" height="600" style="fill:url(#table)"/>
<ellipse id="shadow" cx="262" cy="508" rx="176" ry="36" style="fill:url(#shade)"/>
<path id="stem" style="fill:#6b4420"
   d="M 234,128 C 232,98 240,72 258,48 L 272,54 C 256,78 250,100 250,128 Z"/>
<path id="leaf" style="fill:url(#leaf-green)"
   d="M 250,96 C 270,58 322,40 372,58 C 350,100 300,120 250,96 Z"/>
<path id="pear" d="{PEAR}" style="fill:url(#pear-mesh) #d8b93c;stroke:none"/>"""
    return document(480, 600, "Pear", "\n".join(defs), body)


FACE_COLUMNS = [-172, -140, -112, -84, -52, -24, 0, 24, 52, 84, 112, 140, 172]
FACE_ROWS = [70, 194, 218, 246, 274, 287, 304, 372, 403, 415, 429, 447, 466, 552]


def face():
    """A sleeping face: the lines of the mesh follow brows, lids, nose and lips."""
    skin, warm, deep = colour("#f2c29b"), colour("#ffe0bf"), colour("#b5654a")

    def point(down, right):
        i, j = round(13 * down), round(12 * right)
        x, y = FACE_COLUMNS[j], FACE_ROWS[i]
        eye = falloff((abs(x) - 68) / 62) if 1 <= i <= 7 else 0
        y += [0, -12, -14, -15, -8, 15, 15, 0, 0, 0, 0, 0, 0, 0][i] * eye
        if i in (7, 8, 9, 11, 12):  # the lips taper towards the corners of the mouth
            tapers = [(0, 0), (24, 0.2), (52, 1), (84, 0.9), (112, 0.4), (140, 0)]
            taper = ramp(tapers, abs(x))
            y += (429 - y) * taper * (0.1 if i == 7 else 0.45 if i in (8, 12) else 0.75)
        y += [0, 0, 0, 0, 0, 0, 0, 6, 3, 3, 7, 12, 8, 0][i] * falloff(x / 84)
        narrow = ramp([(70, 0.94), (300, 1.0), (430, 0.86), (552, 0.66)], FACE_ROWS[i])
        return complex(260 + x * narrow, y)

    def shade(down, right):
        p = point(down, right) - 260
        rim = min(1, hypot(p.real / 172, (p.imag - 300) / 262))
        return mix(mix(warm, skin, rim), deep, 0.75 * rim**4 + 0.1 * max(0, p.real / 172))

    mesh = Mesh(grid(13, 12, point), grid(13, 12, shade))
    colours = mesh.colours

    def touch(row, columns, paint, strength):
        for j in columns:
            colours[row][j] = mix(colours[row][j], colour(paint), strength)

    for eye in (range(2, 5), range(8, 11)):
        touch(2, eye, "#5b3322", 0.75)
        touch(3, eye, "#fff0dc", 0.45)
        touch(4, eye, "#8d6fb0", 0.6)
        touch(5, eye, "#241420", 0.95)
        touch(6, eye, "#f7cfae", 0.6)
    mesh.dab(colour("#ef6f6a"), 158 + 372j, 62, 66, 0.75)
    mesh.dab(colour("#ef6f6a"), 362 + 372j, 62, 66, 0.75)
    for row in range(3, 7):
        touch(row, [6], "#fff3df", 0.5)
        touch(row, [7], "#b87350", 0.3)
    touch(7, [6], "#fff6e8", 0.8)
    touch(7, [5, 7], "#a95a45", 0.45)
    touch(9, range(4, 9), "#c8324a", 0.85)
    touch(10, range(4, 9), "#6d1024", 0.9)
    touch(11, range(4, 9), "#e8566b", 0.85)
    defs = [
        meshgradient(mesh, "face-mesh", notation=Notation(relative=False)),
        linear("throat", (0.3, "#7d3f36", 1), (1, "#c98263", 1)),
        radial("night", (260, 310, 260, 310), (0, "#3f5d8c", 1), (1, "#16233f", 1)),
    ]
    body = """<rect id="background" width="520" height="620" style="fill:url(#night)"/>
<path id="hair" style="fill:#2b1a22"
   d="M 260,36 C 420,36 486,150 480,330 C 478,440 500,520 476,620
      L 44,620 C 20,520 42,440 40,330 C 34,150 100,36 260,36 Z"/>
<path id="neck" style="fill:url(#throat)"
   d="M 204,470 L 316,470 C 316,560 340,590 400,620 L 120,620 C 180,590 204,560 204,470 Z"/>
<path id="face" style="fill:url(#face-mesh) #f2c29b;stroke:none"
   d="M 260,76 C 366,76 420,168 418,290 C 416,392 372,548 260,548
      C 148,548 104,392 102,290 C 100,168 154,76 260,76 Z"/>
<path id="fringe" style="fill:#2b1a22"
   d="M 96,300 C 84,150 150,60 260,60 C 370,60 436,150 424,300
      C 410,214 372,160 300,136 C 230,190 130,190 96,300 Z"/>"""
    return document(520, 620, "Sleeping face", "\n".join(defs), body)


def ellipse():
    """A striped planet: the mesh is in fractions of the ellipse's box, and is wider than it."""
    bands = "#8a6a4e #c9a77c #efe0c2 #b9774a #e8cfa4 #fff3d9".split()
    bands += "#c98b5b #9a5f3c #e2c293 #b98d63 #6f563f".split()

    def point(down, right):
        wave = 0.012 * sin(7 * right + 9 * down)
        # Seen from slightly above, the bands sag; least near the pole, where they lie close.
        sag = 0.8 * right * (1 - right) * (0.5 - abs(down - 0.5)) * (1 if down > 0.2 else 0.4)
        border = down in (0, 1) or right in (0, 1)
        return complex(-0.03 + 1.06 * right, -0.05 + 1.10 * down + (0 if border else wave + sag))

    def shade(down, right):
        side, tall = 2 * right - 1, 2 * down - 1
        lit = 1 - 0.42 * (side + 0.45) ** 2 - 0.28 * tall**2
        band = colour(bands[round(10 * down)])
        return mix(colour("#1c1420"), band, max(0, lit))

    mesh = Mesh(grid(10, 8, point), grid(10, 8, shade))
    for column in (4, 3, 2, 1):
        mesh.split_column(column, 0.5)
    for row in (7, 6):
        mesh.split_row(row, 0.5)
    mesh.dab(colour("#d2452a"), 0.36 + 0.75j, 0.17, 0.10, 1.0)
    mesh.dab(colour("#ffb27a"), 0.36 + 0.75j, 0.07, 0.05, 0.7)
    stars = "".join(
        f'<circle id="star{k}" cx="{(137 * k + 71) * k % 560}" '
        f'cy="{((89 * k + 31) * k + 17) % 520}" r="{0.6 + k % 4 * 0.35:.2f}"/>'
        for k in range(70)
    )
    units = 'gradientUnits="objectBoundingBox"'
    defs = [
        meshgradient(mesh, "planet-mesh", units, Notation(relative=False, comma=False, digits=5)),
        radial("space", (280, 260, 280, 260), (0, "#27305c", 1), (1, "#070914", 1)),
    ]
    body = f"""<rect id="background" width="560" height="520" style="fill:url(#space)"/>
<g id="stars" style="fill:#ffffff;fill-opacity:0.8">{stars}</g>
<ellipse id="planet" cx="280" cy="260" rx="200" ry="188" style="fill:url(#planet-mesh) #b9774a"/>"""
    return document(560, 520, "Planet", "\n".join(defs), body)


def ridge(x, height, waves):
    return height + sum(size * sin(x / length + phase) for size, length, phase in waves)


def photo():
    """A sunset in 20 x 20 sampled patches; their lines follow the ridges and gather at the sun."""
    sun = 436 + 168j

    def far(x):
        return ridge(x, 236, [(26, 74, 0.8), (11, 31, 2.0), (5, 15, 0.3)])

    def near(x):
        return ridge(x, 296, [(24, 120, 3.6), (6, 37, 1.0)])

    def gather(offset, amount, reach):
        return amount * sin(pi * offset / reach) * falloff(offset / (2 * reach))

    def column(right):
        x = 640 * right
        return x - gather(x - sun.real, 22, 120) if 0 < right < 1 else x

    def point(down, right):
        x, k = column(right), round(20 * down)
        knots = [(0, 0), (9, far(x)), (10, far(x) + 5), (12, near(x)), (13, near(x) + 5)]
        knots += [(14, 352), (15, 356), (20, 480)]
        y = ramp(knots, k)
        if 0 < k < 9:
            y += 5 * sin(x / 90 + k) * falloff((k - 4) / 4)
            y -= gather(y - sun.imag, 7, 56) * falloff((x - sun.real) / 300)
        return complex(x, y)

    def sky(p):
        heights = zip((0, 110, 190, 270), map(colour, ("#2c3e78", "#8f6a9e", "#f0996a", "#ffd38a")))
        high = ramp(list(heights), p.imag)
        cloud = max(0, sin(p.imag / 13 + 1.4 * sin(p.real / 120)) * sin(p.real / 95 + p.imag / 40))
        high = mix(high, colour("#f7b7a0"), 0.55 * cloud * falloff((p.imag - 100) / 110))
        glow = mix(high, colour("#ffcf70"), 0.8 * falloff(abs(p - sun) / 250))
        return mix(glow, colour("#fffbe0"), min(1, 1.5 * falloff(abs(p - sun) / 46)))

    def shade(down, right):
        p, k = point(down, right), round(20 * down)
        warm = falloff((p.real - sun.real) / 300)
        if k <= 9:
            return sky(p)
        if k <= 12:
            hill = mix(colour("#6a5585"), colour("#d98766"), warm)
            return mix(hill, colour("#b08a9a"), (k - 10) * 0.3)
        if k <= 14:
            return mix(colour("#241c38"), colour("#5e3036"), 0.7 * warm)
        depth = (k - 15) / 5
        sea = mix(colour("#e8a27c"), colour("#28305c"), 0.25 + 0.75 * depth)
        ripple = 0.5 + 0.5 * sin(2.4 * k + p.real / 60)
        path = falloff((p.real - sun.real) / (60 + 60 * depth)) * (0.55 + 0.45 * ripple)
        return mix(mix(sea, colour("#f7c3a0"), 0.25 * ripple), colour("#fff2b8"), path)

    mesh = Mesh(grid(20, 20, point), grid(20, 20, shade))
    body = '<rect id="photo" width="640" height="480" style="fill:url(#photo-mesh) #e8a27c"/>'
    return document(640, 480, "Sunset", meshgradient(mesh, "photo-mesh"), body)
