"""What published documents draw in the place of meshes, with all else that objects have."""

import pytest

from lattices import BLUE, FILLED, GREEN, MANY, RED, SHAPE, document, gradient, lattice
from published_copy import Copy, pixels

ONE_COLOUR, LINE, SECOND = [[RED] * 2] * 2, [[RED, BLUE]] * 2, [[BLUE, RED], [GREEN, RED]]

pytestmark = pytest.mark.module_only

#: Beside the gradient `m`, of many colours: gradients of one colour, of colours along a line, and of
#: many again, one that has its rows from `m`, and what objects have beside their paint.
DEFS = gradient(ONE_COLOUR, "one") + gradient(LINE, "line") + gradient(SECOND, "n")
DEFS += """<meshgradient id="linked" x="10" y="10" xlink:href="#m" gradientUnits="userSpaceOnUse"/>
<filter id="blur"><feGaussianBlur stdDeviation="1"/></filter>
<clipPath id="clip"><circle cx="30" cy="20" r="9"/></clipPath>
<clipPath id="part"><rect x="20" y="14" width="8" height="8"/></clipPath>
<mask id="mask"><circle cx="30" cy="20" r="9" fill="#fff"/></mask>
<style>.painted { fill: url(#m); opacity: 0.5 }</style>
"""
TAKEN = ["box-picture1", "box-shape2", "box-outline1", "box-gradient1", "box-picture", "box-shape"]

#: Drawings in which nothing but the shape cuts, or the mesh too.
IMAGE = "[image #2b373f 11 11 38 18]"
CUT = "[image #22323f 9 9 42 22 clip-path=<path 10 10 50 30>]"
TEXT = "text x=12 y=28 font-size=18 style=font-size:18"
RECT = "clip-path=<rect 12 12 36 16>"
WHOLE, BOX_IMAGE = "box picture 76 x 36: ", f"g#box {RECT} {IMAGE}"
DOT_IMAGE = "g#dot clip-path=<circle cx=30 cy=20 r=4> [image #646d4c 25 15 10 10]"

