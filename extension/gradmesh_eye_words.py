# SPDX-License-Identifier: GPL-2.0-or-later
"""What Simplify by Eye says of the mesh that an Eye looks at."""

import math
from xml.sax.saxutils import escape

from gradmesh_eye import GRADIENT
from gradmesh_text import _, translated


def summary(eye):
    """How the mesh is that is shown."""
    now, before = eye.status, eye.status["before"]
    handles = [_("{now} of {before} handles").format(now=now["handles"], before=before["handles"])]
    if now["objects"] > 1:
        handles.append(_("{count} objects").format(count=now["objects"]))
    patches = [_("{now} of {before} patches").format(now=now["patches"], before=before["patches"])]
    if now["protected"]:
        patches.append(_("{count} protected").format(count=len(now["protected"])))
    error = _("error {error:.4f}, in small parts up to {local:.3f}").format(
        error=now["error"], local=now["local_error"]
    )
    # As many lines whatever they say, so that nothing below moves.
    return "\n".join([", ".join(handles), ", ".join(patches), error])


def hint(eye):
    """What a click would do at the place that is pointed at, or what else a person may do."""
    found = eye.pointed
    if found is not None and found.why_not is not None:
        return _("Here nothing can be done: {reason}").format(reason=translated(found.why_not.message))
    if found is not None and found.handles is not None:
        return _("A click: {handles} handles, {patches} patches, error {error:.4f} ({change:+.4f})").format(
            handles=found.handles,
            patches=found.patches,
            error=found.error,
            change=found.error - eye.status["error"],
        )
    if len(eye.marked) == 1:
        return _("One patch is marked. P protects it, or releases it.")
    if eye.marked:
        return _of_marked(eye)
    if eye.brushes:
        return _("The brush marks every patch that it touches.")
    if eye.status["protected"] and eye.has_forms and eye.status["form"] == GRADIENT:
        return _("Lines through protected patches stay; blocks may have fewer handles.")
    return _("Point at a line to see what taking it out costs.")


def undo_tip(eye):
    """What Undo takes back."""
    name = eye.status["undo"]
    if name is None:
        return _("Nothing to take back")
    return _("Take back: {change} (Ctrl+Z)").format(change=translated(name))


def redo_tip(eye):
    """What Redo makes again."""
    name = eye.status["redo"]
    if name is None:
        return _("Nothing to make again")
    return _("Make again: {change} (Ctrl+Shift+Z)").format(change=translated(name))


def legend(eye):
    """What the colours mean of what is known of the mesh, as Pango's markup."""
    if eye.known == "nothing":
        return ""
    if not eye.found.get("complete"):
        return escape(_("This is being found out …"))
    if eye.found["failure"]:
        return escape(eye.found["failure"])
    words = {"prices": _of_prices, "regions": _of_regions, "parts": _of_parts}
    return words[eye.known](eye)


def _of_marked(eye):
    price = eye.price_of_marked
    if price.why_not is not None:
        return _("Marked patches: {count}. P protects them. Enter does nothing: {reason}").format(
            count=len(eye.marked), reason=translated(price.why_not.message)
        )
    change = price.error - eye.status["error"]
    said = _("Marked patches: {count}. P protects them, Enter makes them one: error {error:.4f} ({change:+.4f})")
    return said.format(count=len(eye.marked), error=price.error, change=change)


def _of_prices(eye):
    if not eye.found["scale"]:
        return escape(_("No line can be taken out."))
    swatch = '<span background="{}">\u2003</span>\u00a0{}'
    return "  ".join(swatch.format(step["color"], short(step["error"])) for step in eye.found["scale"])


def _of_regions(eye):
    region = eye.region_shown
    if eye.patch is None:
        return escape(_("Point at a patch, or mark one, to see its regions."))
    if region is None:
        return escape(_("No region around this patch keeps to the error of Balanced."))
    if region["rows"]:
        size = "{rows} × {columns}".format(**region)
    else:
        size = _("{count} patches").format(count=len(region["patches"]))
    return escape(
        _("Region {number} of {count}: {size}, error {error:+.4f}").format(
            number=eye.region + 1, count=eye.found["regions"], size=size, error=region["error"]
        )
    )


def _of_parts(eye):
    return escape(
        _("Parts: {count}, along edges that cost more than {limit}").format(
            count=eye.found["parts"], limit=short(eye.found["limit"])
        )
    )


def short(error):
    """An error with at most two digits that count, without powers of ten."""
    return "{:.{}f}".format(error, 1 - math.floor(math.log10(error))).rstrip("0")
