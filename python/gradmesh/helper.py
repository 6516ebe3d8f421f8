"""The program `gradmesh helper` beside Python, which does what the compiled module does.

A program does not care which Python calls it. What both say to each other is in docs/reference/helper.md.
"""

from __future__ import annotations

import atexit
import base64
import json
import math
import operator
import os
import platform
import queue
import stat
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any, BinaryIO, Callable, Optional, Tuple

from .errors import HelperError, NoCoreError, ended
from .interrupts import Interrupts

#: The name of the environment variable that names the program.
PROGRAM = "GRADMESH_HELPER"
#: After so many seconds without a sign of life the program is given up.
SILENCE = float(os.environ.get("GRADMESH_HELPER_SILENCE", 30))
MOST_DIGITS = 10
MOST_BYTES = 1 << 30

SYSTEMS = {"linux": "linux", "win32": "windows", "darwin": "macos"}
MACHINES = {"amd64": "x86_64", "x86_64": "x86_64", "arm64": "arm64", "aarch64": "arm64"}


def find_program() -> Optional[Path]:
    """Returns the program for this system: the one that GRADMESH_HELPER names, or that beside the
    package, in bin/SYSTEM-MACHINE; nothing where there is none, or an empty file."""
    if os.environ.get(PROGRAM):
        return Path(os.environ[PROGRAM])
    program = _program_beside()
    return program if program.is_file() and program.stat().st_size > 0 else None


def no_program() -> NoCoreError:
    """Returns what is raised where there is no program for this system, with why that may be."""
    program = _program_beside()
    others = sorted(folder.name for folder in program.parents[1].glob("*-*"))
    if others and program.parent.name not in others:
        return NoCoreError(
            "This gradmesh has no program for this system, {0}, only for {1}: build it from its source, as its "
            "README says.",
            program.parent.name,
            ", ".join(others),
        )
    return NoCoreError(
        "The program {0}, which does gradmesh's work, is not there or empty; a virus scanner may have taken it: "
        "tell that to leave it alone, and install gradmesh again.",
        program,
    )


def _program_beside() -> Path:
    """Returns where the program for this system belongs."""
    system = SYSTEMS.get(sys.platform, sys.platform)
    machine = MACHINES.get(platform.machine().lower(), platform.machine().lower())
    name = "gradmesh.exe" if system == "windows" else "gradmesh"
    return Path(__file__).resolve().parent.parent / "bin" / f"{system}-{machine}" / name


class Helper:
    """A running program, as _core.Service: one call at a time, whichever thread it comes from."""

    def __init__(self, program: Path, protocol: int):
        """protocol: the version of the functions that the program must have."""
        self._program = program
        self._protocol = protocol
        self._one_call = threading.Lock()
        self._caller: Optional[int] = None
        self._process: Optional[subprocess.Popen] = None
        #: The process that has started the program; one that it forked cannot use it.
        self._owner = os.getpid()
        self._has_ended = False
        self._heard: queue.SimpleQueue = queue.SimpleQueue()
        self._to_say: queue.SimpleQueue = queue.SimpleQueue()

    @property
    def has_failed(self) -> bool:
        """Whether it cannot be called any more."""
        return self._has_ended or self._owner != os.getpid()

    def call(self, request: dict, ask: Callable[[dict], Any]) -> dict:
        """Returns the outcome of a request. Raises HelperError, and what `ask` raises."""
        if self._caller == threading.get_ident():
            raise RuntimeError("gradmesh is at work, and what it calls cannot ask it for more")
        words = message_bytes({**request, "folder": current_folder()})
        with self._one_call, Interrupts() as interrupts:
            self._caller = threading.get_ident()
            try:
                outcome, raised = self._converse(words, ask, interrupts)
            except BaseException:
                self._end()
                raise
            finally:
                self._caller = None
        if raised is not None:
            raise raised
        return outcome

    def _converse(
        self, request: bytes, ask: Callable[[dict], Any], interrupts: Interrupts
    ) -> Tuple[dict, Optional[BaseException]]:
        """Returns the outcome, and what has given the call up: what `ask` has raised, or Ctrl+C."""
        if self.has_failed:
            raise ended()
        if self._process is None:
            self._start()
        raised: Optional[BaseException] = None
        self._to_say.put(request)
        while True:
            heard = self._hear()
            if "ask" not in heard:
                return heard, raised
            answer = message_bytes({"give_up": True})
            if raised is None:
                try:
                    with interrupts.allowed():
                        answer = message_bytes({"answer": ask(heard)})
                except BaseException as error:  # pylint: disable=broad-except
                    raised = error
            self._to_say.put(answer)

    def _start(self) -> None:
        make_executable(self._program)
        # In a group of its own, as Ctrl+C is for Python alone; Windows would also open a console.
        how: dict = {"start_new_session": True}
        if sys.platform == "win32":
            flags = subprocess.CREATE_NO_WINDOW | subprocess.CREATE_NEW_PROCESS_GROUP
            how = {"creationflags": flags}
        try:
            self._process = subprocess.Popen(
                [str(self._program), "helper"],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                **how,
            )
        except OSError as error:
            raise HelperError(
                "Nothing was done because the program {0}, which gradmesh needs, cannot be started ({1}): "
                "install gradmesh in a folder from which programs may be run.",
                self._program,
                error.strerror,
            ) from error
        # Threads of their own, so that a program that neither reads nor writes never holds up this one.
        self._threads = [
            threading.Thread(target=work, args=(self._process,), daemon=True)
            for work in (self._listen, self._speak)
        ]
        for thread in self._threads:
            thread.start()
        atexit.register(self._end)
        self._to_say.put(message_bytes({"call": "hello", "arguments": {}}))
        hello = self._hear().get("result")
        spoken = hello.get("protocol") if isinstance(hello, dict) else None
        if spoken != self._protocol:
            raise HelperError(
                "Nothing was done because the program {0} is of another version than the rest of gradmesh "
                "({1}, not {2}): install gradmesh again.",
                self._program,
                spoken,
                self._protocol,
            )

    def _listen(self, process: subprocess.Popen) -> None:
        try:
            with process.stdout as stream:
                message = read_message(stream)
                while message is not None:
                    self._heard.put(message)
                    message = read_message(stream)
        except (ValueError, OSError) as error:
            self._heard.put(error)
        self._heard.put(None)

    def _speak(self, process: subprocess.Popen) -> None:
        try:
            with process.stdin as stream:
                for message in iter(self._to_say.get, None):
                    stream.write(message)
                    stream.flush()
        except OSError:
            pass  # It has ended, as whoever listens finds out too.

    def _hear(self) -> dict:
        """Returns what the program says next, but that it is alive."""
        while True:
            try:
                message = self._heard.get(timeout=SILENCE)
            except queue.Empty:
                raise HelperError(
                    "Nothing was done because gradmesh's helper program did not answer for {0} seconds.",
                    f"{SILENCE:g}",
                ) from None
            if message is None:
                raise HelperError(
                    "Nothing was done because gradmesh's helper program ended before its work was done."
                )
            if not makes_sense(message):
                raise HelperError(
                    "Nothing was done because gradmesh's helper program gave an answer that makes no sense."
                )
            if not message.get("alive"):
                return message

    def _end(self) -> None:
        """Ends the program, at work or not."""
        self._has_ended = True
        atexit.unregister(self._end)
        if self._process is None or self._owner != os.getpid():
            return
        self._to_say.put(None)
        self._process.kill()
        self._process.wait()
        self._process = None
        # They close its pipes.
        for thread in self._threads:
            thread.join()


