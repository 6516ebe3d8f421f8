"""Windows of programs, driven by keys and a pointer as a person drives them."""

import subprocess
import time
from pathlib import Path
from typing import Callable, Mapping, Sequence

from displays import SCREEN, Timeout, is_busy, kill_group, run, seen


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

    def __init__(self, command: Sequence, svg, env: Mapping[str, str], timeout: float, look: Callable[[], bytes]):
        """The command opens `svg`; `look` gives what the display shows."""
        super().__init__(command, env, timeout)
        self._look = look
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
