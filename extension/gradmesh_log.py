# SPDX-License-Identifier: GPL-2.0-or-later
"""The log, for what nobody is told. Imports nothing that could fail."""

import os
from pathlib import Path


def cache_folder():
    """The user's folder for what may be deleted at any time; it need not exist."""
    cache = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return Path(cache) / "gradmesh"


def log_file():
    """The open log, made where it is not there yet; OSError where that fails."""
    folder = cache_folder()
    folder.mkdir(parents=True, exist_ok=True)
    return open(folder / "extension.log", "a+", encoding="utf-8", errors="backslashreplace")


def log(text):
    """Adds to the log; its name, or nothing where that fails."""
    try:
        with log_file() as stream:
            stream.write(text + "\n")
    except OSError:
        return None
    return stream.name


def log_once(text):
    """Adds to the log what it does not hold yet."""
    try:
        with log_file() as stream:
            stream.seek(0)
            if text not in stream.read():
                stream.write(text + "\n")
    except OSError:
        pass


def send_stderr_to_the_log():
    """Of libraries and child processes too; to nowhere where there is no log."""
    try:
        with log_file() as stream:
            os.dup2(stream.fileno(), 2)
    except OSError:
        with open(os.devnull, "wb") as nowhere:
            os.dup2(nowhere.fileno(), 2)
