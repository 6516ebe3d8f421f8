"""What is carried to other machines: the zip for Inkscape, the Debian package, the wheel."""

import os
import re
import shutil
import stat
import subprocess
import zipfile
from pathlib import Path

import pytest

import in_inkscape
from built import BUILD, PROGRAM, PYTHON, ROOT, SAMPLES, install_extension
from inkscape_harness import Inkscape
from pdf_pages import pdf

import gradmesh
from gradmesh.helper import find_program

INKEX = Path("/usr/share/inkscape/extensions")
FACE = SAMPLES / "face.svg"
MINOR = int(subprocess.check_output([PYTHON, "-c", "import sys; print(sys.version_info.minor)"]))
SIMPLIFY = "import gradmesh, sys; d = gradmesh.load(sys.argv[1]); gradmesh.simplify(d, method='grid')"
DRAW = SIMPLIFY + "; assert 'image/png' in gradmesh.draw(d, 'edges')"


def needs(*programs):
    absent = [program for program in programs if shutil.which(program) is None]
    return pytest.mark.skipif(bool(absent), reason=f"not installed: {', '.join(absent)}")


def run(*command, **options):
    """The standard output of a command that succeeds."""
    done = subprocess.run(
        [str(part) for part in command], capture_output=True, text=True, timeout=300, **options
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def in_python(code, *folders):
    """Runs code on a sample with these folders of packages, away from the build."""
    path = os.pathsep.join(map(str, folders))
    return run(PYTHON, "-B", "-c", code, FACE, cwd="/", env={**os.environ, "PYTHONPATH": path})


def files_below(folder):
    return {str(path.relative_to(folder)) for path in folder.rglob("*") if not path.is_dir()}


def is_as_written(folder, sources):
    return all((folder / source.name).read_bytes() == source.read_bytes() for source in sources)


DIALOGS = sorted((ROOT / "inx").glob("*.inx"))
SCRIPTS = sorted((ROOT / "extension").glob("*.py"))
PACKAGE = sorted((ROOT / "python" / "gradmesh").glob("*.py"))


#: The program that scripts/package builds for other people's Linux.
PORTABLE = BUILD / "linux-x86_64" / "gradmesh"
needs_portable = pytest.mark.skipif(
    not PORTABLE.exists(), reason="not built: scripts/package builds what is carried to others"
)


@pytest.fixture(scope="module")
def archive(tmp_path_factory):
    """The zip that the target extension-zip writes; where nothing portable is built, with the program of
    this machine in it."""
    run("cmake", "--build", BUILD, "--target", "extension-zip")
    archive = tmp_path_factory.mktemp("archive") / f"gradmesh-{gradmesh.__version__}.zip"
    shutil.copy(BUILD / archive.name, archive)
    if not PORTABLE.exists():
        # It looks for its libraries and the module for images where it was built.
        starter = f'#!/bin/sh\nexec "{PROGRAM}" "$@"\n'
        with zipfile.ZipFile(archive, "a") as packed:
            packed.writestr(f"gradmesh/bin/{find_program_folder()}/gradmesh", starter)
    return archive


def find_program_folder():
    return find_program().parent.name


@pytest.fixture(scope="module")
def unpacked_zip(archive, tmp_path_factory):
    folder = tmp_path_factory.mktemp("ein Ordner für zip")
    with zipfile.ZipFile(archive) as packed:
        modes = [entry.external_attr >> 16 for entry in packed.infolist()]
        assert not any(map(stat.S_ISLNK, modes))  # the extension manager writes what links say
        packed.extractall(folder)  # without the bits that say what may be run
    return folder


def test_the_zip_holds_the_whole_extension(archive, unpacked_zip):
    (folder,) = unpacked_zip.iterdir()
    assert folder.name == "gradmesh"
    assert is_as_written(folder, DIALOGS + SCRIPTS)
    assert is_as_written(folder / "gradmesh", PACKAGE)
    rest = files_below(folder) - {path.name for path in DIALOGS + SCRIPTS}
    rest -= {f"gradmesh/{path.name}" for path in PACKAGE}
    rest = {name for name in rest if not re.fullmatch(r"locale/\w+/LC_MESSAGES/.*\.mo", name)}
    programs = {name for name in rest if re.fullmatch(r"bin/[\w-]+/(gradmesh|gradmesh\.exe|licenses/.*)", name)}
    assert f"bin/{find_program_folder()}/gradmesh" in programs
    assert rest - programs == {"LICENSE"}
    assert archive.stat().st_size < 25e6


def test_the_extension_runs_from_the_zip(unpacked_zip, tmp_path):
    """With a Python in which no module of ours loads, as there is none."""
    done = subprocess.run(
        [PYTHON, "-B", "gradmesh_simplify.py", "--id=face", "--result=gqe", FACE],
        cwd=unpacked_zip / "gradmesh",
        env={
            **{name: value for name, value in os.environ.items() if not name.startswith("GRADMESH")},
            "PYTHONPATH": str(INKEX),
            "LANGUAGE": "C",
            "XDG_CACHE_HOME": str(tmp_path),
        },
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "Gradient mesh: " in done.stdout


@needs_portable
def test_the_licenses_of_what_a_program_holds_lie_beside_it(unpacked_zip):
    for system in (unpacked_zip / "gradmesh" / "bin").iterdir():
        licenses = {path.name: path.read_text(errors="replace") for path in (system / "licenses").iterdir()}
        headers = {"cli11", "eigen", "glm", "json"}
        built = {"freetype", "glpk", "hwy", "jpeg", "png", "qpdf", "tbb", "xml2", "zlib", "zstd"}
        assert headers | built <= licenses.keys()
        assert ("epoxy" in licenses) == ("linux" in system.name)
        assert ("mingw-w64" in licenses) == ("windows" in system.name)
        assert all("opyright" in text and len(text) > 500 for text in licenses.values())
        assert "GNU GENERAL PUBLIC LICENSE" in licenses["glpk"] and "Version 3, 29 June 2007" in licenses["glpk"]
        for library in ("qpdf", "tbb"):
            assert "APPENDIX: How to apply the Apache License" in licenses[library]


@needs_portable
def test_the_program_for_others_needs_next_to_nothing():
    needed = set(re.findall(r"NEEDED\s+(\S+)", run("objdump", "-p", PORTABLE)))
    assert needed <= {"libc.so.6", "libm.so.6", "ld-linux-x86-64.so.2"}
    versions = re.findall(r"GLIBC_(\d+)\.(\d+)", run("objdump", "-T", PORTABLE))
    # Ubuntu 22.04, which is in Snap's core22 too, has 2.35.
    assert max((int(a), int(b)) for a, b in versions) <= (2, 35)


@needs_portable
@pytest.mark.parametrize("sample", sorted(SAMPLES.glob("*.svg")), ids=lambda path: path.stem)
def test_the_program_for_others_writes_the_same_bytes(sample, tmp_path):
    written = []
    for program in (PROGRAM, PORTABLE):
        run(program, "simplify", sample, "-o", tmp_path / "out.svg", "--resolution", 100, "--quiet")
        written.append((tmp_path / "out.svg").read_bytes())
    assert written[0] == written[1]


@needs_portable
def test_the_program_for_others_reads_pdf(tmp_path):
    (tmp_path / "patch.pdf").write_bytes(pdf("/sh sh"))
    run(PORTABLE, "convert", tmp_path / "patch.pdf", tmp_path / "patch.svg")
    assert (tmp_path / "patch.svg").read_text().count("<meshpatch") == 1


def test_the_extension_says_for_which_python_it_was_built(tmp_path):
    extension = install_extension(tmp_path)
    (module,) = (extension / "gradmesh").glob("_core.*")
    other = module.name.replace(f"cpython-3{MINOR}", f"cpython-3{MINOR + 1}")
    module.rename(module.with_name(other))
    # Which would do the work instead.
    shutil.rmtree(extension / "bin")
    done = subprocess.run(
        [PYTHON, "-B", "gradmesh_simplify.py", FACE],
        cwd=extension,
        env={
            **os.environ,
            "PYTHONPATH": str(INKEX),
            "LANGUAGE": "C",
            "GRADMESH_CORE": "",
            "GRADMESH_HELPER": "",
        },
        capture_output=True,
        text=True,
    )
    assert done.returncode == 1 and done.stdout == ""
    (sentence,) = done.stderr.splitlines()
    built, running = f"built for Python 3.{MINOR + 1},", f"runs Python 3.{MINOR}:"
    assert built in sentence and running in sentence


#: Installs an archive as Extensions > Manage Extensions does with a chosen file.
MANAGE = """
import sys
from inkman.target import ExtensionsTarget
ExtensionsTarget("extension", "Extensions", "extensions")._install(sys.argv[1], {})
"""


@in_inkscape.needs()
@pytest.mark.skipif(not (INKEX / "inkman").is_dir(), reason="there is no extension manager")
@pytest.mark.full
def test_the_extension_manager_installs_the_zip(archive, tmp_path):
    pytest.importorskip("appdirs", reason="the extension manager imports it, and Debian 13 has it no more")
    with Inkscape(values={"org.gradmesh.simplify.result": "gqe"}) as inkscape:
        manager = os.pathsep.join(map(str, (INKEX, INKEX / "inkman" / "inkman")))
        run(PYTHON, "-B", "-c", MANAGE, archive, env={**inkscape.env, "PYTHONPATH": manager})
        assert len(list(inkscape.extensions.rglob("gradmesh_simplify.inx"))) == 1
        out = tmp_path / "out.svg"
        inkscape.run_extension("org.gradmesh.simplify", FACE, out, select=["face"])
    assert [mesh.simplified for mesh in gradmesh.load(out).meshes] == [True]


@pytest.fixture(scope="module")
def debian_package(tmp_path_factory):
    folder = tmp_path_factory.mktemp("deb")
    run("cpack", "-G", "DEB", "--config", BUILD / "CPackConfig.cmake", "-B", folder)
    (package,) = folder.glob("*.deb")
    return package


@needs("cpack", "dpkg", "dpkg-deb", "dpkg-shlibdeps")
@pytest.mark.full
def test_the_debian_package_runs_from_any_root(debian_package, tmp_path):
    run("dpkg", "-x", debian_package, tmp_path)
    usr = tmp_path / "usr"
    assert is_as_written(usr / "share/inkscape/extensions/gradmesh", DIALOGS + SCRIPTS)
    assert is_as_written(usr / "lib/python3/dist-packages/gradmesh", PACKAGE)
    assert (usr / "share/doc/gradmesh/copyright").read_bytes() == (ROOT / "LICENSE").read_bytes()
    assert {path.parts[0] for path in map(Path, files_below(tmp_path))} == {"usr"}

    # Inkscape names all folders of extensions, where ours has the package's name.
    extensions, packages = usr / "share/inkscape/extensions", usr / "lib/python3/dist-packages"
    path = os.pathsep.join(map(str, (extensions, INKEX, packages)))
    written = run(
        *(PYTHON, "-B", extensions / "gradmesh/gradmesh_simplify.py", "--id=face", "--result=gqe", FACE),
        env={**os.environ, "PYTHONPATH": path, "XDG_CACHE_HOME": str(tmp_path / "cache")},
    )
    assert "gradmesh:" in written

    picture = tmp_path / "face.png"
    run(usr / "bin/gradmesh", "render", FACE, "-o", picture, "--resolution", 64)
    assert picture.read_bytes().startswith(b"\x89PNG")
    in_python(DRAW, packages)


@needs("cpack", "dpkg", "dpkg-deb", "dpkg-shlibdeps")
@pytest.mark.full
def test_the_debian_package_names_what_it_needs(debian_package):
    depends = run("dpkg-deb", "--field", debian_package, "Depends")
    names = set(re.findall(r"(?:^|, )([\w.+-]+)", depends))
    assert {"libc6", "libepoxy0", "libglpk40", "libtbb12", "python3", "python3-numpy"} <= names
    for library in ("libhwy1", "libxml2", "libopenimageio2"):  # Debian 13 has others of a longer name
        assert any(name.startswith(library) for name in names), (library, names)
    assert f"python3 (>= 3.{MINOR}), python3 (<< 3.{MINOR + 1})" in depends
    assert run("dpkg-deb", "--field", debian_package, "Package").strip() == "gradmesh"
    assert "inkscape" in run("dpkg-deb", "--field", debian_package, "Recommends")


def has_modules(*names):
    code = f"import importlib.util as u, sys; sys.exit(not all(map(u.find_spec, {names})))"
    return subprocess.run([PYTHON, "-c", code]).returncode == 0


@pytest.mark.skipif(
    not has_modules("pip", "setuptools", "wheel"),
    reason="not installed: python3-pip, python3-setuptools or python3-wheel",
)
@pytest.mark.full
def test_the_wheel_is_installed_by_pip(tmp_path):
    source, dist, target = (tmp_path / name for name in ("source", "dist", "target"))
    shutil.copytree(ROOT / "python", source / "python")  # setuptools leaves files beside its sources
    for name in ("pyproject.toml", "setup.py", "README.md", "CMakeLists.txt"):
        shutil.copy(ROOT / name, source)
    offline = {**os.environ, "GRADMESH_BUILD": str(BUILD), "PIP_NO_INDEX": "1"}
    pip = (PYTHON, "-m", "pip", "--disable-pip-version-check")
    run(*pip, "wheel", source, "--no-build-isolation", "--no-deps", "-w", dist, env=offline)
    (wheel,) = dist.iterdir()
    assert re.fullmatch(rf"gradmesh-[\d.]+-cp3{MINOR}-cp3{MINOR}-linux_\w+\.whl", wheel.name)
    run(*pip, "install", "--no-deps", "--target", target, wheel, env=offline)
    assert is_as_written(target / "gradmesh", PACKAGE)
    in_python(DRAW, target)
    version = in_python("import gradmesh; print(gradmesh.__version__)", target).strip()
    assert wheel.name.split("-")[1] == version
