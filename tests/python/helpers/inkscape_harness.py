"""Drives the real Inkscape without a person: private display, private profile, hard time limits.

    with Inkscape(values={"org.example.name.threshold": "0.01"}) as inkscape:
        inkscape.install("extension/example.inx", "extension/example.py")
        inkscape.run_extension("org.example.name", "in.svg", "out.svg", select=["pear"])
        inkscape.export_png("out.svg", "out.png", width=800)
        said = inkscape.said_by_extension("org.example.name", "in.svg", "out.svg")
        with inkscape.window("out.svg") as window:
            window.key("5")
            window.screenshot("shot.png")

Inkscape's exit status says nothing: without a display it writes the file unchanged and exits 0.
Look at what it wrote.

The environment variable GRADMESH_INKSCAPE names the program, to test with another version.
"""

import functools
import os
import re
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Mapping, Optional, Sequence, Tuple
from xml.sax.saxutils import quoteattr

INKSCAPE = os.environ.get("GRADMESH_INKSCAPE", "inkscape")
SCREEN = (1400, 1000)


def missing(*programs: str) -> str:
    """Why Inkscape (and the further `programs`) cannot be driven here; empty if it can."""
    absent = [p for p in (INKSCAPE, "Xvfb", *programs) if shutil.which(p) is None]
    return f"not installed: {', '.join(absent)}" if absent else ""


@functools.lru_cache(maxsize=None)
def version() -> Tuple[int, ...]:
    """The version of Inkscape, such as (1, 2, 2)."""
    told = subprocess.run([INKSCAPE, "--version"], capture_output=True, text=True, timeout=60).stdout
    return tuple(map(int, re.search(r"Inkscape (\d+(?:\.\d+)*)", told)[1].split(".")))


def is_older_than(*wanted: int) -> bool:
    """Whether the Inkscape that is installed is older; true also where there is none."""
    return bool(missing()) or version() < wanted


def undoes_in_batch_runs() -> bool:
    """Whether the action `undo` takes an extension's change back where there is no window; in 1.4 it takes
    nothing back there, and Ctrl+Z in the window does."""
    return is_older_than(1, 4)


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
    if not env.get("DISPLAY") or missing(*WINDOW_PROGRAMS):
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


def preferences(values: Mapping[str, str]) -> str:
    """The text of a preferences.xml that holds extension values, `raw.id.parameter` to value."""
    attributes = " ".join(f"{name}={quoteattr(str(value))}" for name, value in values.items())
    return (
        '<?xml version="1.0" encoding="UTF-8" standalone="no"?>\n'
        '<inkscape version="1">\n'
        '<group id="options"><group id="boot" enabled="0"/></group>\n'
        f'<group id="extensions" {attributes}/>\n'
        "</inkscape>\n"
    )


