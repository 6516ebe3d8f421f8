"""What Inkscape paints of unusual meshes, gradmesh reads and paints the same."""

import re
import xml.etree.ElementTree as ET
from typing import NamedTuple

import pytest

from in_inkscape import inkscape, needs  # noqa: F401

pytest.importorskip("PIL.Image")
np = pytest.importorskip("numpy")

import pictures
from PIL import Image
from svg_meshes import SVG, read_net

gradmesh = pytest.importorskip("gradmesh", reason="the compiled package is not there")

pytestmark = needs()

PIXELS = 96
USER = 'gradientUnits="userSpaceOnUse"'


class Case(NamedTuple):
    body: str  #: what the document holds beside the rectangle that the mesh "m" paints
    shape: str  #: the same mesh in plain words: rows of `<meshrow>`, from (10, 10)


def stop(path, paint='stop-color="#808080"'):
    return f"<stop {paint}/>" if path is None else f'<stop path="{path}" {paint}/>'


def row(*patches):
    return f"<meshrow>{''.join(f'<meshpatch>{patch}</meshpatch>' for patch in patches)}</meshrow>"


def mesh(rows, attributes=f'{USER} x="10" y="10"', name="meshgradient", id="m"):
    return f'<{name} id="{id}" {attributes}>{rows}</{name}>'


CURVE, RIGHT, LEFT = "c 10,-5 20,5 40,0", "l 0,40", "l 0,-40"
COLORED = [f'stop-color="{color}"' for color in ("#ff0000", "#00ff00", "#0000ff", "#ffff00")]


def one(top=COLORED[0], left=LEFT, path=CURVE, bottom="c -10,5 -20,-5 -40,0", tensor=""):
    """One patch; the paint of its first stop, the paths of some."""
    stops = (stop(path, top), stop(RIGHT, COLORED[1]), stop(bottom, COLORED[2]))
    patch = "".join(stops) + (stop(left, COLORED[3]) if left != "no stop" else "")
    return row(patch).replace("<meshpatch>", f"<meshpatch {tensor}>") if tensor else row(patch)


def two(more="", last="l -20,0"):
    """Two patches side by side."""
    first = "".join(map(stop, ("l 20,0", RIGHT, "l -20,0", LEFT), COLORED))
    second = stop("l 20,0", COLORED[3]) + stop(RIGHT, COLORED[3]) + stop(last, COLORED[1])
    return row(first, second + more)


def below(*stops):
    """A patch above another one."""
    first = map(stop, ("l 40,0", "l 0,20", "l -40,0", "l 0,-20"), COLORED)
    return row("".join(first)) + row("".join(stops))


def renamed(text, **names):
    for old, new in names.items():
        text = text.replace(f"<{old}", f"<{new}").replace(f"</{old}", f"</{new}")
    return text


def linked(order, attributes='x="10" y="10" xlink:href="#g"', rows=one(), other=""):
    """A mesh whose href leads to another gradient, before or after it."""
    target = f'<linearGradient id="g" {USER} {other}><stop stop-color="red"/></linearGradient>'
    parts = [target, mesh(rows, attributes)]
    return "".join(parts if order == "before" else reversed(parts))


# Those that Inkscape 1.2 does not know are no cases: gradmesh reads what 1.5 knows, and refuses the rest.
COLORS = [
    "none", "inherit", "currentColor", "#f0f", "#ff00ffx", "MAGENTA", "magenta ham", "lightgrey",
    "rgb(255,0,255)", "rgb( 255 , 0 , 255 )", "rgb(127.6,-20,300)", "rgb(33.3%,0%,100%)",
    "rgb(255,0,255) ham", "hsl(300,100%,50%)", "hsl(-60,50%,40%)", "#ff00ff icc-color(x,1,2)", "",
]  # fmt: skip
IN_ATTRIBUTES = ["white ", " white", "white\n", " #ff00ff "]
IN_STYLES = [
    "stop-color:#ff00ff !important", "stop-color:#ff00ff;stop-color:ham",
    "stop-color:#ff00ff;stop-color:inherit", "color:#ff00ff;stop-color:currentColor",
    "color:inherit;stop-color:currentColor",
    "stop-color:red;stop-opacity:.5;stop-opacity:ham",
]  # fmt: skip
PAINTS = [
    "",
    'stop-color="#00ffff" style="stop-color:#ff00ff"',
    'stop-color="#ff00ff" style="stop-color:ham"',
    'stop-color="#ff00ff" style="stop-color:none"',
    'stop-color="#ff00ff" style="stop-color:inherit"',
    'stop-color="currentColor" color="#ff00ff"', 'class="good" stop-color="#00ffff"',
    'class="bad" stop-color="#ff00ff"', 'class="worse" stop-color="#ff00ff"',
    'stop-opacity=".5" style="stop-opacity:ham"',
]  # fmt: skip
OPACITIES = [".5", " 0.5 ", "0.5px", "1.7", "-1", "50%", "ham", "inherit", "", "0,5", "+5e-1"]
SHEET = (
    "<style>.good{stop-color:#ff00ff} .bad{stop-color:ham} "
    ".worse{stop-color:red;stop-color:ham}</style>"
)

