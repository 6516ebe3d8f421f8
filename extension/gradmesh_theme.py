# SPDX-License-Identifier: GPL-2.0-or-later
"""Whether Inkscape is dark, so that windows beside it are so, too."""

import os
import xml.etree.ElementTree as ElementTree


def inkscape_is_dark():
    """Whether it is, as far as its preferences say so; None where they do not."""
    folder = os.environ.get("INKSCAPE_PROFILE_DIR")
    if not folder:
        return None
    try:
        root = ElementTree.parse(os.path.join(folder, "preferences.xml")).getroot()
    except (OSError, ElementTree.ParseError):
        return None
    for group in root.iter("group"):
        dark = group.get("preferDarkTheme", group.get("darkTheme"))
        if group.get("id") == "theme" and dark is not None:
            return dark == "1"
    return None


def prefer_dark():
    """Lets windows of GTK be as Inkscape is, where that is known."""
    from gi.repository import Gtk

    is_dark = inkscape_is_dark()
    if is_dark is not None:
        Gtk.Settings.get_default().set_property("gtk-application-prefer-dark-theme", is_dark)