def current_folder() -> Optional[str]:
    """Returns where relative paths begin; nothing where that folder has been deleted."""
    try:
        return os.getcwd()
    except FileNotFoundError:
        return None


def makes_sense(message: Any) -> bool:
    """Returns whether it is something that a program says (docs/reference/helper.md)."""
    if not isinstance(message, dict):
        return False
    if "ask" in message or "result" in message or "alive" in message:
        return True
    if message.get("error") == "input":
        return is_message(message.get("message"))
    return isinstance(message.get("error"), str) and isinstance(message.get("text"), str)


def is_message(value: Any) -> bool:
    """Returns whether it is a template and a list of what goes there."""
    return (
        isinstance(value, list)
        and len(value) == 2
        and isinstance(value[0], str)
        and isinstance(value[1], list)
        and all(isinstance(part, str) or is_message(part) for part in value[1])
    )


def make_executable(program: Path) -> None:
    """Sets the bit that says so, which unpacking an archive may have lost."""
    if sys.platform == "win32" or os.access(program, os.X_OK):
        return
    try:
        program.chmod(program.stat().st_mode | stat.S_IXUSR | stat.S_IXGRP | stat.S_IXOTH)
    except OSError:
        pass  # Starting it then says why not.


def message_bytes(message: dict) -> bytes:
    """Returns a message as the program reads it. Raises TypeError for what JSON does not know and
    UnicodeEncodeError for a text that is no Unicode."""
    text = json.dumps(plain(message), ensure_ascii=False).encode("utf-8")
    return b"%d\n%b" % (len(text), text)


def read_message(stream: BinaryIO) -> Optional[dict]:
    """Returns the next message; nothing at the end. Raises ValueError where it is none."""
    line = stream.readline(MOST_DIGITS + 1)
    if not line:
        return None
    if not line.endswith(b"\n") or not line[:-1].isdigit() or int(line) > MOST_BYTES:
        raise ValueError("a message has no length")
    data = stream.read(int(line))
    if len(data) < int(line):
        raise ValueError("a message is shorter than its length")
    return json.loads(data.decode("utf-8"), object_hook=restored)


def plain(value: Any) -> Any:
    """Returns a value as JSON can say it."""
    if value is None or isinstance(value, (bool, str)):
        return value
    if isinstance(value, bytes):
        return {"base64": base64.b64encode(value).decode("ascii")}
    if isinstance(value, dict):
        return {name: plain(member) for name, member in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(member) for member in value]
    try:
        return operator.index(value)
    except TypeError:
        number = float(value)
    return number if math.isfinite(number) else {"number": str(number)}


def restored(value: dict) -> Any:
    """Returns bytes and numbers that plain() has put into other words."""
    if len(value) == 1 and isinstance(value.get("base64"), str):
        return base64.b64decode(value["base64"], validate=True)
    if len(value) == 1 and value.get("number") in ("nan", "inf", "-inf"):
        return float(value["number"])
    return value