CASES = {}
for text in COLORS + IN_ATTRIBUTES:
    CASES[f"colour {text!r}"] = Case(mesh(one(f'stop-color="{text}"')), one())
for style in [f"stop-color:{text}" for text in COLORS] + IN_STYLES:
    CASES[f"style {style!r}"] = Case(mesh(one(f'style="{style}"')), one())
for paint in PAINTS:
    CASES[f"stop {paint!r}"] = Case(SHEET + mesh(one(paint)), one())
for text in OPACITIES:
    paint = f'stop-color="red" stop-opacity="{text}"'
    CASES[f"opacity {text!r}"] = Case(mesh(one(paint)), one())
    paint = f'style="stop-color:red;stop-opacity:{text}"'
    CASES[f"opacity in a style {text!r}"] = Case(mesh(one(paint)), one())
# Stops inherit nothing.
for paint in ("inherit", "currentColor"):
    green = 'color="lime" stop-color="lime"'
    body = mesh(one(f'stop-color="{paint}"'), f'{USER} x="10" y="10" {green}')
    body = body.replace("<meshpatch", f"<meshpatch {green}")
    CASES[f"inherited {paint}"] = Case(f"<g {green}>{body}</g>", one())

for path in ("l", "L", "z", "Z", "l 0,-40 l 5,5", "L 10,10", "l 30,-20"):
    CASES[f"closing line {path!r}"] = Case(mesh(one(left=path)), one())
BENT = "c 10,-10 -10,-30 0,-40"
for path in (BENT, "c 10,-10 -10,-30", "C 20,40 0,20", BENT + " z", "c 10-10-10-30,7,7 8"):
    CASES[f"closing curve {path!r}"] = Case(mesh(one(left=path)), one(left=BENT))
CASES["no last stop"] = Case(mesh(one(left="no stop")), one())
for path in ("c,10,,-5 20,5,40,0", " c10-5 20 5 4e1.0 7,7 8,8 9,9", "C 20,5 30,15 50,10 ham"):
    CASES[f"path {path!r}"] = Case(mesh(one(path=path)), one())
for last, plain in (
    ("c -5,5 -10,-5", "c -5,5 -10,-5"),
    ("C 45,55 40,45", "c -5,5 -10,-5"),
    ("z", "l"),
    ("l", "l"),
):
    CASES[f"second patch {last!r}"] = Case(mesh(two(last=last)), two(last=plain))
CASES["one stop more"] = Case(mesh(two(stop("l 0,-40", 'stop-color="#00ffff"'))), two())
CASES["a curve more"] = Case(
    mesh(two(stop("c 5,-10 -5,-30 0,-40", 'stop-color="#00ffff"'))),
    two().replace(stop(RIGHT, COLORED[1]), stop("c 0,10 10,30 0,40"), 1),
)
CASES["no last stop below"] = Case(
    mesh(below(stop("l 0,20", COLORED[1]), stop("l -40,0", COLORED[0]))),
    below(stop("l 0,20"), stop("l -40,0"), stop("l 0,-20")),
)
WHOLE = "20,20 -10,10 -10,-10 10,-10"
for tensor in (WHOLE + " 5,5", "20,20 -10,10 ham", "20,20", "ham", ""):
    plain = {WHOLE + " 5,5": f'tensor="{WHOLE}"'}.get(tensor, "")
    CASES[f"tensor {tensor!r}"] = Case(mesh(one(tensor=f'tensor="{tensor}"')), one(tensor=plain))

for gradient in ("meshgradient", "meshGradient", "mesh"):
    for line in ("meshrow", "meshRow"):
        for patch in ("meshpatch", "meshPatch"):
            rows = renamed(one(), meshrow=line, meshpatch=patch)
            CASES[f"{gradient} {line} {patch}"] = Case(mesh(rows, name=gradient), one())
LOWER = (stop("l 0,20", COLORED[1]), stop("l -40,0", COLORED[0]), stop("l 0,-20", COLORED[1]))
mixed = below(*LOWER).replace("<meshrow>", "<meshRow>", 1).replace("</meshrow>", "</meshRow>", 1)
CASES["names of both times"] = Case(mesh(mixed), below(*LOWER))
CASES["a prefix"] = Case(
    renamed(mesh(one()), meshgradient="s:meshgradient", meshrow="s:meshrow", stop="s:stop"), one()
)
CASES["not in defs"] = Case(mesh(one()).replace("<defs>", "").replace("</defs>", ""), one())
CASES["in metadata"] = Case(f"<metadata>{mesh(one())}</metadata>", one())
CASES["an empty row at the end"] = Case(mesh(one() + "<meshrow/>"), one())

