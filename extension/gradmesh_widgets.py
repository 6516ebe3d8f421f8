# SPDX-License-Identifier: GPL-2.0-or-later
"""Small parts of windows: headings, buttons, pictures of samples, and Inkscape's light or dark."""

import os
import xml.etree.ElementTree as ElementTree

from gi.repository import Gdk, GdkPixbuf, GLib, Gtk


def heading(text):
    label = Gtk.Label(xalign=0, margin_top=8)
    label.set_markup("<b>{}</b>".format(GLib.markup_escape_text(text)))
    return label


def section(text, beside=None):
    """A column below a heading, and what stands beside that."""
    column = Gtk.Box(orientation=Gtk.Orientation.VERTICAL, spacing=4)
    row = Gtk.Box(spacing=6)
    row.add(heading(text))
    if beside is not None:
        row.pack_end(beside, False, False, 0)
    column.add(row)
    return column


def linked(homogeneous=True):
    row = Gtk.Box(homogeneous=homogeneous)
    row.get_style_context().add_class("linked")
    return row


def button(text, tip, action):
    made = Gtk.Button(label=text, tooltip_text=tip)
    made.connect("clicked", lambda *_: action())
    return made


def choices(names, texts, chosen):
    """Buttons of which one is pressed, by name, and their box as "box".

    texts: what each says, and its tooltip; chosen: called with the name of the one that is pressed.
    """
    box = linked(homogeneous=False)
    made, group = {"box": box}, None
    for name in names:
        text, tip = texts[name]
        group = made[name] = Gtk.RadioButton(label=text, tooltip_text=tip, group=group, draw_indicator=False)
        group.connect("toggled", lambda button, name=name: button.get_active() and chosen(name))
        box.pack_start(group, True, True, 0)
    return made


def has_surfaces():
    """Whether Python can hold the pictures that GTK shows pixel by pixel on fine screens (pycairo)."""
    try:
        import gi

        gi.require_foreign("cairo")
    except ImportError:
        return False
    return True


HAS_SURFACES = has_surfaces()


def show_samples(image, width, height, samples, factor):
    """Shows red, green and blue of each pixel, row by row."""
    pixels = GdkPixbuf.Pixbuf.new_from_bytes(
        GLib.Bytes.new(samples), GdkPixbuf.Colorspace.RGB, False, 8, width, height, 3 * width
    )
    if factor > 1:
        image.set_from_surface(Gdk.cairo_surface_create_from_pixbuf(pixels, factor, None))
    else:
        image.set_from_pixbuf(pixels)


def as_fits_the_screen(size):
    """The width and height of a window, or less where the screen has no room for that."""
    display = Gdk.Display.get_default()
    room = (display.get_primary_monitor() or display.get_monitor(0)).get_workarea()
    return min(size[0], room.width), min(size[1], room.height)


def prefer_dark():
    """Follows Inkscape, where its preferences say that it is dark."""
    folder = os.environ.get("INKSCAPE_PROFILE_DIR")
    if not folder:
        return
    try:
        root = ElementTree.parse(os.path.join(folder, "preferences.xml")).getroot()
    except (OSError, ElementTree.ParseError):
        return
    for group in root.iter("group"):
        if group.get("id") == "theme" and group.get("preferDarkTheme", group.get("darkTheme")) is not None:
            dark = group.get("preferDarkTheme", group.get("darkTheme")) == "1"
            Gtk.Settings.get_default().set_property("gtk-application-prefer-dark-theme", dark)


def is_dark():
    return bool(Gtk.Settings.get_default().get_property("gtk-application-prefer-dark-theme"))
