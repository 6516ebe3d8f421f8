"""What was built: the program and the package, in build/ or the folder GRADMESH_BUILD names."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
SAMPLES = ROOT / "samples"
BUILD = Path(os.environ.get("GRADMESH_BUILD", ROOT / "build")).resolve()
PROGRAM = BUILD / "gradmesh"
PACKAGES = BUILD / "python"

sys.path.insert(0, str(PACKAGES))

PYTHON = "/usr/bin/python3"  # as Inkscape does


def gradmesh(*arguments, env={}, **how):
    """Runs the command line with pipes, as a script does, and with these variables beside those that
    are set: a CompletedProcess with texts."""
    return subprocess.run(
        [PROGRAM, *map(str, arguments)],
        env={**os.environ, **env},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=120,
        **how,
    )


def script(name, *arguments):
    """Runs a program of scripts/ on what was built: a CompletedProcess with texts."""
    return subprocess.run(
        [PYTHON, ROOT / "scripts" / name, *map(str, arguments)],
        env={**os.environ, "GRADMESH_BUILD": str(BUILD)},
        capture_output=True,
        text=True,
        timeout=300,
    )


def install(folder, *options):
    """Installs what was built below `folder` as `cmake --install` does."""
    subprocess.run(
        ["cmake", "--install", str(BUILD), *options],
        env={**os.environ, "DESTDIR": str(folder)},
        check=True,
        capture_output=True,
    )


def install_extension(folder):
    """Installs the extension below `folder`; its own folder there."""
    install(folder, "--component", "extension")
    (inx,) = Path(folder).rglob("gradmesh_simplify.inx")
    return inx.parent
