"""The sources look as .clang-format and .flake8 say."""

import shutil
import subprocess
import sys

import pytest

from built import ROOT

CORE = sorted(p for folder in ("native", "tests", "benchmarks") for p in (ROOT / folder).rglob("*.[ch]*"))
PYTHON = [ROOT / folder for folder in ("python", "extension", "tests/python", "samples", "scripts", "setup.py")]


def is_python(path):
    return path.is_file() and path.suffix == "" and path.read_text().startswith("#!/usr/bin/env python3")


@pytest.mark.skipif(shutil.which("clang-format") is None, reason="clang-format is not installed")
def test_the_core_is_formatted():
    said = subprocess.run(["clang-format", "--version"], capture_output=True, text=True, check=True).stdout
    if " version 14." not in said:
        pytest.skip("clang-format is not that of Debian 12, and no two agree on all")
    sources = [p for p in CORE if p.suffix in {".h", ".cpp"}]
    assert len(sources) > 200
    done = subprocess.run(
        ["clang-format", "--dry-run", "--Werror", *sources], cwd=ROOT, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr


def test_the_linter_finds_nothing():
    pytest.importorskip("flake8")
    programs = [p for p in (ROOT / "scripts").iterdir() if is_python(p)]
    assert len(programs) > 3
    done = subprocess.run(
        [sys.executable, "-m", "flake8", *PYTHON, *programs], cwd=ROOT, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout
