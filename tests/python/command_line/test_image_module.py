"""OpenImageIO is loaded only where images are read, from a module of its own."""

import shutil
import subprocess

import pytest

from built import BUILD, PROGRAM, SAMPLES, install

ELLIPSE = SAMPLES / "ellipse.svg"


def run(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=120)


def test_the_program_alone_does_all_but_read_images(tmp_path):
    alone = shutil.copy(PROGRAM, tmp_path)
    assert run(alone, "info", ELLIPSE).returncode == 0
    out = tmp_path / "out.svg"
    assert run(alone, "simplify", ELLIPSE, "-o", out, "--method", "grid").returncode == 0
    picture = tmp_path / "a.png"
    assert run(alone, "render", ELLIPSE, "-o", picture).returncode == 0
    refused = run(alone, "compare", picture, picture)
    assert refused.returncode == 1
    (line,) = refused.stderr.splitlines()
    assert "images cannot be read here: gradmesh_images.so: " in line


@pytest.mark.skipif(not (BUILD / "python").exists(), reason="the Python package was not built")
def test_an_installed_program_finds_the_module(tmp_path):
    install(tmp_path, "--prefix", "/prefix")
    program, picture = tmp_path / "prefix" / "bin" / "gradmesh", tmp_path / "a.png"
    assert run(program, "render", ELLIPSE, "-o", picture).returncode == 0
    assert run(program, "compare", picture, picture).stdout == "0.000000\n"
