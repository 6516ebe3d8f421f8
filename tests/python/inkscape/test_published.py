"""Published documents look as Inkscape shows the original: in Inkscape, in a browser, in librsvg."""

import io
import random
import re
import shutil
import subprocess
import time
import xml.etree.ElementTree as ET

import pytest

import browser as browsers
import displays
import inkscape_harness
from browser import one_chromium  # noqa: F401
from built import SAMPLES, install_extension
from in_inkscape import needs
from inkscape_harness import Inkscape
from windows import Started

np = pytest.importorskip("numpy")
Image = pytest.importorskip("PIL.Image")

import gradmesh
from pictures import difference, export, flip, on_white
from random_meshes import KINDS
from sample_meshes import PAINTED
from svg_meshes import SVG

pytestmark = needs()

DPI = 192  # twice the document's pixels, as pictures have by default
INKSCAPE_AGAIN, OTHERS = 0.01, 0.015  # FLIP against the original
# Each program rounds colours times opacities in its own way, and FLIP charges 0.03 for a single
# level everywhere: so the levels of these are looked at too.
TRANSLUCENT, ROUNDING = ("opacity", "opacity mesh"), 0.005
RSVG = shutil.which("rsvg-convert")
ACTION = "org.gradmesh.publish"
DIALOG = "SVG with meshes as pictures"

# --- documents ---

PAGE = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
  width="180" height="180" {size}>