in_box = re.sub(r"(?<![#\w])-?\d+", lambda found: str(int(found[0]) / 200), one())
for units in ('gradientUnits=" userSpaceOnUse "', 'gradientUnits="ham"', ""):
    CASES[f"{units} of the box"] = Case(mesh(in_box, f'{units} x="25%" y="0.25"'), one())
CASES["another type"] = Case(mesh(one(), f'{USER} x="10" y="10" type=" bicubic "'), one())
CASES["percentages"] = Case(mesh(one(), f'{USER} x="1000%" y="1000%"'), one())
for order in ("before", "after"):
    CASES[f"units of a linear gradient {order}"] = Case(linked(order), one())
    CASES[f"transform of a linear gradient {order}"] = Case(
        linked(order, other='gradientTransform="scale(2)" x1="7"'), one()
    )
    holder = mesh(one(), f'{USER} x="3" y="3" type="bicubic"', id="h")
    through = linked(order, f'{USER} x="10" y="10" xlink:href="#g"', "", 'xlink:href="#h"')
    CASES[f"rows by way of a linear gradient {order}"] = Case(holder + through, one())
    direct = [holder]
    direct.insert(order == "after", mesh("", 'x="10" y="10" xlink:href="#h"', name="mesh"))
    CASES[f"rows of another mesh {order}"] = Case("".join(direct), one())
for href in ("#gone", "#box", "other.svg#m", "#m", "#n"):
    circle = mesh("", 'xlink:href="#m"', id="n") if href == "#n" else ""
    attributes = f'{USER} x="10" y="10" xlink:href="{href}"'
    CASES[f"href {href}"] = Case(mesh(one(), attributes) + circle, one())

DOCUMENT = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:s="http://www.w3.org/2000/svg"
  xmlns:xlink="http://www.w3.org/1999/xlink" width="{0.width}" height="{0.height}">
<rect width="100%" height="100%" fill="white"/>
<g transform="{matrix}"><defs>{body}</defs>
<rect id="box" x="-40" y="-40" width="200" height="200" fill="url(#m)"/></g>
</svg>"""


def document(case):
    """One whose page is gradmesh's own frame of the mesh."""
    plain = ET.fromstring(f'<svg xmlns="{SVG[1:-1]}">{mesh(case.shape)}</svg>')
    net = read_net(plain[0], 10 + 10j)
    frame = pictures.fit_frame([net], PIXELS)
    return DOCUMENT.format(frame, matrix=pictures.matrix_text(frame.matrix), body=case.body)


@pytest.fixture(scope="module")
def painted(inkscape, tmp_path_factory):
    """Of each case the document, and the picture that Inkscape makes of it."""
    folder = tmp_path_factory.mktemp("cases")
    paths = {name: folder / f"{number}.svg" for number, name in enumerate(CASES)}
    for name, path in paths.items():
        path.write_text(document(CASES[name]), encoding="utf-8")
    return dict(zip(paths, zip(paths.values(), pictures.export(inkscape, paths.values()))))


@pytest.mark.parametrize("name", CASES)
@pytest.mark.full(all_but=1)
def test_reads_what_inkscape_paints(painted, name):
    path, png = painted[name]
    ours = gradmesh.render(gradmesh.load(path), "box", PIXELS, like_inkscape=True).astype(int)
    with Image.open(png) as picture:
        theirs = np.array(picture.convert("RGB"), int)
    assert theirs.std() > 10
    assert ours.shape == theirs.shape
    # Of opacities a rounding in a hundred thousand falls the other way.
    off = np.abs(ours - theirs).max(axis=2)
    assert off.max() <= 1


OLD_NAMES = {"meshgradient": "mesh", "meshrow": "meshRow", "meshpatch": "meshPatch"}


@pytest.mark.parametrize("method", ["best", "lines"])
def test_what_is_written_anew_has_todays_names(tmp_path, method):
    other = '<linearGradient id="g"/>'
    even = stop("l 20,0", COLORED[0]) + stop(RIGHT, COLORED[0]) + stop("l -20,0", COLORED[0])
    merged = row(even + stop(LEFT, COLORED[0]), even)
    attributes = f'{USER} x="10" y="10" xlink:href="#g"'
    meshes = [
        renamed(mesh(rows, attributes, id=id), **OLD_NAMES)
        for rows, id in ((one(), "k"), (merged, "m"))
    ]
    text = DOCUMENT.format(pictures.Frame(60, 60, ()), matrix="", body="\n".join([other, *meshes]))
    text = text.replace("</g>", '<rect id="kept" width="60" height="60" fill="url(#k)"/></g>')
    document = gradmesh.loads(text)
    results = gradmesh.simplify(document, epsilon=0.01, method=method)
    assert {r.id: r.patches_after for r in results} == {"box": 1, "kept": 1}
    written = document.to_bytes().decode()
    assert meshes[0] in written and other in written
    (new,) = ET.fromstring(written).iter(SVG + "meshgradient")
    assert [len(list(new.iter(SVG + name))) for name in ("meshrow", "meshpatch")] == [1, 1]
    assert written.count("<mesh ") == 1 and written.count("<meshRow") == 1
