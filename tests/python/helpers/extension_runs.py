"""Fixtures that run the installed extension as Inkscape does, without Inkscape."""

import os
import subprocess
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from built import PYTHON, install_extension

INKEX = Path(os.environ.get("GRADMESH_INKEX", "/usr/share/inkscape/extensions"))
SVG = "{http://www.w3.org/2000/svg}"
#: What suffices where it does not matter at how many pixels a mesh is measured.
SMALL = "--resolution=100"


@pytest.fixture(scope="module")
def extension(tmp_path_factory):
    """The installed folder of the extension."""
    return install_extension(tmp_path_factory.mktemp("installed"))


@pytest.fixture
def run(extension, tmp_path):
    """Runs the extension on a text, bytes or a file with these options, as Inkscape does."""

    def run(
        document,
        *options,
        item="simplify",
        path="/home/somebody/apple.svg",
        python=(PYTHON,),
        **env,
    ):
        copy = tmp_path / "ink_ext_XXXXXX.svgABC123"
        if isinstance(document, bytes):
            copy.write_bytes(document)
        else:
            copy.write_text(document if isinstance(document, str) else document.read_text())
        return subprocess.run(
            [*python, f"gradmesh_{item}.py", *options, str(copy)],
            cwd=extension,
            env={
                **os.environ,
                "PYTHONPATH": f"{extension.parent}{os.pathsep}{INKEX}",
                "DOCUMENT_PATH": path,
                "XDG_CACHE_HOME": str(tmp_path / "cache"),
                "LANGUAGE": "en",
                "DISPLAY": "",  # no window beside long work
                **env,
            },
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=120,
        )

    return run


def by_id(text):
    return {element.get("id"): element for element in ET.fromstring(text).iter()}


def is_one_sentence(text):
    return text.endswith(".\n") and text.count("\n") == 1 and "Traceback" not in text


def refused(done):
    """The sentence of a run that left the document alone: Inkscape keeps it where stdout is empty."""
    assert done.returncode != 0
    assert done.stdout == ""
    assert is_one_sentence(done.stderr), done.stderr
    assert "ink_ext" not in done.stderr  # Inkscape's name for its copy tells nobody anything
    return done.stderr
