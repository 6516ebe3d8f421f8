# SPDX-License-Identifier: GPL-2.0-or-later
"""The panel beside the picture of Simplify by Eye: what can be chosen, and how the mesh is."""

import itertools
import json

from gi.repository import Gtk

from gradmesh_eye import AMOUNTS, BLOCKS, EDITS, GRADIENT, GROUNDS, KNOWN, WORST
from gradmesh_eye_words import legend, redo_tip, summary, undo_tip
from gradmesh_text import _
from gradmesh_widgets import button, choices, is_dark, linked, section, show_samples

CHART = (340, 100)
#: Room below the panel, at least, where a screen is small.
LEAST_HEIGHT = 240

GROUND_NAMES = {
    "result": (_("Result"), _("The mesh as it would be written (key 7)")),
    "original": (_("Original"), _("The picture that counts (key 8; hold F to see it for a moment)")),
    "halves": (_("Both"), _("The original left of the line, the result right of it; drag the line (key 9)")),
    "error": (_("Error"), _("Where the result differs, the darker the more (key 0)")),
}
KNOWN_NAMES = {
    "nothing": _("Nothing else"),
    "prices": _("What lines cost"),
    "regions": _("Regions of a patch"),
    "parts": _("Parts (motorcycle graph)"),
}
EDIT_NAMES = {
    "merge": (_("Take out"), _("A click on a line takes it out, or merges the patches beside it (M)")),
    "rows": (_("New row"), _("A click puts a line in, from left to right in the mesh (R)")),
    "columns": (_("New column"), _("A click puts a line in, from top to bottom in the mesh (C)")),
    "both": (_("Both"), _("A click puts both lines in (B; or hold Ctrl)")),
}
DRAG_NAMES = {
    "around": (
        _("Around"),
        _(
            "A straight drag marks what is in a rectangle, a curved one what it goes around: each patch of "
            "which that is a third or more (T changes to the brush)"
        ),
    ),
    "brush": (_("Brush"), _("A drag marks every patch that it touches (T; or hold Alt)")),
}
PROTECT = _("Protect"), _("Let what is marked stay as it is, whatever is done (P)")
RELEASE = _("Release"), _("Let what is marked change again (P)")
#: How often errors in what is marked may count.
WEIGHTS = {0.25: "¼", 0.5: "½", 1: "1", 2: "2", 4: "4"}
WEIGHT_TIP = _(
    "How often errors in what is marked count, so that it stays more or less exact than the rest: blue lines "
    "show where more, orange lines where less"
)
FORM_NAMES = {GRADIENT: _("One mesh gradient"), BLOCKS: _("Blocks")}


