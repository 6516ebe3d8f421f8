"""What is built for users watches over its stack and memory."""

import re
import shutil
import subprocess

import pytest

from built import BUILD, PACKAGES, PROGRAM

CACHE = (BUILD / "CMakeCache.txt").read_text()

pytestmark = [
    pytest.mark.skipif(not shutil.which("readelf"), reason="readelf (binutils) is not installed"),
    pytest.mark.skipif(
        not re.search(r"^CMAKE_BUILD_TYPE:\w+=Rel", CACHE, re.M), reason="this is no release build"
    ),
]


def readelf(option, path):
    return subprocess.run(
        ["readelf", "--wide", option, str(path)], capture_output=True, text=True, check=True
    ).stdout


@pytest.mark.parametrize("file", [PROGRAM, *PACKAGES.rglob("_core*.so")], ids=lambda path: path.name)
def test_hardening(file):
    assert re.search(r"Type:\s+DYN", readelf("--file-header", file))  # position independent
    segments = readelf("--segments", file)
    assert "GNU_RELRO" in segments
    assert re.search(r"GNU_STACK.* RW ", segments)  # not executable
    assert re.search(r"BIND_NOW|FLAGS_1.*NOW", readelf("--dynamic", file))
    symbols = readelf("--dyn-syms", file)
    assert "__stack_chk_fail" in symbols
    assert re.search(r"__\w+_chk@", symbols)  # calls that _FORTIFY_SOURCE checks
