# SPDX-License-Identifier: GPL-2.0-or-later
"""What the extension says, in the person's language, and the log for what it does not say."""

import gettext
import os
from pathlib import Path

# Inkscape says where the catalogue is that it found for the dialog.
_catalogue = gettext.translation(
    os.environ.get("INKEX_GETTEXT_DOMAIN") or "gradmesh",
    os.environ.get("INKEX_GETTEXT_DIRECTORY") or Path(__file__).parent / "locale",
    fallback=True,
)
_ = _catalogue.gettext


def sentence(message):
    """The message as a sentence: one line, a full stop at its end."""
    text = " ".join(str(message).split())
    return text if text.endswith(".") else text + "."


def cache_folder():
    """The user's folder for what may be deleted at any time; it need not exist."""
    cache = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return Path(cache) / "gradmesh"


def log_file():
    """The open log, made where it is not there yet; OSError where that fails."""
    folder = cache_folder()
    folder.mkdir(parents=True, exist_ok=True)
    return open(folder / "extension.log", "a", encoding="utf-8")


def log(text):
    """Adds to the log; its name, or nothing where that fails."""
    try:
        with log_file() as stream:
            stream.write(text + "\n")
    except OSError:
        return None
    return stream.name
