"""What the extension says where something is missing that it needs: what, and how to get it."""

import os
import shutil
import subprocess

import pytest

from built import PYTHON, SAMPLES
from extension_runs import INKEX, extension, refused, run  # noqa: F401

DEBIAN = 'PRETTY_NAME="Debian GNU/Linux 13 (trixie)"\nVERSION_ID="13"\nID=debian\n'
MINT = 'ID=linuxmint\nID_LIKE="ubuntu debian"\n'
FEDORA = "ID=fedora\n"
FLATPAK = "ID=org.freedesktop.platform\n"


def without(folder, *modules):
    """A folder of modules that are as if they were not there, and of an inkex that imports the first."""
    for module in modules:
        (folder / f"{module}.py").write_text(f"raise ModuleNotFoundError('no {module}', name='{module}')\n")
    if "inkex" not in modules:
        (folder / "inkex").mkdir()
        (folder / "inkex" / "__init__.py").write_text(f"import {modules[0]}\n")
    return folder


@pytest.mark.parametrize("module", ["cssselect", "inkex", "lxml", "numpy", "tinycss2"])
def test_a_module_that_inkex_needs_is_named(run, extension, tmp_path, module):
    path = os.pathsep.join(map(str, (extension.parent, without(tmp_path, module), INKEX)))
    said = refused(run(SAMPLES / "tensor.svg", "--id=silk", PYTHONPATH=path))
    assert said.startswith(f"Inkscape’s extensions need {module}, which is missing for Inkscape’s Python 3.")
    assert "gradmesh" not in said


@pytest.mark.parametrize(
    "system, module, says",
    [
        (DEBIAN, "tinycss2", "run “sudo apt install python3-tinycss2”"),
        (MINT, "lxml", "run “sudo apt install python3-lxml”"),
        (FEDORA, "numpy", "run “sudo dnf install python3-numpy”"),
        (FLATPAK, "tinycss2", "install Inkscape again"),
        (None, "tinycss2", "install Inkscape again"),
        (DEBIAN, "inkex", "install Inkscape again"),
    ],
)
def test_how_to_get_it_depends_on_the_system(extension, tmp_path, system, module, says):
    release = tmp_path / "os-release"
    if system is not None:
        release.write_text(system)
    code = f"import gradmesh_needs as n; n.OS_RELEASE = {str(release)!r}; print(n.how_to_install({module!r}))"
    done = subprocess.run(
        [PYTHON, "-c", code], cwd=extension, capture_output=True, text=True, env={**os.environ, "LANGUAGE": "en"}
    )
    assert (done.stdout, done.stderr) == (says + "\n", "")


@pytest.fixture
def unpacked(extension, tmp_path):
    """The extension as the zip has it: without a module, with programs for each system in bin/."""
    folder = tmp_path / "unpacked" / "gradmesh"
    shutil.copytree(extension, folder)
    for module in (folder / "gradmesh").glob("_core.*"):
        module.unlink()
    return folder


def said_by(folder, item):
    """What an item says where nothing but the extension does the work."""
    env = {**os.environ, "PYTHONPATH": f"{folder.parent}{os.pathsep}{INKEX}", "LANGUAGE": "en", "DISPLAY": ""}
    env.update(GRADMESH_CORE="", GRADMESH_HELPER="", GRADMESH_UNATTENDED="0")
    command = [PYTHON, "-B", f"gradmesh_{item}.py", "--id=silk", str(SAMPLES / "tensor.svg")]
    return refused(subprocess.run(command, cwd=folder, env=env, capture_output=True, text=True))


@pytest.mark.parametrize("how", ["its file is gone", "its file is empty", "its folder is gone"])
def test_a_program_that_is_gone(unpacked, how):
    (program,) = (unpacked / "bin").glob("*/gradmesh")
    if how == "its folder is gone":
        shutil.rmtree(unpacked / "bin")
    else:
        program.unlink()
        if how == "its file is empty":
            program.touch()
    said = said_by(unpacked, "simplify")
    assert said.startswith(f"The program {program}, which does gradmesh's work, is not there or empty; a virus")


def test_a_program_for_another_system(unpacked):
    (folder,) = (unpacked / "bin").iterdir()
    folder.rename(folder.with_name("windows-arm64"))
    said = said_by(unpacked, "simplify")
    assert said.startswith(f"This gradmesh has no program for this system, {folder.name}, only for windows-arm64: ")
