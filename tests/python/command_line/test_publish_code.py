"""The command gradmesh publish --as swift and --as compose: what it prints, writes and refuses."""

import re
import shutil
import subprocess

import pytest

from bad_documents import RAGGED, REASON
from built import SAMPLES, gradmesh as run
from hemesh_files import grid
from lattices import DOCUMENT, FILLED, MANY, gradient
from program import printed, refused

TWO = SAMPLES / "two.svg"
LANGUAGES = [("swift", ".swift"), ("compose", ".kt")]
languages = pytest.mark.parametrize("language, extension", LANGUAGES)
RECT = '<rect id="torn" x="12" y="12" width="36" height="16" fill="url(#n)"/>'


def published(language, document, out, *options):
    return printed("publish", "--as", language, document, "-o", out, *options)


@languages
def test_a_folder_gets_a_file_for_each_mesh(tmp_path, language, extension):
    out = tmp_path / "app" / "meshes"
    before = TWO.read_bytes()
    # Where the program was built for Windows, its folders end in the other slash.
    lines = published(language, TWO, out).replace("\\", "/").splitlines()
    files = sorted(out.iterdir())
    assert [file.name for file in files] == ["Cap" + extension, "Stalk" + extension]
    assert sorted(lines) == [
        f"{file.stem.lower()}: {file.stem}, {file}: {file.stat().st_size} bytes" for file in files
    ]
    assert TWO.read_bytes() == before
    # Files that gradmesh has written are written again, and are the same.
    first = [file.read_bytes() for file in files]
    assert published(language, TWO, out, "--quiet") == ""
    assert [file.read_bytes() for file in files] == first


@languages
def test_one_file_holds_all_meshes(tmp_path, language, extension):
    out = tmp_path / ("Meshes" + extension)
    lines = published(language, TWO, out).splitlines()
    assert lines == ["stalk: Stalk", "cap: Cap", f"{out}: {out.stat().st_size} bytes"]
    code = out.read_text()
    assert re.match(r"// Made by gradmesh \d+\.\d+\.\d+ from two\.svg\n// ", code)
    assert str(tmp_path) not in code and str(SAMPLES) not in code
    declared = re.findall(r"^(?:struct|fun) (\w+)", code, re.MULTILINE)
    assert declared == ["Stalk", "Cap"]
    assert len(re.findall("^import", code, re.MULTILINE)) == len(set(re.findall("^import .*", code, re.MULTILINE)))
    assert max(map(len, code.splitlines())) <= 120


@languages
@pytest.mark.full(all_but=1)
def test_brackets_are_balanced(tmp_path, language, extension):
    for sample in sorted(SAMPLES.glob("*.svg")):
        out = tmp_path / (sample.stem + extension)
        run("publish", "--as", language, sample, "-o", out)
        code = re.sub("//.*", "", out.read_text())
        for opening, closing in ("()", "[]", "{}"):
            assert code.count(opening) == code.count(closing), sample


def test_what_is_lost_is_told(tmp_path):
    done = run("publish", "--as", "swift", SAMPLES / "stroke.svg", "-o", tmp_path / "out", "--quiet")
    assert (done.returncode, done.stdout) == (0, "")
    assert done.stderr.startswith("gradmesh: ") and done.stderr.count("\n") == 1
    assert done.stderr.endswith("all of the mesh is painted, not only the stroke.\n")


@languages
@pytest.mark.full(all_but=1)
def test_blocks_are_painted_side_by_side(tmp_path, language, extension):
    simple, out = tmp_path / "simple.svg", tmp_path / ("out" + extension)
    printed("simplify", "--quiet", SAMPLES / "fruit.svg", "-o", simple, "--method", "gqe", "--epsilon", "0.02")
    done = run("publish", "--as", language, simple, "-o", out, "--quiet")
    (blocks,) = re.findall(r"as (\d+) mesh gradients side by side", done.stderr)
    code = out.read_text()
    if language == "swift":
        assert "ZStack" in code and len(re.findall(r"\(width: \d+, height: \d+, first", code)) == int(blocks)
    else:
        assert "painters.fold(frame)" in code


@languages
def test_files_of_others_are_left_alone(tmp_path, language, extension):
    (tmp_path / ("Stalk" + extension)).write_text("// Of the app\n")
    said = refused("publish", "--as", language, TWO, "-o", tmp_path)
    assert "Stalk" in said and "is not of gradmesh" in said
    assert [path.name for path in tmp_path.iterdir()] == ["Stalk" + extension]
    assert (tmp_path / ("Stalk" + extension)).read_text() == "// Of the app\n"


@pytest.mark.parametrize("language, name", [("swift", "out.kt"), ("compose", "out.swift"), ("swift", "out.svg")])
def test_a_file_has_the_extension_of_the_language(tmp_path, language, name):
    assert name in refused("publish", "--as", language, TWO, "-o", tmp_path / name)
    assert not any(tmp_path.iterdir())


def test_a_file_is_no_folder(tmp_path):
    (tmp_path / "file").write_text("")
    assert "file" in refused("publish", "--as", "swift", TWO, "-o", tmp_path / "file")


def test_the_scale_is_of_pictures(tmp_path):
    said = refused("publish", "--as", "swift", "--scale", "2", TWO, "-o", tmp_path / "out", code=2)
    assert said == "--scale goes with --as svg only."
    assert not any(tmp_path.iterdir())


def test_svg_is_what_is_published_otherwise(tmp_path):
    one, other = tmp_path / "one.svg", tmp_path / "other.svg"
    printed("publish", TWO, "-o", one, "--quiet")
    printed("publish", "--as", "svg", "--scale", "2", TWO, "-o", other, "--quiet")
    assert one.read_bytes() == other.read_bytes()


def test_only_svg_documents_are_published(tmp_path):
    mesh = tmp_path / "grid.hemesh"
    mesh.write_text(grid(2, 2))
    assert "only SVG documents are published" in refused("publish", "--as", "swift", mesh, "-o", tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_mesh_that_cannot_be_read_is_told_of(tmp_path):
    svg, out = tmp_path / "in.svg", tmp_path / "out"
    svg.write_text(DOCUMENT.format(defs=gradient(MANY) + RAGGED, body=FILLED + RECT))
    done = run("publish", "--as", "compose", svg, "-o", out, "--quiet")
    assert done.returncode == 0 and f"gradmesh: left as it was: {svg}: {REASON}\n" in done.stderr
    assert len(list(out.iterdir())) == 1


COMPILERS = {"swift": ["swiftc", "-parse"], "compose": ["kotlinc", "-Xcheck-syntax-only"]}


@languages
def test_a_compiler_takes_the_code(tmp_path, language, extension):
    command = COMPILERS[language]
    if not shutil.which(command[0]):
        pytest.skip(f"{command[0]} is not installed")
    for sample in sorted(SAMPLES.glob("*.svg")):
        out = tmp_path / (sample.stem + extension)
        run("publish", "--as", language, sample, "-o", out)
        done = subprocess.run([*command, out], capture_output=True, text=True, timeout=300)
        # Without the toolkit Kotlin complains of its names, but never of the syntax.
        wrong = [line for line in done.stderr.splitlines() if ": error: " in line]
        assert [line for line in wrong if language == "swift" or "unresolved" not in line.lower()] == []
