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
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Mapping, Optional, Sequence, Tuple
from xml.sax.saxutils import quoteattr

from displays import Display, kill_group, run
from windows import InkscapeWindow

INKSCAPE = os.environ.get("GRADMESH_INKSCAPE", "inkscape")


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
        run_actions = ["--with-gui", "--actions=" + ";".join(actions)] if actions else []
        command = [INKSCAPE, *run_actions, svg]
        return InkscapeWindow(command, svg, self.env, timeout or self.timeout, self.pixels)

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
