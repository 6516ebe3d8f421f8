# SPDX-License-Identifier: GPL-2.0-or-later
"""What the extension says, in the person's language."""

import gettext
import importlib.util
import os
import re
import sys
from pathlib import Path

# Inkscape says where the catalogue is that it found for the dialog.
_catalogue = gettext.translation(
    os.environ.get("INKEX_GETTEXT_DOMAIN") or "gradmesh",
    os.environ.get("INKEX_GETTEXT_DIRECTORY") or Path(__file__).parent / "locale",
    fallback=True,
)
_ = _catalogue.gettext
#: Of what is said, such as "de".
LANGUAGE = _catalogue.info().get("language") or "en"


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


def why_it_does_not_load(error):
    """The sentence for an ImportError of what the extension needs."""
    running = "{}.{}".format(*sys.version_info)
    built = pythons_built_for()
    if built and running not in built:
        return _(
            "Gradient meshes cannot be changed because this gradmesh was built for Python {built}, "
            "and Inkscape runs Python {running}: install gradmesh again for this Python, as its "
            "README says."
        ).format(built=", ".join(built), running=running)
    return _(
        "Gradient meshes cannot be changed because a part of the extension does not load in "
        "Python {version} ({error}): install gradmesh again for this Python, as its README "
        "says."
    ).format(version=sys.version.split()[0], error=error)


def pythons_built_for():
    """Versions such as "3.11" in the names of the compiled modules that lie in the package."""
    package = importlib.util.find_spec("gradmesh")
    folders = (package and package.submodule_search_locations) or ()
    names = sorted(file.name for folder in folders for file in Path(folder).glob("_core.*"))
    versions = (re.match(r"_core\.(?:cpython-|cp)(\d)(\d+)", name) for name in names)
    return [f"{version[1]}.{version[2]}" for version in versions if version]
