"""Programs on a display of their own, with hard time limits: past these, all that they have started ends."""

import os
import shutil
import signal
import subprocess
import tempfile
from pathlib import Path
from typing import Mapping, Sequence

SCREEN = (1400, 1000)
WINDOW_PROGRAMS = ("xdotool", "import")


class Timeout(AssertionError):
    """Inkscape did not end in time; it and everything it started has been killed."""


def kill_group(process: subprocess.Popen) -> None:
    """Ends a process started with `start_new_session` and everything it started.

    The group outlives its leader, so it is signalled even where the leader has ended.
    """
    for sign in (signal.SIGTERM, signal.SIGKILL):
        try:
            os.killpg(process.pid, sign)
        except ProcessLookupError:
            pass
        try:
            process.wait(timeout=5)
        except subprocess.TimeoutExpired:
            pass


def is_busy(session: int, others_end: bool = True) -> bool:
    """Whether a process that was started with `start_new_session` works, or waits for a processor or
    a disk, or has started others that have not ended; where those have windows and wait for a person
    (`others_end` is false), whether they work."""
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _parent, _group, its_session = stat.read_text().rpartition(")")[2].split()[:4]
            if int(its_session) != session or state == "Z":
                continue
            if others_end and stat.parent.name != str(session):
                return True
            threads = [task.read_text() for task in stat.parent.glob("task/*/stat")]
        except OSError:  # it has ended meanwhile
            continue
        if any(thread.rpartition(")")[2].split()[0] in "RD" for thread in threads):
            return True
    return False


def run(command: Sequence[str], env: Mapping[str, str], timeout: float) -> subprocess.CompletedProcess:
    """Runs a command in its own process group; past `timeout` seconds the whole group is killed."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        # Files, not pipes: a grandchild that keeps a pipe open would block the reader.
        process = subprocess.Popen(
            command,
            env=env,
            stdin=subprocess.DEVNULL,
            stdout=out,
            stderr=err,
            start_new_session=True,
        )
        expired = ""
        try:
            process.wait(timeout=timeout)
        except subprocess.TimeoutExpired:
            expired = seen(env) or "nothing is known of its display"
        finally:
            kill_group(process)
        texts = []
        for stream in (out, err):
            stream.seek(0)
            texts.append(stream.read().decode(errors="replace"))
    if expired:
        raise Timeout(
            f"no end after {timeout:g} s (an extension that writes to stderr opens a dialog, which "
            f"waits for ever): {' '.join(command)}; {expired}\n{texts[0]}{texts[1]}"
        )
    return subprocess.CompletedProcess(command, process.returncode, *texts)


def seen(env: Mapping[str, str]) -> str:
    """What is to be seen on the display, for the message of a test that gives up: the windows' titles, and the
    path of a picture of it. Empty where there is no display or nothing to look with."""
    if not env.get("DISPLAY") or not all(map(shutil.which, WINDOW_PROGRAMS)):
        return ""

    def answer(*command: str) -> str:
        return subprocess.run(command, env=env, capture_output=True, text=True, timeout=20).stdout.strip()

    handle, shot = tempfile.mkstemp(prefix="seen-", suffix=".png")
    os.close(handle)
    try:
        windows = answer("xdotool", "search", "--onlyvisible", "--name", ".").split()
        titles = [answer("xdotool", "getwindowname", window) for window in windows]
        answer("import", "-window", "root", shot)
    except subprocess.TimeoutExpired:
        return ""
    return f"open: {', '.join(titles) or 'no window'}; the display: {shot}"


class Display:
    """One private Xvfb on a display number that it finds itself; `name` is its DISPLAY."""

    def __enter__(self) -> "Display":
        read_end, write_end = os.pipe()
        width, height = SCREEN
        self._memory = tempfile.TemporaryDirectory(prefix="display-")
        self._process = subprocess.Popen(
            # Without a pointer: over a busy program it turns, and the display never stays the same.
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{width}x{height}x24"]
            + ["-fbdir", self._memory.name, "-nocursor", "-nolisten", "tcp"],
            pass_fds=[write_end],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        os.close(write_end)
        with os.fdopen(read_end) as pipe:
            number = pipe.readline().strip()  # ends with the number, or empty if Xvfb dies
        if not number:
            self.__exit__()
            raise RuntimeError("Xvfb did not start")
        self.name = f":{number}"
        return self

    def __exit__(self, *_) -> None:
        kill_group(self._process)
        self._memory.cleanup()

    def pixels(self) -> bytes:
        """What the display shows at this moment, without starting a program to look: the file in which Xvfb
        holds it."""
        return (Path(self._memory.name) / "Xvfb_screen0").read_bytes()
