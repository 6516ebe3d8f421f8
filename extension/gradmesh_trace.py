#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Extensions > Gradient Mesh > Trace Picture: makes meshes of pictures, or of what paths in them surround."""

from functools import cached_property

from gradmesh_effect import (
    CLOSER,
    SHAPES,
    GradmeshEffect,
    News,
    etree,
    gradmesh,
    refusals_as_sentences,
)
from gradmesh_inkex import AbortExtension, Boolean
from gradmesh_report import report
from gradmesh_text import _
from gradmesh_window import LongWork

#: Of a mesh that takes as many handles as it needs.
MOST_HANDLES = 1000
#: How often what differs below a shape of More Detail Here counts.
CLOSER_FACTOR = 4
BESIDE_THE_PICTURE = ("{0}: {1} does not lie on the picture.", "{0}: {1} lies on none of its {2} pictures.")
WHAT_HELPS = _(
    "You can see the difference. Ask for more handles, draw a path around something with soft colours, or ignore "
    "larger detail. For sharp shapes, text and leaves use Path > Trace Bitmap."
)


class Trace(GradmeshEffect):
    """Traces the selected closed paths on pictures, or else the selected pictures."""

    def add_arguments(self, pars):
        super().add_arguments(pars)
        pars.add_argument("--tab")  # the page that was open, which Inkscape passes too
        pars.add_argument("--amount", default="handles")
        pars.add_argument("--handles", type=int, default=150)
        pars.add_argument("--detail", type=float)
        pars.add_argument("--hide_picture", type=Boolean, default=False)
        pars.add_argument("--resolution", type=int)
        pars.add_argument("--time_budget", type=int)

    def effect(self):
        images, shapes, guides = self.chosen_images(), self.chosen_shapes(), self.chosen_guides()
        if not shapes and not self.selects_pictures():
            raise News(self.nothing_to_trace(guides))
        ids = shapes or images
        # Of several pictures each path has the one below it.
        image = images[0] if shapes and len(images) == 1 else None
        with refusals_as_sentences(AbortExtension, BESIDE_THE_PICTURE):
            work = LongWork(self.titles(ids), lambda tell: self.trace(ids, image, guides, tell, work.show))
            tracings = work.run()
        report.meshes = [told(tracing) for tracing in tracings]
        self.stopped = work.stopped
        self.take_over()
        if self.options.hide_picture:
            self.hide({*self.closer, *(tracing.image for tracing in tracings)})
        self.became = self.what_became(tracings, ids)

    def chosen_images(self):
        """Ids of the selected pictures, or, where paths alone are selected, of the one in the document."""
        images = [each.get("id") for each in self.chosen if is_called(each, "image")]
        if images:
            return images
        all_images = [each.get("id") for each in self.svg.iter("{*}image")]
        if not all_images:
            raise News(
                _("There is no picture in the document; File > Import brings a photograph into it.")
            )
        if not self.options.ids:
            raise News(
                _("Select a picture, or a picture and a closed path around something in it.")
            )
        return all_images if len(all_images) == 1 else []

    def chosen_shapes(self):
        """Ids of the selected shapes that surround something."""
        return [each.get("id") for each in self.chosen if etree.QName(each).localname in SHAPES and not is_open(each)]

    def chosen_guides(self):
        """The selected open paths, which lines of meshes follow."""
        return [each for each in self.chosen if is_open(each)]

    def selects_pictures(self):
        return any(is_called(each, "image") for each in self.chosen)

    @cached_property
    def chosen(self):
        """The selected elements, and all in selected groups, but what gradmesh drew and shapes of More Detail Here."""
        blocks = {mesh.id for mesh in self.meshes.meshes if mesh.simplified} if self.meshes.ids else set()
        return [
            each
            for element in self.chosen_elements()
            for each in element.iter("*")
            if not each.get(CLOSER) and not any(around.get("id") in blocks for around in (each, *each.iterancestors()))
        ]

    @property
    def closer(self):
        """Ids of the shapes where meshes are to come closer, selected or not."""
        return [each.get("id") for each in self.svg.iter("*") if each.get(CLOSER)]

    def nothing_to_trace(self, guides):
        """The sentence where neither a picture nor a closed path is selected."""
        if self.closer:
            return _("Select the picture, too: shapes of More Detail Here only say where a mesh comes closer.")
        if guides:
            return _("{id} is an open path; it surrounds something once its ends are joined.").format(
                id=self.called(guides[0].get("id"))
            )
        return _("None of the selected objects is a picture or a closed path; select one that is.")

    def titles(self, ids):
        """What the progress window says while each of the meshes is at work."""
        names = [self.called_or(_("the picture"), name) for name in ids]
        if len(ids) == 1:
            return [_("Tracing {id}").format(id=names[0])]
        text = _("Tracing {id}, {number} of {count}")
        return [text.format(id=name, number=n, count=len(ids)) for n, name in enumerate(names, 1)]

    def called_or(self, words, name):
        """What a person calls an object; these words for a picture without a label, whose id no person gave."""
        is_image = is_called(self.elements_by_id()[name], "image")
        return words if is_image and self.called(name) == name else self.called(name)

    def trace(self, ids, image, guides, tell, show):
        options = self.options
        names = ("detail", "resolution", "time_budget")
        chosen = {name: getattr(options, name) for name in names if getattr(options, name) is not None}
        if options.amount == "handles":
            chosen.update(handles=options.handles, epsilon=0)
        else:
            chosen.update(handles=MOST_HANDLES, amount=options.amount)
        chosen.update(weights={name: CLOSER_FACTOR for name in self.closer} or None)
        chosen.update(image=image, guides=[guide.get("id") for guide in guides])
        return gradmesh.trace_in(self.meshes, ids, progress=tell, show=show, **chosen)

    def hide(self, ids):
        for element in self.document.getroot().iter("*"):
            if element.get("id") in ids:
                element.set("style", ";".join(filter(None, (element.get("style"), "display:none"))))

    def what_became(self, tracings, ids):
        """The sentences that a person is told after a run."""
        for name, tracing in zip(ids, tracings):
            percent, tenths = divmod(round(1000 * (1 - tracing.errors.mean / 255)), 10)
            # The digits are apart, as not every language has a point between them.
            # xgettext:no-python-format
            yield _("{id}: {handles} handles, {percent}.{tenths} % like the picture.").format(
                id=self.called_or(_("The picture"), name), handles=tracing.handles, percent=percent, tenths=tenths
            )
            if tracing.unused_guides and len(ids) == 1:
                yield _("{count} of the open paths cannot be followed.").format(count=tracing.unused_guides)
            if tracing.advice:
                yield WHAT_HELPS
        if len(tracings) < len(ids):
            yield _("Stopped: {count} of {all} meshes are made; Ctrl+Z takes it back.").format(
                count=len(tracings), all=len(ids)
            )
        elif self.stopped:
            yield _("It was stopped before the end; Ctrl+Z takes it back.")
        elif any(tracing.stopped for tracing in tracings):
            yield _("The time that is allowed under More was over before the end.")


def is_called(element, name):
    return etree.QName(element).localname == name


def is_open(shape):
    """Whether an element is a line that surrounds nothing, as its ends are not joined."""
    if is_called(shape, "path"):
        return "z" not in (shape.get("d") or "").lower()
    return is_called(shape, "polyline") or is_called(shape, "line")


def told(tracing):
    """What a script is told of a mesh."""
    return {
        "id": tracing.id,
        "handles": tracing.handles,
        "patches": tracing.patches,
        "flip": tracing.errors.flip,
        "mean": tracing.errors.mean,
        "stopped": tracing.stopped,
    }


if __name__ == "__main__":
    Trace().run()
