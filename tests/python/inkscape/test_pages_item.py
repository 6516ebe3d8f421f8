"""Meshes of a PDF puts what a PDF paints into the document, when run as Inkscape runs it."""

import io
import shutil
import xml.etree.ElementTree as ET

import pytest

import inkscape_harness
from built import SAMPLES
from extension_runs import INKEX, extension, refused, run  # noqa: F401
from in_inkscape import inkscape, needs  # noqa: F401
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


def square():
    """A shading of type 7: one patch over the square from (0, 0) to (9, 9)."""
    around = [(0, 0), (0, 3), (0, 6), (0, 9), (3, 9), (6, 9), (9, 9), (9, 6), (9, 3), (9, 0), (6, 0), (3, 0)]
    inner = [(3, 3), (3, 6), (6, 6), (6, 3)]
    colors = [(255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 255)]
    return bytes([0]) + b"".join(bytes(each) for each in (*around, *inner, *colors))


def pdf(*contents):
    """A PDF document with pages of 150 x 75 points; /sh is the square."""
    count = len(contents)
    first = 3 + 2 * count
    kids = " ".join(f"{3 + 2 * n} 0 R" for n in range(count))
    objects = [b"<< /Type /Catalog /Pages 2 0 R >>", f"<< /Type /Pages /Kids [{kids}] /Count {count} >>".encode()]
    for n, content in enumerate(contents):
        objects.append(
            f"<< /Type /Page /Parent 2 0 R /Contents {4 + 2 * n} 0 R /MediaBox [0 0 150 75]"
            f" /Resources << /Shading << /sh {first} 0 R >> >> >>".encode()
        )
        objects.append(stream("", content.encode()))
    objects.append(
        stream(
            "/ShadingType 7 /ColorSpace /DeviceRGB /BitsPerCoordinate 8 /BitsPerComponent 8 /BitsPerFlag 8"
            " /Decode [0 255 0 255 0 1 0 1 0 1]",
            square(),
        )
    )
    file = io.BytesIO()
    file.write(b"%PDF-1.7\n")
    places = []
    for number, body in enumerate(objects, 1):
        places.append(file.tell())
        file.write(b"%d 0 obj\n%s\nendobj\n" % (number, body))
    table = file.tell()
    file.write(b"xref\n0 %d\n0000000000 65535 f \n" % (len(objects) + 1))
    file.write(b"".join(b"%010d 00000 n \n" % place for place in places))
    file.write(b"trailer\n<< /Size %d /Root 1 0 R >>\nstartxref\n%d\n%%%%EOF\n" % (len(objects) + 1, table))
    return file.getvalue()


def stream(entries, data):
    return f"<< {entries} /Length {len(data)} >>\nstream\n".encode() + data + b"\nendstream"


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


@needs()
# Of opacity's pattern Inkscape's import makes the negative, and it leaves out fruit's shadow.
@pytest.mark.parametrize("name, whole", [("face", True), ("two", True), ("fruit", False), ("opacity", False)])
def test_meshes_take_the_place_of_what_inkscape_imports(inkscape, extension, file, tmp_path, name, whole):
    """Of the tiles that Inkscape makes of its own PDF, below what lies on them, in one step of undo."""
    file("/sh sh")  # Skips where there is no PDF.
    inkscape.install(extension)
    sample, path = shutil.copy(SAMPLES / f"{name}.svg", tmp_path), tmp_path / f"{name}.pdf"
    tiles, out, undone = (tmp_path / f"{made}.svg" for made in ("tiles", "out", "undone"))
    for made, source in ((path, sample), (tiles, path)):
        inkscape_harness.run(["inkscape", f"--export-filename={made}", str(source)], inkscape.env, inkscape.timeout)
    inkscape.set_values({"org.gradmesh.pages.file": path})
    written = [f"export-filename:{out}", "export-do", "undo", f"export-filename:{undone}", "export-do"]
    inkscape.run_actions(tiles, ["org.gradmesh.pages.noprefs", *written])
    was, now = gradmesh.load(sample).meshes, gradmesh.load(out).meshes
    assert [mesh.handles for mesh in now] == [mesh.handles for mesh in was]
    assert gradmesh.load(undone).ids == []
    patches = sum(mesh.patches for mesh in was)
    assert out.read_text().count("<path") <= tiles.read_text().count("<path") - patches
    if whole:
        assert error(*export(inkscape, [sample, out])) < 0.01
