"""The command gradmesh eye: its window without a display, and what it refuses. What a person does there is tested in
tests/native/window/ and, in Inkscape, in test_eye_window.py."""

import os
import signal
import subprocess
import time

from built import BUILD, SAMPLES
from program import refused

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
