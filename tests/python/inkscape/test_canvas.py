"""Inkscape's canvas shows after an item, undone and redone what it shows of the document opened afresh: Inkscape merges
what the extension returns into what is there, and loses shapes whose mesh is placed by a box that it does not know."""

import pytest

from built import install_extension
from in_inkscape import needs
from displays import WINDOW_PROGRAMS
from inkscape_harness import Inkscape

np = pytest.importorskip("numpy")
Image = pytest.importorskip("PIL.Image")
gradmesh = pytest.importorskip("gradmesh", reason="the compiled package is not there")

from shape_documents import CELL, COLUMNS, MARK, cells, shapes_document

pytestmark = [needs(*WINDOW_PROGRAMS), pytest.mark.module_only]

#: Levels by which pixels at outlines may differ, and the share of a shape's cell that may differ by more.
LEVELS, SHARE = 24, 0.02
#: Shapes whose outline is in their element as it is.
OUTLINED_AT_ONCE = {"path", "polygon", "polyline", "stroked path", "stroked polyline"}
SIMPLIFY = {"amount": "gentle", "resolution": 100}


def canvas(window, file):
    """The part of the canvas between the two marks of the document."""
    window.screenshot(file)
    with Image.open(file) as picture:
        pixels = np.array(picture.convert("RGB"), int)
    rows, columns = np.nonzero((pixels == MARK).all(axis=2))
    return pixels[rows.min() : rows.max() + 1, columns.min() : columns.max() + 1]


def different(canvas, other, names):
    """The shapes that do not look the same on two canvases."""
    assert canvas.shape == other.shape
    differs = abs(canvas - other).max(axis=2) > LEVELS
    zoom = canvas.shape[1] / (COLUMNS * CELL)
    found = []
    for name, (x, y) in cells(names):
        top, left = round(y * zoom), round(x * zoom)
        cell = differs[top : top + round(CELL * zoom), left : left + round(CELL * zoom)]
        if cell.mean() > SHARE:
            found.append(name)
    return found


def after(window, key, folder):
    """The canvas after a key, without the marks of what is selected."""
    window.key(key)
    window.key("Escape")
    return canvas(window, folder / f"after {key}.png")


@pytest.fixture(scope="module")
def inkscape(tmp_path_factory):
    with Inkscape() as running:
        running.install(install_extension(tmp_path_factory.mktemp("installed")))
        yield running


def blocks(text):
    document = gradmesh.loads(text)
    gradmesh.simplify(document, method="best", resolution=100)
    return document.to_bytes().decode()


ITEMS = {
    "one mesh": ("simplify", {**SIMPLIFY, "result": "one-mesh"}, str),
    "blocks": ("simplify", {**SIMPLIFY, "result": "blocks"}, str),
    "hidden original": ("simplify", {**SIMPLIFY, "result": "one-mesh", "keep_original": "true"}, str),
    "blocks to one mesh": ("to_one_mesh", {}, blocks),
}


@pytest.mark.parametrize(
    "name, units",
    [*((name, "box") for name in ITEMS), ("one mesh", "user")],
    ids=lambda name: name.replace(" ", "-"),
)
@pytest.mark.full(all_but=1)
def test_the_canvas_is_as_the_page(inkscape, tmp_path, monkeypatch, name, units):
    monkeypatch.setenv("GRADMESH_UNATTENDED", "1")  # no line over the canvas that says what was done
    item, values, made = ITEMS[name]
    # Inkscape 1.2.2 ends where a group that is cloned becomes one of the shapes.
    text, names = shapes_document(units, ["cloned", "symbol"] if made is blocks else [])
    svg = tmp_path / "shapes.svg"
    svg.write_text(made(text))
    before = svg.read_text()
    inkscape.set_values({f"org.gradmesh.{item}.{key}": value for key, value in values.items()})
    inkscape.set_key("F10", f"app.org.gradmesh.{item.replace('_', '-')}.noprefs")
    with inkscape.window(svg) as window:
        window.key("5")
        opened = canvas(window, tmp_path / "opened.png")
        window.key("ctrl+a")
        ran, undone, redone = (after(window, key, tmp_path) for key in ("F10", "ctrl+z", "ctrl+shift+z"))
        window.key("ctrl+s")
    assert svg.read_text() != before
    with inkscape.window(svg) as window:
        page = after(window, "5", tmp_path)
    assert different(ran, page, names) == []
    assert different(redone, page, names) == []
    assert different(page, opened, names) == []
    # Undoing puts the old shapes in anew, which is Inkscape's own doing.
    kept = [shape for shape in different(undone, opened, names) if units == "user" or shape in OUTLINED_AT_ONCE]
    assert kept == []
