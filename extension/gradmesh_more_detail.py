#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Extensions > Gradient Mesh > More Detail Here: marks shapes where Trace Picture comes closer, or unmarks them."""

from gradmesh_effect import CLOSER, LABEL, NAMESPACE, SHAPES, WRITTEN_LABEL, GradmeshEffect, News, etree
from gradmesh_text import _

#: What a shape looked like before; a dashed line hides nothing of the picture below.
STYLE = f"{{{NAMESPACE}}}style"
DASHED = "fill:none;stroke:#ff00ff;stroke-width:1.5;stroke-dasharray:4.5,3;vector-effect:non-scaling-stroke"


class MoreDetail(GradmeshEffect):
    """Marks the selected shapes, or makes them ordinary again if all are marked."""

    def effect(self):
        selected = [each for element in self.chosen_elements() for each in element.iter("*")]
        shapes = [each for each in selected if etree.QName(each).localname in SHAPES]
        if not shapes:
            raise News(_("Draw a shape over what is to be closer to its picture, such as an eye, and select it."))
        if all(each.get(CLOSER) for each in shapes):
            for each in shapes:
                unmark(each)
            self.became = [_("Trace Picture takes these shapes for outlines again.")]
            return
        for each in shapes:
            if not each.get(CLOSER):
                mark(each)
        self.became = [
            _("Trace Picture comes closer to the picture in these shapes. Choose this again to take it back.")
        ]


def mark(shape):
    shape.set(CLOSER, "true")
    shape.set(STYLE, shape.get("style") or "")
    shape.set("style", DASHED)
    if not shape.get(LABEL):
        label = _("More detail")
        shape.set(LABEL, label)
        shape.set(WRITTEN_LABEL, label)


def unmark(shape):
    style = shape.get(STYLE)
    for name in (CLOSER, STYLE, "style"):
        shape.attrib.pop(name, None)
    if style:
        shape.set("style", style)
    if shape.get(WRITTEN_LABEL) and shape.get(WRITTEN_LABEL) == shape.get(LABEL):
        del shape.attrib[LABEL]
    shape.attrib.pop(WRITTEN_LABEL, None)


if __name__ == "__main__":
    MoreDetail().run()
