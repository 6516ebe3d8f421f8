# SPDX-License-Identifier: GPL-2.0-or-later
"""What the extension needs of others, and the sentence for what of it is not there."""

import importlib.util
import re
import sys
import traceback
from pathlib import Path

from gradmesh_text import _, sentence, translated

#: How the package managers of systems install a module of Python, by the system's ID in os-release.
INSTALL = {
    "debian": "sudo apt install python3-{}",
    "fedora": "sudo dnf install python3-{}",
    "suse": "sudo zypper install python3-{}",
    "arch": "sudo pacman -S python-{}",
}
OS_RELEASE = "/etc/os-release"


def why_it_does_not_load(error):
    """Returns the sentence for an ImportError of what the extension needs."""
    module = (error.name or "").partition(".")[0]
    if module in ("inkex", "lxml", "numpy") or (module and not is_imported_by_gradmesh(error)):
        return _(
            "Inkscape’s extensions need {module}, which is missing for Inkscape’s Python {version}: {install}."
        ).format(module=module, version=running(), install=how_to_install(module))
    built = pythons_built_for()
    if built and running() not in built:
        return _(
            "Gradient meshes cannot be changed because this gradmesh was built for Python {built}, "
            "and Inkscape runs Python {running}: install gradmesh again for this Python, as its "
            "README says."
        ).format(built=", ".join(built), running=running())
    if hasattr(error, "message"):  # of gradmesh, which has neither a module nor a program
        return sentence(translated(error.message))
    return _(
        "Gradient meshes cannot be changed because a part of the extension does not load in "
        "Python {version} ({error}): install gradmesh again for this Python, as its README "
        "says."
    ).format(version=sys.version.split()[0], error=error)


def is_imported_by_gradmesh(error):
    """Returns whether a file of ours, not one of inkex or beyond, imports what is not there."""
    files = [Path(frame.filename) for frame in traceback.extract_tb(error.__traceback__)]
    importer = [file for file in files if not file.name.startswith("<")][-1]
    return importer.name.startswith("gradmesh_") or importer.parent.name == "gradmesh"


def running():
    return "{}.{}".format(*sys.version_info)


def how_to_install(module):
    """Returns what to do on this system. Inkscape brings inkex itself, and on systems without a package
    manager everything that inkex imports."""
    for system in [] if module == "inkex" else systems():
        if system in INSTALL:
            return _("run “{command}”").format(command=INSTALL[system].format(module.lower()))
    return _("install Inkscape again")


def systems():
    """Returns the names of this system, and of those that it is like, the closest first."""
    try:
        text = Path(OS_RELEASE).read_text(encoding="utf-8")
    except OSError:  # Windows, macOS
        return []
    named = dict(re.findall(r'^(ID|ID_LIKE)="?([^"\n]*)"?$', text, re.MULTILINE))
    return [*named.get("ID", "").split(), *named.get("ID_LIKE", "").split()]


def pythons_built_for():
    """Versions such as "3.11" in the names of the compiled modules that lie in the package."""
    package = importlib.util.find_spec("gradmesh")
    folders = (package and package.submodule_search_locations) or ()
    names = sorted(file.name for folder in folders for file in Path(folder).glob("_core.*"))
    versions = (re.match(r"_core\.(?:cpython-|cp)(\d)(\d+)", name) for name in names)
    return [f"{version[1]}.{version[2]}" for version in versions if version]
