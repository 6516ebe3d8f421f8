# SPDX-License-Identifier: GPL-2.0-or-later
"""Prices of merges, kept between runs so that the dialog's preview answers at once.

A folder in the user's cache that may be deleted at any time. It is bounded: what was not used for
longest goes first.
"""

from contextlib import contextmanager

from gradmesh_log import cache_folder

LARGEST = 64 * 2**20  # bytes


@contextmanager
def analysis_cache():
    """The folder, made where it is not there yet, or None where that fails; bounded afterwards."""
    folder = cache_folder() / "analyses"
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        yield None
        return
    yield folder
    prune(folder)


def prune(folder, largest=LARGEST):
    """Deletes the files used longest ago until all together are at most `largest` bytes."""
    files = []
    for file in folder.iterdir():
        try:
            status = file.stat()
        except OSError:  # another run was quicker
            continue
        files.append((status.st_mtime, status.st_size, file))
    size = sum(file_size for _used, file_size, _file in files)
    for _used, file_size, file in sorted(files):
        if size <= largest:
            break
        try:
            file.unlink()
        except OSError:
            continue
        size -= file_size
