"""Documents that others made, before and after a simplification as Inkscape's dialog sets it."""

import functools
import json
from pathlib import Path
from typing import NamedTuple, Optional

import pytest

from built import ROOT, gradmesh
from in_inkscape import inkscape, needs  # noqa: F401
from program import error, listed

etree = pytest.importorskip("lxml.etree")
pytest.importorskip("PIL.Image")

from pictures import on_white

REAL = ROOT.parent / "shared" / "real"
DOCUMENTS = sorted(REAL.glob("*.svg"))
#: Balanced in Inkscape's dialog.
BALANCED = {"--epsilon": "0.01", "--max-local-error": "0.1", "--resolution": "500"}
PIXELS = 500
#: What nothing can be read of: Inkscape crashes at the first, and of the second paints nothing.
UNREAD = {"svgmatrix-mesh-gradient-basic", "svgmatrix-mesh-gradient-02"}
#: No object is painted by their meshes.
UNUSED = {"morewaita-bleachbit", "morewaita-texts-symbolic"}

pytestmark = [
    pytest.mark.skipif(not DOCUMENTS, reason="the documents are not in ../shared/real"),
    needs(),
]


class Simplified(NamedTuple):
    out: Path
    info: dict
    meshes: list  #: of the report
    said: str


def simplified(path, folder):
    out, report = folder / path.name, folder / f"{path.stem}.json"
    options = [part for option in BALANCED.items() for part in option]
    done = gradmesh("simplify", path, "-o", out, *options, "--report", report)
    assert (done.returncode == 0) == out.exists()
    meshes = json.loads(report.read_text())["meshes"] if out.exists() else []
    return Simplified(out, listed(path), meshes, done.stderr)


def page(inkscape, path, png):
    """Inkscape's picture of the page, on white."""
    return on_white(inkscape.export_png(path, png, width=PIXELS))


class Real(NamedTuple):
    result: Simplified
    flip: Optional[float]  #: of the page


@pytest.fixture(scope="module")
def real(inkscape, tmp_path_factory):
    """Returns what became of a document, by its name."""
    folder = tmp_path_factory.mktemp("real")

    @functools.cache
    def find(name):
        path = REAL / f"{name}.svg"
        result, flip = simplified(path, folder), None
        if result.out.exists():
            before = page(inkscape, path, folder / f"{path.stem}-before.png")
            after = page(inkscape, result.out, folder / f"{path.stem}-after.png")
            flip = error(before, after)
        return Real(result, flip)

    return find


@pytest.mark.full
def test_table(real, capsys):
    lines = ["| document | meshes | patches before | after | page FLIP |", "|---|---|---|---|---|"]
    for name in (path.stem for path in DOCUMENTS):
        result, flip = real(name)
        keys = ("patches_before", "patches_after")
        counts = [sum(mesh[key] for mesh in result.meshes) for key in keys]
        cells = [*counts, f"{flip:.5f}"] if result.meshes else ["", "", ""]
        lines.append(f"| {name} | {len(result.info['meshes'])} | {' | '.join(map(str, cells))} |")
    with capsys.disabled():
        print("", *lines, sep="\n")
    assert len(lines) == 2 + len(DOCUMENTS)


@pytest.mark.full(all_but=3)
@pytest.mark.parametrize("name", [path.stem for path in DOCUMENTS])
def test_all_that_inkscape_paints_is_read(real, name):
    result = real(name).result
    meshes = result.info["meshes"]
    assert bool(result.info["unused"]) == (name in UNUSED)
    if name in UNUSED:
        assert meshes == [] and "no object in this document" in result.said
    elif name in UNREAD:
        assert all("refused" in mesh for mesh in meshes) and meshes[0]["refused"] in result.said
    else:
        assert [mesh["id"] for mesh in result.meshes] == [mesh["id"] for mesh in meshes] != []
        assert not any("refused" in mesh for mesh in meshes)


@pytest.mark.full(all_but=3)
@pytest.mark.parametrize("name", sorted({path.stem for path in DOCUMENTS} - UNREAD - UNUSED))
def test_the_page_looks_the_same(real, name):
    assert real(name).flip <= float(BALANCED["--epsilon"])


@pytest.mark.full(all_but=3)
@pytest.mark.parametrize("name", sorted({path.stem for path in DOCUMENTS} - UNREAD - UNUSED))
def test_all_else_stays(real, name):
    result = real(name).result
    before = REAL / f"{name}.svg"
    changed = {m["id"] for m in result.meshes if is_simpler(m)}
    if not changed:
        assert result.out.read_bytes() == before.read_bytes()
        return
    old, new = (etree.parse(str(path)).getroot() for path in (before, result.out))
    name_as_in(new, old, changed)
    gone = ids(old) - ids(new)
    assert {e.tag for e in old.iter() if e.get("id") in gone} <= OF_MESHES
    assert others(old, changed | gone) == others(new, changed | (ids(new) - ids(old)))


def is_simpler(mesh):
    """Whether a mesh of the report is written anew."""
    return any(mesh[f"{count}_after"] < mesh[f"{count}_before"] for count in ("patches", "handles"))


SVG = "{http://www.w3.org/2000/svg}"
NAMES = ("meshgradient", "meshrow", "meshpatch", "meshGradient", "meshRow", "meshPatch", "mesh")
OF_MESHES = {SVG + name for name in (*NAMES, "stop")}


def ids(root):
    return {element.get("id") for element in root.iter() if element.get("id")}


def name_as_in(new, old, changed):
    """An object without an id gets the one by which it is reported, also in the old document."""
    for unnamed in changed - ids(old):
        (named,) = new.xpath("//*[@id=$id]", id=unnamed)
        (element,) = old.xpath(new.getroottree().getpath(named))
        assert element.get("id") is None
        element.set("id", unnamed)


def others(node, left_out):
    """All elements, attributes and texts, but for the elements with these ids, and the place where
    what is new is defined where there was none."""
    if not isinstance(node.tag, str):
        return [node.text]
    found = [node.tag, dict(node.attrib), (node.text or "").strip()]
    for child in node:
        if isinstance(child.tag, str) and child.get("id") in left_out:
            continue
        if child.tag == SVG + "defs" and not others(child, left_out)[3:] and not child.attrib:
            continue
        found.append((others(child, left_out), (child.tail or "").strip()))
    return found
