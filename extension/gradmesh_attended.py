# SPDX-License-Identifier: GPL-2.0-or-later
"""Whether somebody sees what the extension says.

Inkscape shows every byte on stderr in a dialog and waits until somebody closes it, in a batch run
too. So where nobody is there, all of it goes to the log. Imported before anything that could fail.
"""

import os
import stat
import sys
import time

from gradmesh_log import send_stderr_to_the_log


def is_attended():
    """Returns whether a person may be there. GRADMESH_UNATTENDED says it, 1 or 0; without it nobody
    is there only where Inkscape is seen to have been started with --batch-process."""
    told = {"0": True, "1": False}.get(os.environ.get("GRADMESH_UNATTENDED"))
    if told is not None:
        return told
    commands = list(commands_reading(1))
    return not commands or not all("--batch-process" in words for words in commands)


def commands_reading(descriptor):
    """The words, up to "--", with which the processes were started that read what is written to the
    descriptor. Inkscape is not the parent of an extension, but one of these. None where a system
    does not tell."""
    try:
        pipe = os.readlink(f"/proc/self/fd/{descriptor}")
        processes = [f"/proc/{name}" for name in os.listdir("/proc") if name.isdigit()]
    except OSError:
        return
    for process in processes:
        try:
            if not any(reads(f"{process}/fd/{name}", pipe) for name in os.listdir(f"{process}/fd")):
                continue
            with open(f"{process}/cmdline", "rb") as command:
                words = command.read().split(b"\0")
        except OSError:  # the process has ended, or is somebody else's
            continue
        yield [os.fsdecode(word) for word in words[: words.index(b"--") if b"--" in words else None]]


def reads(link, pipe):
    """Returns whether an entry of /proc/PID/fd is the end of the pipe that is read from."""
    try:
        return bool(os.lstat(link).st_mode & stat.S_IRUSR) and os.readlink(link) == pipe
    except OSError:  # closed meanwhile
        return False


ATTENDED = is_attended()
if not ATTENDED:
    send_stderr_to_the_log()
    program, document = os.path.basename(sys.argv[0]), os.environ.get("DOCUMENT_PATH", "")
    print(time.strftime("%Y-%m-%d %H:%M:%S"), program, document, file=sys.stderr)
