"""Meshes of a PDF puts what a PDF paints into the document, when run as Inkscape runs it."""

import shutil
import xml.etree.ElementTree as ET

import pytest

import displays
import windows
import inkscape_harness
from built import SAMPLES
from extension_runs import INKEX, extension, is_one_sentence, refused, run  # noqa: F401
from in_inkscape import inkscape, needs  # noqa: F401
from pdf_pages import pdf
from pictures import error, export

import gradmesh

pytestmark = pytest.mark.skipif(not INKEX.is_dir(), reason="Inkscape is not installed")

INKSCAPE = "http://www.inkscape.org/namespaces/inkscape"
DOCUMENT = (
    f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="{INKSCAPE}" id="drawing"'
    ' xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd" width="200" height="160">'
    '<sodipodi:namedview inkscape:current-layer="own"/>'
    '<g id="own" inkscape:groupmode="layer"><path id="p" d="M0,0 9,9"/></g><g id="last"/></svg>'
)


@pytest.fixture
def file(tmp_path):
    """Writes a PDF of these pages; skips the test where gradmesh was built without PDF."""

    def write(*contents):
        path = tmp_path / "drawing.pdf"
        path.write_bytes(pdf(*contents))
        try:
            gradmesh.load(path)
        except gradmesh.InputError as error:
            if "was built without PDF" in str(error):
                pytest.skip(str(error))
        return path

    return write


def read(run, *options, document=DOCUMENT):
    done = run(document, *options, item="pages")
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


def layers(text):
    return [
        (layer.get(f"{{{INKSCAPE}}}label"), [each.get("id") for each in layer])
        for layer in ET.fromstring(text)
        if layer.get(f"{{{INKSCAPE}}}groupmode") == "layer"
    ]


def test_each_page_is_a_new_layer(run, file):
    path = file("/sh sh", "n", "/sh sh 2 0 0 2 0 0 cm /sh sh")
    text = read(run, f"--file={path}")
    assert layers(text) == [
        (None, ["p"]),
        ("Page 1", ["page-1-mesh-1"]),
        ("Page 3", ["page-3-mesh-1", "page-3-mesh-2"]),
    ]
    assert gradmesh.loads(text).ids == ["page-1-mesh-1", "page-3-mesh-1", "page-3-mesh-2"]
    assert layers(read(run, f"--file={path}", "--page=3")) == [
        (None, ["p"]),
        ("drawing.pdf", ["page-3-mesh-1", "page-3-mesh-2"]),
    ]


def test_the_current_layer_takes_them(run, file):
    text = read(run, f"--file={file('/sh sh')}", "--into=layer")
    assert layers(text) == [(None, ["p", "page-1-mesh-1"])]
    without = DOCUMENT.replace('inkscape:current-layer="own"', 'inkscape:current-layer="gone"')
    text = read(run, f"--file={file('/sh sh')}", "--into=layer", document=without)
    assert [each.get("id") for each in ET.fromstring(text)][-1] == "page-1-mesh-1"


@pytest.mark.parametrize("name", ["drawing.svg", "drawing.pdf", "drawing.pdf.svg"])
@pytest.mark.full(all_but=1)
def test_where_no_file_is_chosen_it_is_that_of_the_document(run, file, name):
    document = file("/sh sh").with_name(name)
    done = run(DOCUMENT, "--file=", item="pages", path=str(document))
    assert layers(done.stdout)[1:] == [("drawing.pdf", ["page-1-mesh-1"])]
    log = (document.parent / "cache" / "gradmesh" / "extension.log").read_text()
    assert "No file was chosen, so it was drawing.pdf." in log


def test_what_cannot_be_read_is_one_sentence(run, file, tmp_path):
    path = file("n")
    assert "there is no gradient mesh" in refused(run(DOCUMENT, f"--file={path}", item="pages"))
    assert "there is no page 2" in refused(run(DOCUMENT, f"--file={path}", "--page=2", item="pages"))
    assert "Choose a PDF" in refused(run(DOCUMENT, "--file=", item="pages"))
    assert "Choose a PDF" in refused(run(DOCUMENT, f"--file={tmp_path}", item="pages"))
    assert "gone.pdf" in refused(run(DOCUMENT, f"--file={tmp_path / 'gone.pdf'}", item="pages"))
    text = tmp_path / "text.pdf"
    text.write_text("a letter")
    assert "it is no PDF document" in refused(run(DOCUMENT, f"--file={text}", item="pages"))


def test_python_says_what_was_found(file):
    document = gradmesh.loads(DOCUMENT)
    made = gradmesh.insert_pages(document, file("/sh sh q 50 50 9 9 re W n /sh sh Q"), into="own")
    (mesh,) = made.meshes
    assert (mesh.id, mesh.page, mesh.number, mesh.patches, mesh.rows, mesh.columns) == ("page-1-mesh-1", 1, 1, 1, 1, 1)
    assert [str(each).split(", page ")[1] for each in made.left_out] == ["1, mesh 2: its clip path hides it."]