<defs>{defs}</defs>
<rect id="page" width="100%" height="100%" fill="#fff"/>
<g id="drawing">{body}</g>
</svg>
"""
#: Meshes of one colour, with curved sides, and of colours along lines that are turned.
ONE = (
    '<meshgradient id="one" x="40" y="40" gradientUnits="userSpaceOnUse"><meshrow><meshpatch>'
    '<stop path="c 30,-20 70,20 100,0" stop-color="#a03050"/><stop path="l 0,100" stop-color="#a03050"/>'
    '<stop path="c -30,-20 -70,20 -100,0" stop-color="#a03050"/><stop path="l 0,-100" stop-color="#a03050"/>'
    "</meshpatch></meshrow></meshgradient>"
)
LINEAR = (
    '<meshgradient id="linear" x="60" y="20" gradientUnits="userSpaceOnUse"><meshrow><meshpatch>'
    '<stop path="l 50,25" stop-color="#e0d030"/><stop path="l -40,80" stop-color="#2050c0"/>'
    '<stop path="l -50,-25" stop-color="#2050c0"/><stop path="l 40,-80" stop-color="#e0d030"/></meshpatch>'
    '<meshpatch><stop path="l 50,25"/><stop path="l -40,80" stop-color="#c03030"/>'
    '<stop path="l -50,-25" stop-color="#c03030"/></meshpatch></meshrow></meshgradient>'
)
RECT = '<rect id="{}" x="50" y="50" width="80" height="80" rx="12" {}/>'
FILLED = RECT.format("a", 'fill="url(#mesh)"')
CIRCLE = '<clipPath id="c"><circle cx="80" cy="90" r="40"/></clipPath>'
STAR = '<path id="star" d="M 90,30 L 120,140 30,70 150,70 60,140 Z" {}/>'
WAVE = '<path id="wave" d="M 40,60 C 80,20 100,160 140,110" {}/>'
STROKED = 'style="fill:none;stroke:url(#mesh);stroke-width:14;stroke-linecap:round"'


def mesh(kind="tensor", name="mesh", seed=11, more=""):
    """A mesh of four rows and columns, which cover all from 0,0 to 160,160: so do few seeds."""
    return KINDS[kind].gradient(random.Random(seed), name, more)


#: What is drawn, and definitions, beside the mesh.
CASES = {
    "fill": (FILLED, ""),
    "even-odd": (STAR.format('fill="url(#mesh)" fill-rule="evenodd"'), ""),
    "thick stroke": (WAVE.format(STROKED), ""),
    "dashes": (WAVE.format(STROKED.replace(":14", ":9;stroke-dasharray:12 16")), ""),
    "text": ('<text id="t" x="30" y="110" font-size="70" font-family="sans" fill="url(#mesh)">Abc</text>', ""),
    "fill and stroke": (
        RECT.format("a", 'style="fill:url(#mesh);stroke:url(#other);stroke-width:16;opacity:0.8"'),
        mesh("Coons", "other", 10),
    ),
    "plain stroke": (
        RECT.format("a", 'style="fill:url(#mesh);stroke:#204060;stroke-width:8;fill-opacity:0.7"'),
        "",
    ),
    "plain fill": (
        STAR.format('style="fill:#a0c0e0;stroke:url(#mesh);stroke-width:8;paint-order:stroke;stroke-opacity:0.6"'),
        "",
    ),
    "use": (
        '<use xlink:href="#a" transform="translate(-20 10) rotate(8 90 90)"/><use xlink:href="#a" x="25"/>',
        FILLED,
    ),
    "symbol": ('<use xlink:href="#s" x="5"/>', f'<symbol id="s" overflow="visible">{FILLED}</symbol>'),
    "handed on": (f"""<g fill="url(#mesh)" opacity="0.7">{RECT.format("a", "")}{STAR.format("")}</g>""", ""),
    "effects": (
        FILLED.replace("/>", ' transform="rotate(15 90 90) skewX(10)" opacity="0.8" filter="url(#soft)"/>'),
        '<filter id="soft" x="-0.3" y="-0.3" width="1.6" height="1.6"><feGaussianBlur stdDeviation="3"/></filter>',
    ),
    "clipped and masked": (
        f"""<g clip-path="url(#c)">{FILLED.replace("/>", ' mask="url(#k)"/>')}</g>""",
        CIRCLE + '<mask id="k"><path d="M 60,60 H 140 V 140 Z" fill="#fff" fill-opacity="0.7"/></mask>',
    ),
    "clipped itself": (FILLED.replace("/>", ' clip-path="url(#c)"/>'), CIRCLE),
    "sheet": (
        RECT.format("a", 'class="soft"'),
        "<style>.soft { opacity: 0.6; fill: url(#mesh); stroke: #123; stroke-width: 4 }</style>",
    ),
    "hidden": (
        FILLED
        + STAR.format('fill="url(#mesh)" style="display:none"')
        + WAVE.format('fill="url(#mesh)" visibility="hidden"'),
        "",
    ),
    "markers": (
        WAVE.format('style="fill:url(#mesh);stroke:#333;stroke-width:3;marker-end:url(#dot)"'),
        '<marker id="dot" viewBox="-5 -5 10 10" markerWidth="6" markerHeight="6"><circle r="4"/></marker>',
    ),
    "one colour": (RECT.format("a", 'fill="url(#one)"'), ONE),
    "one colour, beyond": ('<circle id="a" cx="120" cy="90" r="50" fill="url(#one)"/>', ONE),
    "one colour, beside": ('<circle id="a" cx="20" cy="20" r="15" fill="url(#one)"/>', ONE),
    "linear": (
        RECT.format("a", 'fill="url(#linear)" opacity="0.9"').replace('"80"', '"30"'),
        LINEAR.replace('x="60" y="20"', 'x="50" y="40"'),
    ),
    "linear, beyond": (RECT.format("a", 'fill="url(#linear)"'), LINEAR),
    "linear stroke": (WAVE.format('style="fill:none;stroke:url(#linear);stroke-width:9"'), LINEAR),
}
SIZES = {
    "larger": ('viewBox="20 20 120 120"', "fill"),
    "wide": ('viewBox="0 40 180 90" preserveAspectRatio="xMinYMax slice"', "fill"),
    "millimetres": ('viewBox="0 0 180 180"', "plain stroke"),
}


def documents():
    """The texts of the documents that are made here, by name."""
    texts = {
        name: PAGE.format(size="", defs=mesh() + defs, body=body) for name, (body, defs) in CASES.items()
    }
    for kind in ("opacity", "bicubic", "transforms"):
        body = '<rect id="a" x="10" y="10" width="150" height="150" fill="url(#mesh)"/>'
        texts[f"{kind} mesh"] = PAGE.format(size="", defs=mesh(kind), body=body)
    more = 'gradientTransform="matrix(0.9 0.2 -0.3 1.1 20 -10)"'
    texts["mapped"] = PAGE.format(size="", defs=mesh(more=more), body=CASES["even-odd"][0])
    for name, (size, case) in SIZES.items():
        body, defs = CASES[case]
        texts[name] = PAGE.format(size=size, defs=mesh() + defs, body=body)
    texts["millimetres"] = texts["millimetres"].replace('"180" height="180" v', '"50mm" height="50mm" v')
    assert "50mm" in texts["millimetres"]
    return texts


MADE = documents()


def bare(sample):
    """A sample with nothing but what meshes paint, on white, without filters. Chromium and librsvg
    dither linear gradients, and blur, each in their own way, which is none of ours."""
    root = ET.parse(SAMPLES / f"{sample}.svg").getroot()
    (layer,) = [e for e in root.iter() if e.get("id") == "layer1"]
    for parent in list(layer.iter()):
        for child in list(parent):
            if not {e.get("id") for e in child.iter()} & set(PAINTED[sample]):
                parent.remove(child)
    for painted in layer.iter():
        painted.set("style", re.sub(r"filter:[^;]*;?", "", painted.get("style", "")))
    layer.insert(0, ET.Element(SVG + "rect", width="100%", height="100%", fill="#fff"))
    return ET.tostring(root)


class Shown:
    """Documents with their published copies, and what Inkscape shows of both, by name."""

    def __init__(self, inkscape, folder):
        texts = {name: (SAMPLES / f"{name}.svg").read_bytes() for name in PAINTED}
        texts |= {f"bare {name}": bare(name) for name in PAINTED}
        texts |= {name: text.encode() for name, text in MADE.items()}
        self.original, self.copy, self.told = {}, {}, {}
        for name, text in texts.items():
            place = folder / re.sub(r"\W+", "-", name)
            self.original[name], self.copy[name] = (place.with_suffix(f".{e}.svg") for e in ("in", "out"))
            self.original[name].write_bytes(text)
            document = gradmesh.loads(text)
            self.told[name] = gradmesh.publish(document)
            gradmesh.save(document, self.copy[name])
        files = [*self.original.values(), *(self.copy[name] for name in [*PAINTED, *MADE])]
        pictures = dict(zip(files, export(inkscape, files, dpi=DPI)))
        self.expected = {name: on_white(pictures[file]) for name, file in self.original.items()}
        self.again = {name: on_white(pictures[self.copy[name]]) for name in [*PAINTED, *MADE]}


@pytest.fixture(scope="module")
def inkscape(tmp_path_factory):
    with Inkscape() as running:
        running.install(install_extension(tmp_path_factory.mktemp("installed")))
        yield running


@pytest.fixture(scope="module")
def shown(inkscape, tmp_path_factory):
    return Shown(inkscape, tmp_path_factory.mktemp("published"))


def alike(name, expected, found, most):
    """Whether two pictures of a document differ by no more than this in FLIP."""
    if name in TRANSLUCENT:
        assert (difference(expected, found) > 2).mean() <= 0.005
        most += ROUNDING
    return flip(expected, found) <= most


def is_empty(png):
    with Image.open(png) as picture:
        return (np.array(picture) == 255).all()


# --- in Inkscape ---


@pytest.mark.parametrize("name", [*PAINTED, *MADE])
@pytest.mark.full
def test_inkscape_shows_the_copy_as_it_shows_the_original(shown, name):
    assert alike(name, shown.expected[name], shown.again[name], INKSCAPE_AGAIN)
    assert is_empty(shown.expected[name]) == (name == "one colour, beside")


@pytest.mark.full
def test_all_ways_to_show_a_mesh_are_among_these(shown):
    ways = {told.shown_as for name in MADE for told in shown.told[name]}
    assert ways == {"picture", "linear gradient", "colour"}


# --- in a browser ---


def screenshot(browser, svg, size):
    """What the browser shows of a document on a screen with twice as many pixels; `size` of the
    picture. Nothing else is asked for than the page and the document."""
    width, height = (side // 2 for side in size)
    page = svg.with_suffix(".html")
    page.write_text(
        '<!DOCTYPE html><body style="margin:0;background:#fff">'
        f'<img style="display:block" width="{width}" height="{height}" src="{svg.name}">'
    )
    metrics = {"width": width, "height": height, "deviceScaleFactor": 2, "mobile": False}
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
    browsers.requests(browser)
    browser.get(page.as_uri())
    assert browser.execute_script("return document.images[0].complete && document.images[0].naturalWidth > 0")
    asked = {url for url in browsers.requests(browser) if not url.startswith("data:")}
    assert asked == {page.as_uri(), svg.as_uri()}
    png = svg.with_suffix(".browser.png")
    with Image.open(io.BytesIO(browser.get_screenshot_as_png())) as picture:
        assert picture.size == size
        picture.convert("RGB").save(png)
    return png


def size_of(png):
    with Image.open(png) as picture:
        return picture.size


@pytest.mark.parametrize("name", PAINTED)
@pytest.mark.full
def test_chromium_shows_the_copy_as_inkscape_shows_the_original(shown, chromium, name):
    expected = shown.expected[f"bare {name}"]
    found = screenshot(chromium, shown.copy[f"bare {name}"], size_of(expected))
    assert alike(name, expected, found, OTHERS)
    assert not is_empty(found)


@pytest.mark.full
def test_chromium_shows_no_mesh_of_the_original(shown, chromium):
    """Or there would be nothing to publish."""
    expected = shown.expected["bare fruit"]
    found = screenshot(chromium, shown.original["bare fruit"], size_of(expected))
    assert flip(expected, found) > 10 * OTHERS


DIFFERENT = {"text"}  # letters are of each program's own making


@pytest.mark.long
@pytest.mark.parametrize("name", [name for name in MADE if name not in DIFFERENT])
def test_chromium_shows_all_kinds_of_objects(shown, chromium, name):
    expected = shown.expected[name]
    width, height = size_of(expected)
    found = screenshot(chromium, shown.copy[name], (width // 2 * 2, height // 2 * 2))
    assert size_of(found) == size_of(expected)
    assert alike(name, expected, found, OTHERS)


# --- in librsvg ---


@pytest.mark.skipif(RSVG is None, reason="librsvg2-bin is not installed")
@pytest.mark.parametrize("name", PAINTED)
@pytest.mark.full
def test_librsvg_shows_the_copy_as_inkscape_shows_the_original(shown, name):
    copy = shown.copy[f"bare {name}"]
    found = copy.with_suffix(".rsvg.png")
    subprocess.run([RSVG, "--zoom=2", f"--output={found}", copy], check=True, timeout=60)
    expected = shown.expected[f"bare {name}"]
    assert size_of(found) == size_of(expected)
    assert alike(name, expected, on_white(found), OTHERS)


# --- Inkscape's File > Save a Copy ---


def counts(svg):
    """How many pictures and mesh gradients a document has."""
    tags = [element.tag for element in ET.parse(svg).iter()]
    return tags.count(SVG + "image"), tags.count(SVG + "meshgradient")


def settled_place(program, window):
    """Where a window is once it stays there: x, y, width, height."""
    before = None
    while True:
        values = dict(line.split("=") for line in program.xdotool("getwindowgeometry", "--shell", window).split())
        now = [int(values[name]) for name in ("X", "Y", "WIDTH", "HEIGHT")]
        if now == before:
            return now
        before = now
        time.sleep(0.5)


@needs("xdotool")
@pytest.mark.skipif(not inkscape_harness.is_older_than(1, 4), reason="Inkscape 1.4 exports without a dialog")
def test_a_copy_is_saved_from_its_dialog(inkscape, tmp_path):
    copy = tmp_path / "copy.svg"
    export = (f"--export-extension={ACTION}", f"--export-filename={copy}", SAMPLES / "tensor.svg")
    with Started([inkscape_harness.INKSCAPE, *export], inkscape.env, 60) as asking:
        x, y, width, height = settled_place(asking, asking.find_window(DIALOG))
        assert not copy.exists()
        # "Save" is in the lower right corner.
        asking.xdotool("mousemove", str(x + width - 60), str(y + height - 30), "click", "1")
        asking.wait()
    assert counts(copy) == (1, 0)
    document = gradmesh.load(SAMPLES / "tensor.svg")
    (told,) = gradmesh.publish(document)
    image = next(ET.parse(copy).iter(SVG + "image"))
    (expected,) = ET.fromstring(document.to_bytes()).iter(SVG + "image")
    assert image.attrib == expected.attrib and told.shown_as == "picture"


@pytest.mark.parametrize("kind", [(), ("--export-plain-svg",)], ids=["Inkscape SVG", "plain SVG"])
def test_other_svg_documents_keep_their_meshes(inkscape, tmp_path, kind):
    """Ours is one more way to save files of the same ending."""
    out = tmp_path / "out.svg"
    command = [inkscape_harness.INKSCAPE, "--export-type=svg", *kind, f"--export-filename={out}"]
    displays.run([*command, str(SAMPLES / "tensor.svg")], inkscape.env, inkscape.timeout)
    assert counts(out) == (0, 1)


def test_a_file_name_alone_saves_no_copy_with_pictures(inkscape, tmp_path):
    out = tmp_path / "out.svg"
    inkscape.run_actions(SAMPLES / "tensor.svg", [f"export-filename:{out}", "export-do"])
    assert counts(out) == (0, 1)
