# SPDX-License-Identifier: GPL-2.0-or-later
"""What the extension says, in the person's language."""

import gettext
import os
from pathlib import Path

# Inkscape says where the catalogue is that it found for the dialog.
_folder = Path(os.environ.get("INKEX_GETTEXT_DIRECTORY") or Path(__file__).parent / "locale")
_catalogue = gettext.translation(os.environ.get("INKEX_GETTEXT_DOMAIN") or "gradmesh", _folder, fallback=True)
_ = _catalogue.gettext
#: Of what is said, such as "de".
LANGUAGE = _catalogue.info().get("language") or "en"


def in_all_languages(text):
    """The text, and what it is in each language that is installed."""
    yield text
    for file in _folder.glob("*/LC_MESSAGES/gradmesh.mo"):
        with open(file, "rb") as stream:
            yield gettext.GNUTranslations(stream).gettext(text)


def sentence(message):
    """The message as a sentence: one line, a full stop at its end."""
    text = " ".join(str(message).split())
    return text if text.endswith(".") else text + "."


def translated(message):
    """What gradmesh says: a text, or a template and what goes into its places, which may be
    messages themselves."""
    if isinstance(message, str):
        return message
    template, arguments = message
    return _(template).format(*map(translated, arguments))


def first_of(left_out):
    """The sentences for the first three of what was left out or lost, which suffice to look into it."""
    return [sentence(translated(why.message)) for why in left_out[:3]]