class Inkscape:
    """Inkscape with its own profile, on its own display or on the existing `display`.

    `values` presets extension parameters (see `preferences`); `timeout` is in seconds, per call.
    """

    def __init__(
        self,
        values: Optional[Mapping[str, str]] = None,
        display: Optional[str] = None,
        timeout: float = 120,
    ):
        self.timeout = timeout
        self._values = dict(values or {})
        self._display = None if display else Display()
        self._display_name = display

    def __enter__(self) -> "Inkscape":
        self.home = Path(tempfile.mkdtemp(prefix="inkscape-"))
        self.extensions = self.home / "profile" / "extensions"
        self.extensions.mkdir(parents=True)
        self.set_values(self._values)
        # A blinking cursor or an animation would keep a window from ever looking settled. On a busy
        # machine the two clicks of one double click are far apart; others are so by settle().
        gtk = self.home / "config" / "gtk-3.0" / "settings.ini"
        gtk.parent.mkdir(parents=True)
        settings = ("cursor-blink=false", "enable-animations=false", "double-click-time=1000")
        gtk.write_text("\n".join(["[Settings]", *(f"gtk-{setting}" for setting in settings)]))
        if self._display:
            try:
                self._display_name = self._display.__enter__().name
            except BaseException:
                shutil.rmtree(self.home)
                raise
        return self

    def __exit__(self, *details) -> None:
        if self._display:
            self._display.__exit__(*details)
        shutil.rmtree(self.home, ignore_errors=True)

    @property
    def env(self) -> Mapping[str, str]:
        """The environment of every program started here; nothing of the user's own is touched."""
        return {
            **os.environ,
            "DISPLAY": self._display_name,
            "INKSCAPE_PROFILE_DIR": str(self.home / "profile"),
            "XDG_CONFIG_HOME": str(self.home / "config"),
            "XDG_DATA_HOME": str(self.home / "data"),
            "XDG_CACHE_HOME": str(self.home / "cache"),
            "GDK_BACKEND": "x11",
            "GSETTINGS_BACKEND": "memory",
            "GIO_USE_VFS": "local",
            "NO_AT_BRIDGE": "1",
            "DBUS_SESSION_BUS_ADDRESS": "disabled:",
        }

    def pixels(self) -> bytes:
        """What its display shows; only a display of its own can be looked at."""
        return self._display.pixels()

    def set_values(self, values: Mapping[str, str]) -> None:
        """Replaces all preset extension parameters."""
        self._values = dict(values)
        file = self.home / "profile" / "preferences.xml"
        file.write_text(preferences(values), encoding="utf-8")

    def set_key(self, key: str, action: str) -> None:
        """Lets a key of Inkscape's windows, by its X name, run an action such as "app.redo"."""
        file = self.home / "profile" / "keys" / "default.xml"
        file.parent.mkdir(exist_ok=True)
        file.write_text(
            '<?xml version="1.0"?>\n'
            f'<keys name="Test"><bind gaction={quoteattr(action)} keys={quoteattr(key)}/></keys>\n'
        )

    def install(self, *sources) -> None:
        """Copies files or folders into the profile's `extensions` folder."""
        for source in map(Path, sources):
            if source.is_dir():
                shutil.copytree(source, self.extensions / source.name, dirs_exist_ok=True)
            else:
                shutil.copy(source, self.extensions)

    def run_actions(
        self, svg_in, actions: Sequence[str], timeout: Optional[float] = None
    ) -> subprocess.CompletedProcess:
        """Opens `svg_in`, or several in turn, and runs `actions` one after the other on each; Timeout
        past `timeout` seconds."""
        documents = map(str, [svg_in] if isinstance(svg_in, (str, Path)) else svg_in)
        command = [INKSCAPE, "--batch-process", "--actions=" + ";".join(actions), *documents]
        return run(command, self.env, timeout or self.timeout)

    def run_extension(
        self, raw_id: str, svg_in, svg_out, select: Sequence[str] = (), timeout: Optional[float] = None
    ) -> subprocess.CompletedProcess:
        """Runs an extension with the preset values on the objects `select`; writes `svg_out`."""
        actions = [f"select-by-id:{','.join(select)}"] if select else []
        actions += [raw_id.replace("_", "-") + ".noprefs"]
        actions += [f"export-filename:{svg_out}", "export-do"]
        return self.run_actions(svg_in, actions, timeout)

    def said_by_extension(self, *arguments, **how) -> str:
        """Runs an extension as `run_extension` does; what it says, which a dialog would show.

        Inkscape would wait for ever for somebody to close the dialog, so it never gets to know.
        gradmesh gets to know that somebody listens.
        """
        said, python = self.home / "said", self.home / "python-with-said"
        run_python = 'GRADMESH_UNATTENDED=0 exec /usr/bin/python3 "$@"'
        python.write_text(f'#!/bin/sh\n{run_python} 2>"{said}"\n')
        python.chmod(0o755)
        values = self._values
        self.set_values({**values, "python-interpreter": str(python)})
        try:
            self.run_extension(*arguments, **how)
        finally:
            self.set_values(values)
        return said.read_text()

    def export_png(
        self,
        svg,
        png,
        dpi: Optional[float] = None,
        width: Optional[int] = None,
        area: Optional[Sequence[float]] = None,
        only: Optional[str] = None,
        timeout: Optional[float] = None,
    ) -> Path:
        """Renders the page, or `area` (x0, y0, x1, y1 in user units), or just the object `only`."""
        command = [INKSCAPE, "--export-type=png", f"--export-filename={png}"]
        if dpi is not None:
            command.append(f"--export-dpi={dpi:g}")
        if width is not None:
            command.append(f"--export-width={width}")
        if area is not None:
            command.append("--export-area=" + ":".join(f"{v:g}" for v in area))
        if only is not None:
            command += [f"--export-id={only}", "--export-id-only"]
        elif area is None:
            command.append("--export-area-page")
        Path(png).unlink(missing_ok=True)
        done = run([*command, str(svg)], self.env, timeout or self.timeout)
        if not Path(png).exists():
            raise AssertionError(f"Inkscape wrote no picture of {svg}: {done.stderr}")
        return Path(png)

    def export_pages(
        self, documents: Mapping[Path, Path], dpi: Mapping[Path, float], timeout: Optional[float] = None
    ) -> Mapping[Path, str]:
        """Paints the page of each document to its picture, all by one Inkscape that reads commands. Returns why
        there is no picture, for each document that has none; `timeout` is in seconds, for all together.

        Where Inkscape crashes, that is told of the document after the last one that it has painted, and
        another Inkscape goes on behind that one. Paths have no semicolon, which separates commands.
        """
        end = time.monotonic() + (timeout or self.timeout)
        for png in documents.values():
            Path(png).unlink(missing_ok=True)
        unpainted, left = {}, list(documents)
        while left:
            ended = self._paint_pages({svg: documents[svg] for svg in left}, dpi, end)
            painted = [i for i, svg in enumerate(left) if Path(documents[svg]).exists()]
            reached = painted[-1] + 1 if painted else 0
            behind = reached + 1 if ended else len(left)
            for i, svg in enumerate(left[:behind]):
                if i not in painted:
                    unpainted[svg] = ended if i == reached and ended else "Inkscape wrote no picture"
            left = left[behind:]
            if time.monotonic() >= end:
                unpainted.update(dict.fromkeys(left, "there was no time left for it"))
                break
        return unpainted

    def _paint_pages(self, documents: Mapping[Path, Path], dpi: Mapping[Path, float], end: float) -> str:
        """Has one Inkscape paint pages, until `end`; how it ended before it should, or nothing."""
        lines = [
            f"file-open:{svg}; export-filename:{png}; export-dpi:{dpi[svg]:g}; export-area-page; export-do; file-close"
            for svg, png in documents.items()
        ]
        with tempfile.TemporaryFile() as commands:
            commands.write("\n".join([*lines, "quit", ""]).encode())
            commands.seek(0)
            process = subprocess.Popen(
                [INKSCAPE, "--shell"],
                env=self.env,
                stdin=commands,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                start_new_session=True,
            )
            try:
                process.wait(max(0, end - time.monotonic()))
            except subprocess.TimeoutExpired:
                return "Inkscape did not end in time"
            finally:
                kill_group(process)
        return f"Inkscape crashed ({process.returncode})" if process.returncode else ""

    def window(self, svg, timeout: Optional[float] = None, actions: Sequence[str] = ()) -> "InkscapeWindow":
        """Its window over a document, on which these actions have run."""
        return InkscapeWindow(self, svg, timeout or self.timeout, actions)

    def undone_in_window(self, svg, actions: Sequence[str]) -> Tuple[bytes, bytes]:
        """What the file is after actions, one undo and saving, and after redo and saving; undone as far as to what
        was opened Inkscape saves nothing."""
        files = []
        with self.window(svg, actions=actions) as window:
            for key in ("ctrl+z", "ctrl+shift+z"):
                window.key(key)
                window.key("ctrl+s")
                files.append(Path(svg).read_bytes())
        return files[0], files[1]


