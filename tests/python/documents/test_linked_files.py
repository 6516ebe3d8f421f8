"""A document that is written into another folder shows the files that it showed."""

import os
import random
import shutil
from pathlib import Path
from urllib.parse import quote, unquote

import numpy as np
import pytest
from lxml import etree
from PIL import Image

import built  # noqa: F401, which knows where gradmesh is
import gradmesh
from in_inkscape import inkscape  # noqa: F401
from lattices import FILLED, MANY, document
from pictures import export
from program import printed

LINKED = """<image id="photo" x="60" y="20" width="30" height="30" xlink:href="{0}photo.png"/>
<rect id="shape" x="65" y="25" width="15" height="15" style="cursor:url({0}hand.png)"/>
<a href="page.html"><circle id="stays" r="1"/></a>"""
HREF = "{http://www.w3.org/1999/xlink}href"
QUICK = ("--resolution", "64")
NAMES = ["a", "my pics", "50% #1", "Bäume", "c;d"]


@pytest.fixture
def drawing(tmp_path):
    """Writes a document and the picture beside it that it shows."""

    def write(folder="home"):
        path = tmp_path / folder / "drawing.svg"
        path.parent.mkdir(parents=True, exist_ok=True)
        Image.fromarray(np.full((30, 30, 3), (200, 40, 90), "uint8")).save(path.with_name("photo.png"))
        path.write_text(document(MANY, body=FILLED + LINKED.format("")))
        return path

    return write


def link(path):
    return etree.parse(str(path)).find(".//{*}image").get(HREF)


def as_lxml_writes(path):
    return etree.tostring(etree.parse(str(path)))


def expect_shown(path, photo):
    """Both links of the document lead beside the photo, and the page stays where it was."""
    tree = etree.parse(str(path))
    style = tree.find(".//{*}rect[@id='shape']").get("style")
    for target in (link(path), style[len("cursor:url(") : -1]):
        assert (path.parent / unquote(target)).resolve().parent == photo.parent.resolve(), target
    assert (path.parent / unquote(link(path))).resolve() == photo.resolve()
    assert tree.find(".//{*}a").get("href") == "page.html"


def simplify(source, out):
    printed("simplify", source, "-o", out, *QUICK)


def publish(source, out):
    printed("publish", source, "-o", out)
    # Its own picture of the mesh is another image.
    assert "data:image/png" in out.read_text()


def trace(source, out):
    printed("trace", "--outline", f"{source}#shape", "-o", out, "--handles", "4")


def save(source, out):
    gradmesh.load(source).save(out)


@pytest.mark.parametrize("write", [simplify, trace, save])
def test_links_lead_to_the_same_files(drawing, tmp_path, write):
    source, elsewhere = drawing(), tmp_path / "other" / "place"
    elsewhere.mkdir(parents=True)
    write(source, elsewhere / "copy.svg")
    assert link(elsewhere / "copy.svg") == "../../home/photo.png"
    expect_shown(elsewhere / "copy.svg", source.with_name("photo.png"))
    write(source, source.with_name("copy.svg"))
    assert link(source.with_name("copy.svg")) == "photo.png"


def test_a_published_copy_shows_the_picture(drawing, tmp_path):
    source = drawing()
    publish(source, tmp_path / "copy.svg")
    assert 'xlink:href="home/photo.png"' in (tmp_path / "copy.svg").read_text()


def test_nothing_else_changes(drawing, tmp_path):
    source = drawing()
    simplify(source, source.with_name("copy.svg"))
    simplify(source, tmp_path / "copy.svg")
    expected = as_lxml_writes(source.with_name("copy.svg"))
    for name in (b"photo.png", b"hand.png"):
        expected = expected.replace(name, b"home/" + name)
    assert as_lxml_writes(tmp_path / "copy.svg") == expected


def test_a_document_saved_twice_is_right_both_times(drawing, tmp_path):
    source = drawing()
    held = gradmesh.load(source)
    before = held.to_bytes()
    for folder in ("one", "two/three"):
        (tmp_path / folder).mkdir(parents=True)
        held.save(tmp_path / folder / "copy.svg")
        expect_shown(tmp_path / folder / "copy.svg", source.with_name("photo.png"))
    assert held.to_bytes() == before == source.read_bytes()


def test_a_copy_can_be_traced_where_it_is(drawing, tmp_path):
    source = drawing()
    simplify(source, tmp_path / "copy.svg")
    trace(tmp_path / "copy.svg", tmp_path / "traced.svg")
    assert link(tmp_path / "traced.svg") == "home/photo.png"


def test_a_document_in_memory_has_no_folder(drawing, tmp_path):
    source = drawing()
    for folders in ([], [source.parent]):
        gradmesh.loads(source.read_bytes(), folders=folders).save(tmp_path / "copy.svg")
        assert (tmp_path / "copy.svg").read_bytes() == source.read_bytes()


def any_folder(root, choice):
    folder = root.joinpath(*choice.choices(NAMES, k=choice.randrange(4)))
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def test_from_any_folder_to_any_other(tmp_path):
    choice = random.Random(1)
    for i in range(60):
        home, other, pictures = (any_folder(tmp_path, choice) for _ in range(3))
        (pictures / "photo.png").touch()
        way = quote(os.path.relpath(pictures, home), safe="/") + "/"
        text = document(MANY, body=FILLED + LINKED.format(way))
        (home / "drawing.svg").write_text(text, encoding="utf-8")
        out = other / f"copy-{i}.svg"
        save(home / "drawing.svg", out)
        expect_shown(out, pictures / "photo.png")
        shutil.copy(out, other / "drawing.svg")
        save(other / "drawing.svg", home / "back.svg")
        expect_shown(home / "back.svg", pictures / "photo.png")


def pixels(path: Path):
    return np.asarray(Image.open(path).convert("RGBA"))


def test_inkscape_shows_the_same_picture(drawing, tmp_path, inkscape):  # noqa: F811
    source = drawing("my Bäume #1 (50%)")
    (tmp_path / "other").mkdir()
    copy = tmp_path / "other" / "copy.svg"
    save(source, copy)
    shown, copied = (pixels(png) for png in export(inkscape, [source, copy]))
    assert tuple(shown[40, 85]) == (200, 40, 90, 255)
    assert (shown == copied).all()