#: By what they show: objects, and what becomes of them.
CASES = {
    "a stroke is masked by itself": (
        SHAPE.format('style="fill:none;stroke:url(#m);stroke-width:3;stroke-dasharray:4 2"'),
        "box picture 84 x 44: g#box "
        f"mask=<rect 12 12 36 16 style=fill:none;stroke:#ffffff;stroke-dasharray:4 2;stroke-width:3> {CUT}",
    ),
    "text cuts": (
        '<text id="box" x="12" y="28" font-size="18" fill="url(#m)">ab<tspan id="t">c</tspan></text>',
        f"box picture 84 x 44: g#box clip-path=<{TEXT} 'ab' [tspan#t 'c']> {CUT}",
    ),
    "where letters are is not known, so the outline of a mesh of one colour cuts too": (
        '<text id="box" x="12" y="28" font-size="18" fill="url(#one)">abc</text>',
        f"box picture 84 x 44: g#box clip-path=<{TEXT} 'abc'> {CUT.replace('#22323f', RED)}",
    ),
    "a stroke is above the fill": (
        SHAPE.format('style="fill:url(#m);stroke:url(#n);stroke-width:4"'),
        f"box picture 76 x 36, box picture 84 x 44: g#box [g {RECT} {IMAGE}, "
        f"g mask=<rect 12 12 36 16 style=fill:none;stroke:#ffffff;stroke-width:4> {CUT.replace('#22323f', '#2131ad')}]",
    ),
    "a plain stroke stays a stroke": (
        SHAPE.format('style="fill:url(#m);stroke:#112233;stroke-width:4;paint-order:normal"'),
        f"{WHOLE}g#box [g {RECT} {IMAGE}, rect 12 12 36 16 "
        "style=fill:none;paint-order:normal;stroke:#112233;stroke-width:4]",
    ),
    "a plain stroke below stays there": (
        SHAPE.format('style="fill:url(#m);stroke:#112233;stroke-width:4;paint-order:stroke"'),
        f"{WHOLE}g#box [rect 12 12 36 16 style=fill:none;paint-order:stroke;stroke:#112233;stroke-width:4, "
        f"g {RECT} {IMAGE}]",
    ),
    "of what copies show nothing is known but the shape": (
        f'<defs>{FILLED}</defs><use id="u" xlink:href="#box" x="3"/><use id="v" xlink:href="#box" y="30"/>',
        f"{WHOLE}defs [{BOX_IMAGE}], use#u x=3 #box, use#v y=30 #box",
    ),
    "a symbol": (
        f'<symbol id="s">{FILLED}</symbol><use id="u" xlink:href="#s"/>',
        f"{WHOLE}symbol#s [{BOX_IMAGE}], use#u #s",
    ),
    "a group hands the mesh on": (
        f"""<g id="g" fill="url(#m)">{SHAPE.format("")}<circle id="dot" cx="30" cy="20" r="4"/>
        <path id="plain" d="M 1,1 9,9 1,9" fill="red"/></g>""",
        f"box picture 76 x 36, dot picture 20 x 20: g#g style=fill:none [{BOX_IMAGE}, {DOT_IMAGE}, "
        "path#plain 1 1 9 9 fill=red]",
    ),
    "a group hands one colour on": (
        f'<g id="g" fill="url(#one)">{SHAPE.format("")}</g>',
        f"box colour: g#g style=fill:none [rect#box 12 12 36 16 style=fill:{RED};fill-opacity:1]",
    ),
    "what a style sheet says is said once": (
        SHAPE.format('class="painted"'),
        f"{WHOLE}g#box style=opacity:0.5 {RECT} {IMAGE}",
    ),
    "a transform stays with the object": (
        SHAPE.format('fill="url(#m)" transform="rotate(20 30 20)"'),
        f"{WHOLE}g#box transform=rotate(20 30 20) {RECT} {IMAGE}",
    ),
    "an opacity stays with the object": (
        SHAPE.format('fill="url(#m)" opacity="0.5"'),
        f"{WHOLE}g#box style=opacity:0.5 {RECT} {IMAGE}",
    ),
    "a filter stays with the object": (
        SHAPE.format('fill="url(#m)" filter="url(#blur)"'),
        f"{WHOLE}g#box style=filter:url(#blur) [g {RECT} {IMAGE}]",
    ),
    "another clip path stays with the object": (
        SHAPE.format('fill="url(#m)" clip-path="url(#clip)"'),
        f"box picture 40 x 36: g#box clip-path=url(#clip) [g {RECT} [image #4f5744 20 11 20 18]]",
    ),
    "a mask stays with the object": (
        SHAPE.format('fill="url(#m)" mask="url(#mask)"'),
        f"box picture 40 x 36: g#box mask=url(#mask) [g {RECT} [image #4f5744 20 11 20 18]]",
    ),
    "all of these stay with the object": (
        SHAPE.format(
            'fill="url(#m)" transform="rotate(20 30 20)" opacity="0.5" filter="url(#blur)" '
            'clip-path="url(#clip)" mask="url(#mask)"'
        ),
        "box picture 40 x 36: g#box transform=rotate(20 30 20) clip-path=url(#clip) mask=url(#mask) "
        f"style=filter:url(#blur);opacity:0.5 [g {RECT} [image #4f5744 20 11 20 18]]",
    ),
    "the opacity of a fill is that of the group": (
        SHAPE.format('style="fill:url(#m);fill-opacity:0.5;opacity:0.5"'),
        f"{WHOLE}g#box style=opacity:0.25 {RECT} {IMAGE}",
    ),
    "a title stays": (
        '<rect id="box" width="40" height="30" fill="url(#m)"><title id="t">A box</title></rect>',
        "box picture 64 x 44: g#box clip-path=<rect width=40 height=30> [title#t 'A box', "
        "image #22323f 9 9 32 22 clip-path=<path 10 10 50 30>]",
    ),
    "an object without an id gets one": (
        '<rect width="40" height="30" fill="url(#m)"/>',
        "rect1 picture 64 x 44: g clip-path=<rect width=40 height=30> "
        "[image #22323f 9 9 32 22 clip-path=<path 10 10 50 30>]",
    ),
    "one mesh on two objects": (
        FILLED + '<circle id="dot" cx="30" cy="20" r="4" fill="url(#m)"/>',
        f"box picture 76 x 36, dot picture 20 x 20: {BOX_IMAGE}, {DOT_IMAGE}",
    ),
    "rows from another gradient": (SHAPE.format('fill="url(#linked)"'), WHOLE + BOX_IMAGE),
    "what names a mesh and is not seen gets the colour for programs without meshes": (
        f"""{FILLED}<g id="group" fill="url(#n) #abcdef"><rect id="inner" x="1" fill="red"/></g>
        <g id="empty" style="stroke:url(#n)"/>""",
        f"{WHOLE}{BOX_IMAGE}, g#group style=fill:#abcdef [rect#inner x=1 fill=red], g#empty style=stroke:none",
    ),
    "scripts of Inkscape that paint meshes go and others stay": (
        f"""{FILLED}<script id="mesh_polyfill">1</script><script id="mesh_polyfill2">2</script>
        <script id="mine">3</script>""",
        f"{WHOLE}{BOX_IMAGE}, script#mine '3'",
    ),
    "ids that are taken stay": (
        FILLED + "".join(f'<rect id="{name}"/>' for name in TAKEN),
        WHOLE + ", ".join([BOX_IMAGE, *(f"rect#{name}" for name in TAKEN)]),
    ),
    "what is clipped away is not in the picture": (
        f'<g id="g" clip-path="url(#part)">{FILLED}</g>',
        f"box picture 20 x 20: g#g clip-path=url(#part) [g#box {RECT} [image #505744 19 13 10 10]]",
    ),
}
for name, first, corner in (("one", RED, RED), ("line", "#bb2015", "#bf2011"), ("m", "#2b373f", "#22323f")):
    # Where the mesh is not Inkscape shows nothing: so its outline cuts.
    CASES[f"a shape that reaches beyond the mesh {name}"] = (
        f'<rect id="box" x="12" y="12" width="60" height="16" fill="url(#{name})"/>',
        "box picture 80 x 36: g#box clip-path=<rect 12 12 60 16> "
        f"[image {first} 11 11 40 18 clip-path=<path 10 10 50 30>]",
    )
    for x, y in ((70, 50), (20, 32), (51.5, 12)):
        CASES[f"a shape at {x}, {y} beside the mesh {name} shows nothing"] = (
            f'<rect id="box" x="{x}" y="{y}" width="9" height="9" fill="url(#{name})"/>',
            f"box picture 4 x 4: g#box clip-path=<rect {x} {y} 9 9> "
            f"[image {corner} 9 9 2 2 clip-path=<path 10 10 50 30>]",
        )


