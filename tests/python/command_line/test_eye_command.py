"""The command gradmesh eye: its window without a display, and what it refuses. What a person does there is tested in
tests/native/window/ and, in Inkscape, in test_eye_window.py."""

import os
import re
import shutil
import signal
import subprocess
import time

import pytest

import displays
import inkscape_harness
from built import BUILD, SAMPLES
from program import listed, refused

TWO = SAMPLES / "two.svg"
NOWHERE = {"SDL_VIDEODRIVER": "x11", "DISPLAY": ""}


def test_without_a_display_a_sentence_says_so():
    said = refused("eye", TWO, env=NOWHERE)
    assert said.startswith("no window can be shown here: ")
    german = refused("eye", TWO, "--language", "de", env=NOWHERE)
    assert german.startswith("hier kann kein Fenster gezeigt werden: ")


def test_what_cannot_be_looked_at_is_named(tmp_path):
    assert "none.svg cannot be read" in refused("eye", tmp_path / "none.svg", env=NOWHERE)
    assert "nobody" in refused("eye", TWO, "--id", "nobody", env=NOWHERE)


def catches_termination(process):
    """Whether SIGTERM no longer ends the process as any other: once there is a window."""
    with open(f"/proc/{process}/status", encoding="ascii") as status:
        (caught,) = [int(line.split()[1], 16) for line in status if line.startswith("SigCgt:")]
    return bool(caught & 1 << signal.SIGTERM - 1)


def test_it_waits_for_a_person_and_ends_when_told(tmp_path):
    """On SDL's driver that needs no display, which nobody can click at."""
    svg = tmp_path / "two.svg"
    svg.write_bytes(TWO.read_bytes())
    folder = tmp_path / "data"
    env = {**os.environ, "SDL_VIDEODRIVER": "dummy", "XDG_DATA_HOME": str(folder)}
    end = time.monotonic() + 60
    with subprocess.Popen([BUILD / "gradmesh", "eye", svg], env=env, stderr=subprocess.PIPE, text=True) as running:
        try:
            while not catches_termination(running.pid):
                assert running.poll() is None and time.monotonic() < end
                time.sleep(0.05)
            running.terminate()
            assert running.communicate(timeout=60) == (None, "")
        finally:
            running.kill()
    assert running.returncode == 0
    assert svg.read_bytes() == TWO.read_bytes()
    assert (folder / "gradmesh" / "by-eye").read_text().startswith("width ")


MISSING = inkscape_harness.missing("Xvfb", "xdotool")


@pytest.mark.skipif(bool(MISSING), reason=MISSING or "nothing is missing")
def test_what_was_made_is_kept_where_it_cannot_be_written(tmp_path):
    """The folder goes while somebody works in the window."""
    out, kept = tmp_path / "gone" / "out.svg", tmp_path / "kept"
    out.parent.mkdir()
    kept.mkdir()
    (kept / "out-by-eye-1.svg").write_text("of another day")
    with displays.Display() as display:
        env = {**os.environ, "DISPLAY": display.name, "SDL_VIDEODRIVER": "x11", "TMPDIR": str(kept)}
        env.update(XDG_DATA_HOME=str(tmp_path / "data"), LANGUAGE="en")

        def xdotool(*arguments):
            done = subprocess.run(["xdotool", *arguments], env=env, capture_output=True, text=True, timeout=60)
            return done.stdout.split()

        command = [BUILD / "gradmesh", "eye", TWO, "-o", out]
        end = time.monotonic() + 120
        with subprocess.Popen(command, env=env, stderr=subprocess.PIPE, text=True) as running:
            try:
                while not (windows := xdotool("search", "--onlyvisible", "--name", "Simplify by Eye")):
                    assert running.poll() is None and time.monotonic() < end
                    time.sleep(0.1)
                shutil.rmtree(out.parent)
                # Apply does nothing until the slider has a curve to go along.
                while running.poll() is None:
                    assert time.monotonic() < end
                    xdotool("windowfocus", windows[0], "key", "--delay", "50", "End", "ctrl+Return")
                    time.sleep(0.2)
                said = running.communicate(timeout=60)[1]
            finally:
                running.kill()
    assert running.returncode == 1
    sentence = r"gradmesh: (.*)/out.svg cannot be written: .*\. What was made is kept in (.*)\.\n"
    match = re.fullmatch(sentence, said)
    assert match and match[1] == str(out.parent) and match[2] == str(kept / "out-by-eye-2.svg")
    assert sorted(path.name for path in kept.iterdir()) == ["out-by-eye-1.svg", "out-by-eye-2.svg"]
    before, after = (sum(mesh["handles"] for mesh in listed(svg)["meshes"]) for svg in (TWO, kept / "out-by-eye-2.svg"))
    assert after < before