class Panel:
    """Its widget is `box`. What a person does there goes to the Eye of a window, by its do()."""

    def __init__(self, window):
        self.window, self.eye = window, window.eye
        self._is_setting = False
        self._told = None
        self.box = Gtk.Box(orientation=Gtk.Orientation.VERTICAL)
        # On a small screen all can still be reached, and what ends the window is always there.
        scrolled = Gtk.ScrolledWindow(hscrollbar_policy=Gtk.PolicyType.NEVER, propagate_natural_height=True)
        scrolled.set_min_content_height(LEAST_HEIGHT)
        scrolled.add(self._build())
        self.box.pack_start(scrolled, True, True, 0)
        self.box.pack_end(self._build_end(), False, False, 0)

    def _do(self, action, *arguments):
        self.window.do(action, *arguments)

    # --- what it is made of ---

    def _build(self):
        column = Gtk.Box(orientation=Gtk.Orientation.VERTICAL, spacing=6, margin=12)
        column.set_size_request(CHART[0], -1)
        if len(self.eye.ids) > 1:
            column.add(self._build_meshes())
        self.summary = Gtk.Label(xalign=0)
        column.add(self.summary)
        for build in (
            *(self._build_curve, self._build_looks, self._build_edits),
            *(self._build_marked, self._build_worst),
        ):
            column.add(build())
        return column

    def _build_meshes(self):
        box = Gtk.ComboBoxText(tooltip_text=_("Which mesh is looked at; what was made of others stays"))
        for name in self.eye.ids:
            box.append(name, name)
        box.set_active_id(self.eye.id)
        box.connect("changed", lambda box: self._do(self.eye.choose, box.get_active_id()))
        return box

    def _build_curve(self):
        column = section(_("How simple"))
        self.forms = Gtk.ComboBoxText(
            tooltip_text=_(
                "Whether the mesh stays one mesh gradient, or becomes blocks that can be coarse in one place"
            )
        )
        for name, text in FORM_NAMES.items():
            self.forms.append(name, text)
        self.forms.connect("changed", self._form_chosen)
        column.add(self.forms)
        self.chart = Gtk.Image(tooltip_text=_("The error, the fewer handles are left; the square is what is shown"))
        column.add(self.chart)
        self.slider = Gtk.Scale(draw_value=False, adjustment=Gtk.Adjustment(step_increment=1))
        self.slider.set_round_digits(0)
        self.slider.set_tooltip_text(_("Left the mesh as it is, right the simplest (arrow keys)"))
        self.slider.connect("change-value", self._slid)
        self.slider.connect("button-release-event", self._slider_released)
        column.add(self.slider)
        column.add(self._build_amounts())
        return column

    def _build_amounts(self):
        row, self.amounts = linked(), {}
        for text in AMOUNTS.values():
            self.amounts[text] = button(text, None, lambda text=text: self._do(self._slide_to, text))
            row.pack_start(self.amounts[text], True, True, 0)
        self.searching = Gtk.Spinner(tooltip_text=_("Simpler ones are still looked for"))
        line = Gtk.Box(spacing=6)
        line.pack_start(row, True, True, 0)
        line.add(self.searching)
        return line

    def _build_looks(self):
        column = section(_("What is shown"))
        self.grounds = choices(GROUNDS, GROUND_NAMES, self._ground_chosen)
        column.add(self.grounds["box"])
        row = Gtk.Box(spacing=12, homogeneous=True)
        for text, tip, name in (
            (_("_Lines"), _("Show the lines of the mesh (L)"), "lines"),
            (_("_Handles"), _("Show what can be dragged in Inkscape (H)"), "handles"),
        ):
            check = Gtk.CheckButton(label=text, use_underline=True, tooltip_text=tip)
            check.set_active(getattr(self.eye, name))
            check.connect("toggled", self._look_toggled, name)
            setattr(self, name, check)
            row.add(check)
        column.add(row)
        column.add(self._build_known())
        self.legend = Gtk.Label(
            xalign=0,
            wrap=True,
            no_show_all=True,
            max_width_chars=44,
            tooltip_text=_(
                "Lines: pale ones cost little, dark ones much, blue ones must stay. Regions: what can become one "
                "patch within the error of Balanced; Enter makes one of the region that is shown. Parts: red lines "
                "cost too much, dark ones go on from where these end."
            ),
        )
        column.add(self.legend)
        return column

    def _build_known(self):
        row = Gtk.Box(spacing=6)
        self.known = Gtk.ComboBoxText(
            tooltip_text=_("What is known of the mesh, in colours over it: found out in the background (S)")
        )
        for name in KNOWN:
            self.known.append(name, KNOWN_NAMES[name])
        self.known.set_active_id(self.eye.known)
        self.known.connect("changed", self._known_chosen)
        row.pack_start(self.known, True, True, 0)
        self.regions = linked()
        for text, tip, by in (
            ("‹", _("A larger region of the patch that is marked or pointed at (comma)"), -1),
            ("›", _("A smaller region of the patch that is marked or pointed at (full stop)"), 1),
        ):
            self.regions.add(button(text, tip, lambda by=by: self._do(self.eye.step_region, by)))
        row.add(self.regions)
        return row

    def _build_edits(self):
        column = section(_("What a click does"))
        self.edits = choices(EDITS, EDIT_NAMES, self._edit_chosen)
        column.add(self.edits["box"])
        self.fits = Gtk.CheckButton(
            label=_("_Fit what is around"),
            use_underline=True,
            active=True,
            tooltip_text=_("Move points and handles near a change so that the picture stays what it was"),
        )
        self.fits.connect("toggled", self._fits_toggled)
        column.add(self.fits)
        row = Gtk.Box(spacing=6, homogeneous=True)
        self.undo = button(_("Undo"), None, lambda: self._do(self.eye.undo))
        self.redo = button(_("Redo"), None, lambda: self._do(self.eye.redo))
        fit = button(
            _("Fit all"),
            _("Move all points and handles so that the picture is closest"),
            lambda: self._do(self.eye.fit),
        )
        for part in (self.undo, self.redo, fit):
            row.add(part)
        column.add(row)
        return column

    def _build_marked(self):
        self.drags = choices(DRAG_NAMES, DRAG_NAMES, self._drag_chosen)
        column = section(_("Marked patches"), self.drags["box"])
        row = linked()
        self.merge = button(
            _("Merge"),
            _("Make one patch of all that are marked (Enter). Shift+click marks single ones."),
            lambda: self._do(self.eye.merge_marked),
        )
        self.protect = button("", None, lambda: self._do(self.eye.protect_marked))
        self.only_here = button(
            _("Only here"),
            _("Let only what is marked change, and protect all others (O)"),
            lambda: self._do(self.eye.protect_others),
        )
        for part in (self.merge, self.protect, self.only_here):
            row.add(part)
        column.add(row)
        column.add(self._build_weights())
        return column

    def _build_weights(self):
        row = Gtk.Box(spacing=6)
        row.add(Gtk.Label(label=_("Errors there ×")))
        buttons = linked()
        self.weights = []
        for factor, name in WEIGHTS.items():
            made = button(name, WEIGHT_TIP, lambda factor=factor: self._do(self.eye.weigh_marked, factor))
            self.weights.append(made)
            buttons.add(made)
        row.pack_end(buttons, False, False, 0)
        return row

    def _build_worst(self):
        column = section(_("Where it differs most"))
        row, self.worst = linked(), []
        for number in range(WORST):
            made = button(str(number + 1), None, lambda number=number: self._do(self._look_at, number))
            self.worst.append(made)
            row.add(made)
        column.add(row)
        return column

    def _build_end(self):
        row = Gtk.Box(spacing=6, homogeneous=True, margin=12)
        row.add(button(_("Cancel"), _("Leave the document as it was (Escape)"), self.window.cancel))
        self.apply = button(_("Apply"), _("Write what is shown into the document (Ctrl+Enter)"), self.window.apply)
        self.apply.get_style_context().add_class("suggested-action")
        row.add(self.apply)
        return row

    # --- how the mesh is ---

    def tell(self):
        """Brings everything up to date."""
        eye, status = self.eye, self.eye.status
        known = (eye.known, eye.region, eye.patch, eye.found)
        now = (eye.id, json.dumps(status, sort_keys=True, default=str), list(eye.marked), known)
        if now == self._told:
            return
        self._told = now
        self.summary.set_text(summary(eye))
        self._is_setting = True
        self.undo.set_sensitive(status["undo"] is not None)
        self.redo.set_sensitive(status["redo"] is not None)
        self.undo.set_tooltip_text(undo_tip(eye))
        self.redo.set_tooltip_text(redo_tip(eye))
        self.apply.set_sensitive(not eye.is_unchanged)
        self.slider.set_range(0, max(len(eye.states) - 1, 1))
        if status["state"] >= 0:
            self.slider.set_value(status["state"])
        self.forms.set_active_id(status["form"])
        self._is_setting = False
        width = max(self.slider.get_allocated_width(), CHART[0])  # words may make the panel wider
        factor = self.window.factor
        size = (factor * length for length in (width, CHART[1]))
        show_samples(self.chart, *eye.chart(*size, is_dark()), factor)
        self._show_marked()
        self._show_known()
        self._show_amounts()
        self._show_worst()

    def _show_marked(self):
        eye = self.eye
        self.merge.set_sensitive(len(eye.to_merge) > 1)
        self.protect.set_sensitive(bool(eye.marked))
        for part in (self.only_here, *self.weights):
            part.set_sensitive(bool(eye.marked))
        text, tip = RELEASE if eye.is_release else PROTECT
        self.protect.set_label(text)
        self.protect.set_tooltip_text(tip)

    def _show_known(self):
        self.legend.set_markup(legend(self.eye))
        self.legend.set_visible(self.eye.known != "nothing")
        self.regions.set_visible(self.eye.known == "regions")
        self.regions.set_sensitive(self.eye.found.get("regions", 0) > 1)

    def _show_amounts(self):
        for text, made in self.amounts.items():
            state = self.eye.marks.get(text)
            made.set_sensitive(state is not None)
            if state is not None:
                handles = self.eye.states[state]["handles"]
                made.set_tooltip_text(_("{handles} handles").format(handles=handles))
        self.searching.set_property("active", self.eye.is_searching)

    def _show_worst(self):
        places = self.eye.worst_places()
        for made, place in itertools.zip_longest(self.worst, places):
            made.set_sensitive(place is not None)
            if place is not None:
                tip = _("Error {error:.3f} in a small part; a click goes there")
                made.set_tooltip_text(tip.format(error=place["error"]))

    def show_forms(self):
        self.forms.set_visible(self.eye.has_forms)

    # --- what a person does ---

    def _form_chosen(self, box):
        if not self._is_setting:
            self._do(self.eye.set_form, box.get_active_id())

    def _ground_chosen(self, name):
        self.eye.ground = name
        self.window.paint_soon()

    def _known_chosen(self, box):
        self.eye.show_known(box.get_active_id())
        self.window.paint_soon()

    def _edit_chosen(self, name):
        self.eye.edit = name

    def _drag_chosen(self, name):
        self.eye.brushes = name == "brush"

    def _slide_to(self, amount):
        self.eye.slide(self.eye.marks[amount])

    def _look_at(self, number):
        self.eye.look_at(self.eye.worst_places()[number])

    def _look_toggled(self, check, name):
        setattr(self.eye, name, check.get_active())
        self.window.paint_soon()

    def _fits_toggled(self, check):
        self.eye.fits = check.get_active()
        self.window.paint_soon()

    def _slid(self, _slider, _how, value):
        if not self._is_setting:
            self._do(lambda: self.eye.slide(round(value), True))
        return False

    def _slider_released(self, slider, _event):
        self._do(self.eye.slide, round(slider.get_value()))
        return False
