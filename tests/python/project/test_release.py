"""The version is written down once, and a release has a date (scripts/release)."""

import os
import shutil
import subprocess

import pytest

from built import ROOT


def say_version(folder):
    return subprocess.run([folder / "scripts" / "release", "--version"], capture_output=True, text=True)


@pytest.fixture
def sources(tmp_path):
    """What scripts/release --version reads, where nothing is built."""
    for name in ("CMakeLists.txt", "CHANGELOG.md", "scripts/release"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    return tmp_path


def test_all_that_has_a_version_has_the_same():
    said = say_version(ROOT)
    assert (said.returncode, said.stderr) == (0, "")


@pytest.mark.parametrize("entry", ["0.1.9 (2026-01-01)", "{version}", "{version} (soon)"])
@pytest.mark.full(all_but=1)
def test_changes_of_another_version_are_refused(sources, entry):
    version = say_version(ROOT).stdout.strip()
    entry = entry.format(version=version)
    (sources / "CHANGELOG.md").write_text(f"# Changes\n\n## {entry}\n")
    said = say_version(sources)
    assert said.returncode == 1
    assert said.stderr == f'CMakeLists.txt has version {version}, and CHANGELOG.md begins with "## {entry}".\n'


def test_a_release_needs_a_date(sources):
    version = say_version(ROOT).stdout.strip()
    (sources / "CHANGELOG.md").write_text(f"# Changes\n\n## {version} (unreleased)\n")
    assert say_version(sources).stdout == f"{version}\n"
    shutil.copy(ROOT / "scripts" / "parts.sh", sources / "scripts")
    shutil.copy(ROOT / "scripts" / "summary.py", sources / "scripts")
    # These tests are a part of a run themselves, whose summary is not about that one (scripts/parts.sh).
    alone = {name: value for name, value in os.environ.items() if not name.startswith("GRADMESH_PARTS")}
    said = subprocess.run([sources / "scripts" / "release"], capture_output=True, text=True, env=alone)
    assert said.returncode == 1 and f"CHANGELOG.md says no date for {version}." in said.stdout
