# SPDX-License-Identifier: GPL-2.0-or-later
"""One window on a document at a time."""

import hashlib
import os
from contextlib import contextmanager

from gradmesh_log import cache_folder

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None
    import msvcrt


@contextmanager
def only_window():
    """Whether no other run has a window on the document. Where that cannot be known, it is believed.

    The system takes the lock back when the program ends, however it does.
    """
    # A document that was never saved has no path; then it is the Inkscape that counts.
    document = os.environ.get("DOCUMENT_PATH") or str(os.getppid())
    file = cache_folder() / f"by-eye-{hashlib.sha256(document.encode()).hexdigest()[:16]}.lock"
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        held = open(file, "w", encoding="utf-8")
    except OSError:
        yield True
        return
    with held:
        is_alone = lock(held)
        yield is_alone
    if is_alone:
        try:
            file.unlink()
        except OSError:
            pass  # It is empty; the next run uses it.


def lock(file):
    try:
        if fcntl:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        else:
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
    except OSError:
        return False
    return True