@pytest.mark.parametrize("name", CASES)
def test_what_else_paints_and_how(name):
    body, drawing = CASES[name]
    assert Copy(document(MANY, body, DEFS)).drawing == drawing


def test_a_picture_of_a_stroke_is_no_larger_than_the_stroke():
    mesh = lattice(MANY, box=(-500, -500, 2000, 2000))
    stroke = SHAPE.format('style="fill:none;stroke:url(#m);stroke-width:3"')
    # The shape of 36 x 16, and around it 6 for mitres and a margin of 1, in two pixels each.
    assert [(told.width, told.height) for told in Copy(document(mesh, stroke)).told] == [(100, 60)]


def folded(*patches):
    """What is published of a mesh with these paths of stops, whose shape is larger than it."""
    colours = [["#f00", "#ff0", "#0a0", "#00f"], [None, "#fff", "#808"]]
    stops = [
        "".join(f'<stop path="{path}"' + (f' stop-color="{c}"/>' if c else "/>") for path, c in zip(patch, of))
        for patch, of in zip(patches, colours)
    ]
    mesh = f"""<meshgradient id="folded" x="30" y="30" gradientUnits="userSpaceOnUse"><meshrow>
    {"".join(f"<meshpatch>{patch}</meshpatch>" for patch in stops)}</meshrow></meshgradient>"""
    return Copy(document(MANY, '<rect id="box" width="100" height="80" fill="url(#folded)"/>', mesh))


def test_a_folded_mesh_is_cut_by_the_outlines_of_its_patches():
    """Its second patch lies over its first, beyond the mesh's outline and back."""
    copy = folded(["l 60,0", "l 0,40", "l -60,0", "l 0,-40"], ["l -40,10", "l 0,20", "l 40,10"])
    (path,) = copy.named(copy.image, "clip-path")
    assert path.get("d").count("M") == 2
    assert copy.image.get("width") == "62"


def test_a_folded_patch_ends_with_its_picture():
    """It paints beyond its own outline."""
    copy = folded(["c -40,30 -50,-20 40,0", "c -50,10 10,10 0,20", "c 40,0 -30,-50 -40,0", "c 10,-60 0,0 0,-20"])
    assert copy.image.get("clip-path") is None
    assert set(pixels(copy.image)[..., 3].flat) == {0, 255}