class Started:
    """A program on a display, with all that it starts, until the end of the block."""

    def __init__(self, command: Sequence, env: Mapping[str, str], timeout: float):
        self._command, self._env, self._timeout = list(map(str, command)), env, timeout

    def __enter__(self):
        self._process = subprocess.Popen(
            self._command,
            env=self._env,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        return self

    def __exit__(self, *_) -> None:
        kill_group(self._process)

    def xdotool(self, *arguments: str) -> str:
        return run(["xdotool", *arguments], self._env, 20).stdout

    def find_window(self, name: str) -> str:
        """Waits for a window whose title holds `name`."""
        end = time.monotonic() + self._timeout
        while time.monotonic() < end and self._process.poll() is None:
            found = self.xdotool("search", "--onlyvisible", "--name", name).split()
            if found:
                return found[0]
            time.sleep(0.2)
        raise Timeout(f"there is no window {name}: {self._command}; {seen(self._env)}")

    def titles(self) -> Sequence[str]:
        """The titles of the windows that are to be seen."""
        windows = self.xdotool("search", "--onlyvisible", "--name", ".").split()
        return [self.xdotool("getwindowname", window).strip() for window in windows]

    def property(self, window: str, name: str) -> str:
        """The value of a window's property as X11 has it; of the display's, if `window` is "root"."""
        which = ["-root"] if window == "root" else ["-id", window]
        said = run(["xprop", *which, name], self._env, 20).stdout
        return said.replace("=", "#").rpartition("#")[2].strip()

    def wait(self) -> None:
        """Waits until the program has ended by itself."""
        self._process.wait(self._timeout)


class InkscapeWindow(Started):
    """A document open in Inkscape's own window, filling the display; positions are its pixels."""

    def __init__(self, inkscape: Inkscape, svg, timeout: float, actions: Sequence[str] = ()):
        run = ["--with-gui", "--actions=" + ";".join(actions)] if actions else []
        super().__init__([INKSCAPE, *run, svg], inkscape.env, timeout)
        self._look = inkscape.pixels
        self._svg = Path(svg)
        self.is_asking = False

    def __enter__(self) -> "InkscapeWindow":
        super().__enter__()
        try:
            window = self.find_window(self._svg.name)
            self.xdotool("windowmove", window, "0", "0")
            self.xdotool("windowsize", window, *map(str, SCREEN))
            self.xdotool("windowfocus", window)
            self.settle()
        except BaseException:
            kill_group(self._process)
            raise
        return self

    def settle(self) -> None:
        """Waits until Inkscape, and all that it has started, has nothing left to do and the screen
        stays the same. A screen that stays the same alone may be of an Inkscape that is busy."""
        end = time.monotonic() + self._timeout
        before, same = None, 0
        while same < 3:
            if time.monotonic() > end:
                raise Timeout(f"the window of {self._svg} keeps changing; {seen(self._env)}")
            time.sleep(0.3)
            now = None if is_busy(self._process.pid, not self.is_asking) else self._look()
            same = same + 1 if now and now == before else 0
            before = now

    def key(self, *keys: str) -> None:
        """Presses keys by their X names, such as "5", "ctrl+a", "Escape"."""
        self.xdotool("key", "--delay", "100", *keys)
        self.settle()

    def open_window(self, key: str, title: str) -> None:
        """Presses a key that lets an extension show a window of its own, which then is in the upper
        left corner and has the keys; close_window() says that it is to have gone."""
        self.is_asking = True
        self.key(key)
        own = self.find_window(title)
        self.xdotool("windowmove", own, "0", "0")
        self.xdotool("windowfocus", own)
        self.settle()

    def close_window(self) -> None:
        """Waits until Inkscape has taken what that window left, and gives Inkscape the keys."""
        self.is_asking = False
        self.settle()
        self.xdotool("windowfocus", self.find_window(self._svg.name))

    def click(self, x: int, y: int, button: int = 1, repeat: int = 1) -> None:
        self.xdotool("mousemove", str(x), str(y))
        self.xdotool("click", "--repeat", str(repeat), "--delay", "80", str(button))
        self.settle()

    def double_click(self, x: int, y: int) -> None:
        self.click(x, y, repeat=2)

    def drag(self, x: int, y: int, to_x: int, to_y: int) -> None:
        self.xdotool("mousemove", str(x), str(y), "mousedown", "1")
        for i in range(1, 6):  # a single jump would be a click to Inkscape
            at = (str(round(a + (b - a) * i / 5)) for a, b in ((x, to_x), (y, to_y)))
            self.xdotool("mousemove", *at)
            time.sleep(0.1)
        self.settle()  # or a busy Inkscape would end the drag before its last step
        self.xdotool("mouseup", "1")
        self.settle()

    def screenshot(self, path) -> Path:
        """Writes the whole display; the name's ending says the format."""
        run(["import", "-window", "root", str(path)], self._env, 30)
        if not Path(path).exists():
            raise AssertionError(f"no screenshot was written to {path}")
        return Path(path)