def test_python_may_stop_it(file):
    apart = "1 0 0 1 20 0 cm /sh sh"
    document, path = gradmesh.loads(DOCUMENT), file(f"/sh sh {apart}", f"/sh sh {apart} {apart}")
    told = []

    def until(count):
        def progress(now):
            told.append((now.mesh, now.meshes, now.done, now.total))
            return len(told) < count

        return progress

    before = document.to_bytes()
    made = gradmesh.insert_pages(document, path, progress=until(1))
    assert (made.meshes, made.stopped, document.to_bytes()) == ([], True, before)
    told.clear()
    made = gradmesh.insert_pages(document, path, progress=until(1000))
    assert (len(made.meshes), made.stopped) == (5, False)
    assert {meshes for _, meshes, _, _ in told} == {2}
    shares = [mesh + (done / total if total else 0) for mesh, _, done, total in told]
    assert shares == sorted(shares) and {(0, 1, 2), (1, 2, 3)} <= {(mesh, done, total) for mesh, _, done, total in told}
    half = gradmesh.loads(DOCUMENT)
    told.clear()
    made = gradmesh.insert_pages(half, path, progress=lambda now: now.mesh == 0)
    assert made.stopped and half.ids == ["page-1-mesh-1", "page-1-mesh-2"]


@pytest.mark.parametrize("item", ["pdf", "ai"])
@pytest.mark.full(all_but=1)
def test_open_and_import_read_the_meshes_alone(run, file, tmp_path, item):
    path = file("/sh sh", "/sh sh")
    opened = run(path.read_bytes(), item=item)
    assert (opened.returncode, opened.stderr) == (0, "")
    assert gradmesh.loads(opened.stdout).ids == ["page-1-mesh-1", "page-2-mesh-1"]
    assert gradmesh.loads(run(path.read_bytes(), "--page=2", item=item).stdout).ids == ["page-2-mesh-1"]
    hidden = file("/sh sh q 50 50 9 9 re W n /sh sh Q").read_bytes()
    (sentence,) = map(str, gradmesh.loads(hidden, "a.pdf").left_out)
    assert sentence == "a.pdf, page 1, mesh 2: its clip path hides it."
    assert gradmesh.loads(run(hidden, item=item).stdout).ids == ["page-1-mesh-1"]
    assert "page 1, mesh 2: its clip path hides it." in (tmp_path / "cache/gradmesh/extension.log").read_text()
    assert "there is no gradient mesh" in told(run(file("n").read_bytes(), item=item))
    assert "there is no page 3" in told(run(path.read_bytes(), "--page=3", item=item))


def told(done):
    """The sentence of a reader that read nothing. It names the file, as Inkscape gives a reader the file itself."""
    assert done.returncode != 0 and done.stdout == ""
    assert is_one_sentence(done.stderr), done.stderr
    return done.stderr


@needs("xdotool")
@pytest.mark.full
def test_inkscapes_own_import_stays(extension, tmp_path):
    """Beside two further types of file for the same endings: what chooses no type asks, and makes, what it did."""
    sample = SAMPLES / "two.svg"
    pages = [tmp_path / "two.pdf", tmp_path / "two.ai"]
    without, beside = ([tmp_path / f"{kind}{page.suffix}.svg" for page in pages] for kind in ("without", "beside"))
    with inkscape_harness.Inkscape() as inkscape:

        def export(source, made):
            displays.run(["inkscape", f"--export-filename={made}", str(source)], inkscape.env, inkscape.timeout)
            return made.read_bytes()

        export(sample, pages[0])
        shutil.copy(*pages)
        before = list(map(export, pages, without))
        inkscape.install(extension)
        assert list(map(export, pages, beside)) == before
        assert all(b"<meshpatch" not in made and b"<path" in made for made in before)
        for page in pages:
            with windows.Started(["inkscape", page], inkscape.env, inkscape.timeout) as started:
                started.find_window("PDF Import Settings")


@needs()
# Of opacity's pattern Inkscape's import makes the negative, and it leaves out fruit's shadow.
@pytest.mark.parametrize("name, whole", [("face", True), ("two", True), ("fruit", False), ("opacity", False)])
@pytest.mark.full(all_but=1)
def test_meshes_take_the_place_of_what_inkscape_imports(inkscape, extension, file, tmp_path, name, whole):
    """Of the tiles that Inkscape makes of its own PDF, below what lies on them, in one step of undo."""
    file("/sh sh")  # Skips where there is no PDF.
    inkscape.install(extension)
    sample, path = shutil.copy(SAMPLES / f"{name}.svg", tmp_path), tmp_path / f"{name}.pdf"
    tiles, out, undone = (tmp_path / f"{made}.svg" for made in ("tiles", "out", "undone"))
    for made, source in ((path, sample), (tiles, path)):
        displays.run(["inkscape", f"--export-filename={made}", str(source)], inkscape.env, inkscape.timeout)
    inkscape.set_values({"org.gradmesh.pages.file": path})
    written = [f"export-filename:{out}", "export-do"]
    if inkscape_harness.undoes_in_batch_runs():
        written += ["undo", f"export-filename:{undone}", "export-do"]
    inkscape.run_actions(tiles, ["org.gradmesh.pages.noprefs", *written])
    if not inkscape_harness.undoes_in_batch_runs():
        shutil.copy(tiles, undone)
        undone.write_bytes(inkscape.undone_in_window(undone, ["org.gradmesh.pages.noprefs"])[0])
    was, now = gradmesh.load(sample).meshes, gradmesh.load(out).meshes
    assert [mesh.handles for mesh in now] == [mesh.handles for mesh in was]
    assert gradmesh.load(undone).ids == []
    # Each patch is a tile or more, in 1.4 one; each mesh is a path.
    gone = sum(mesh.patches for mesh in was) - len(was)
    assert out.read_text().count("<path") <= tiles.read_text().count("<path") - gone
    if whole:
        assert error(*export(inkscape, [sample, out])) < 0.01
