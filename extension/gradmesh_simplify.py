#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Extensions > Gradient Mesh > Simplify: takes needless handles and patches out of gradient meshes."""

import re

from gradmesh_effect import GradmeshEffect, NothingToDo, gradmesh, refusals_as_sentences, say
from gradmesh_cache import analysis_cache
from gradmesh_inkex import AbortExtension, Boolean
from gradmesh_log import log
from gradmesh_report import report
from gradmesh_text import _
from gradmesh_window import LongWork

# The largest error of each amount that the dialog offers by name. Of FLIP a person sees 0.01 hardly
# and 0.05 at once; half of that is as visible in SSIM (paper, section 5).
EPSILON = {"gentle": 0.005, "balanced": 0.01, "strong": 0.02}
SSIM_SHARE = 0.5
# Beside that, the largest error of any 32 x 32 pixels, so that no eye or highlight is given up for
# calm areas elsewhere: highlights go at 0.2 to 0.5, thin ones in part from 0.12, corners of a mouth
# lose their colour at 0.18, and at 0.1 what has changed is found only beside the original.
MAX_LOCAL_ERROR = {"gentle": 0.05, "balanced": 0.1, "strong": 0.1}
# What is counted by the amounts that are a number or a share.
COUNTED = {"handles": "handles", "share": "handles", "patches": "patches", "patch-share": "patches"}

# The method of blocks that the dialog begins with, which leaves few handles unless it is patches that
# are to be few; another one there is asked for by the person.
BLOCKS = "best"
# The method that takes handles out of one mesh gradient and merges nothing.
PLAIN = "plain"


class Simplify(GradmeshEffect):
    """Simplifies the selected gradient meshes, or all of the document where nothing is selected."""

    def add_arguments(self, pars):
        super().add_arguments(pars)
        pars.add_argument("--tab")  # the page that was open, which Inkscape passes too
        # The core checks the values: Inkscape passes on any choice that its preferences hold.
        pars.add_argument("--amount", default="balanced")
        pars.add_argument("--epsilon", type=float, default=0.01)
        pars.add_argument("--handles", type=int, default=100)
        pars.add_argument("--patches", type=int, default=50)
        pars.add_argument("--share", type=float, default=50)
        pars.add_argument("--result", default="simplest")
        pars.add_argument("--keep_original", type=Boolean, default=False)
        pars.add_argument("--remember_original", type=Boolean, default=True)
        pars.add_argument("--method", default="best")
        pars.add_argument("--omega", type=float, default=0.75)
        pars.add_argument("--kappa", type=float, default=0.05)
        pars.add_argument("--seed", type=int, default=0)
        pars.add_argument("--edges", default="")
        pars.add_argument("--metric", default="flip")
        pars.add_argument("--max_local_error", type=float, default=0)
        pars.add_argument("--resolution", type=int, default=700)
        pars.add_argument("--visible_only", type=Boolean, default=True)
        pars.add_argument("--time_budget", type=int, default=60)
        pars.add_argument("--preview", type=Boolean, default=False)

    def effect(self):
        ids = self.selected_meshes() if self.options.ids else self.all_meshes()
        with refusals_as_sentences():
            options = self.core_options()
            work = LongWork(self.title(ids), lambda tell: self.simplify(ids, options, tell))
            results = work.run()
        report.meshes = results
        if not any(result.changed for result in results):
            raise NothingToDo(self.why_nothing_changed(results))
        if self.options.preview:
            say("\n".join(map(self.what_would_change, results)))
            report.outcome = "unchanged"
        else:
            self.take_over()

    def all_meshes(self):
        if not self.meshes.ids:
            raise AbortExtension(_("There is no gradient mesh in the document."))
        return self.readable([mesh.id for mesh in self.meshes.meshes])

    def title(self, ids):
        if not self.options.ids:
            return _("Nothing is selected: all {count} gradient meshes are simplified.").format(
                count=len(ids)
            )
        if len(ids) == 1:
            return _("{id} is simplified.").format(id=ids[0])
        return _("{count} gradient meshes are simplified.").format(count=len(ids))

    def core_options(self):
        """What the dialog says, in the words of gradmesh.simplify()."""
        options = self.options
        chosen = {
            name: getattr(options, name)
            for name in (
                "method metric resolution seed omega kappa time_budget preview visible_only "
                "keep_original remember_original"
            ).split()
        }
        if options.result not in ("simplest", "one-mesh", "blocks"):
            raise ValueError(
                f"results are simplest, one-mesh or blocks, not '{options.result}'"
            )
        if options.result == "one-mesh":
            chosen["method"] = PLAIN
        elif options.result == "simplest" and chosen["method"] == BLOCKS:
            chosen["method"] = "simplest"
        # The dialog keeps what was typed there for another run.
        chosen["edges"] = self.edges() if chosen["method"] == "manual" else ()
        how_much = self.how_much()
        if chosen["method"] == BLOCKS and "patches" not in how_much:
            how_much.setdefault("count", "handles")
        return {**chosen, **how_much}

    def edges(self):
        """The edges to be merged by hand."""
        if self.options.amount in COUNTED:
            raise ValueError(
                _("the method Manual merges the edges that are named, not as many as it takes")
            )
        edges = halfedges(self.options.edges)
        if not edges:
            raise ValueError(_("the method Manual needs the edges to merge"))
        return edges

    def how_much(self):
        amount = self.options.amount
        if amount in EPSILON:
            share = SSIM_SHARE if self.options.metric == "ssim" else 1
            return {
                "epsilon": EPSILON[amount] * share,
                "max_local_error": MAX_LOCAL_ERROR[amount] * share,
            }
        bound = {"max_local_error": self.options.max_local_error or None}
        if amount == "custom":
            return {"epsilon": self.options.epsilon, **bound}
        if amount not in COUNTED:
            amounts = ", ".join([*EPSILON, "custom", *COUNTED])
            raise ValueError(f"how much is one of {amounts}, not '{amount}'")
        count = COUNTED[amount]
        if amount == count:
            return {count: getattr(self.options, count), **bound}
        return {"ratio": self.options.share / 100, "count": count, **bound}

    def simplify(self, ids, options, tell):
        with analysis_cache() as cache:
            return gradmesh.simplify(
                self.meshes, ids, **options, analysis_cache=cache, progress=tell, device_lost=log
            )

    def why_nothing_changed(self, results):
        stopped = {result.stopped for result in results}
        if all(result.method == PLAIN for result in results):
            text = self.why_no_handle_went(stopped)
        else:
            text = self.why_nothing_was_merged(stopped)
        return text.format(
            meshes=", ".join(result.id for result in results),
            seconds=self.options.time_budget,
            epsilon=self.how_much().get("epsilon"),
        )

    def why_no_handle_went(self, stopped):
        if "budget" in stopped:
            return _(
                "{meshes}: in {seconds} seconds no handle could be taken out, so the document stays as "
                "it was."
            )
        if "cancelled" in stopped:
            return _(
                "{meshes}: stopped before any handle was taken out, so the document stays as it was."
            )
        if "epsilon" not in self.how_much():
            return _(
                "{meshes}: there is no more than that, or no handle can be taken out, so the document "
                "stays as it was."
            )
        return _(
            "{meshes}: no handle can be taken out within an error of {epsilon:g}, so the document stays "
            "as it was."
        )

    def why_nothing_was_merged(self, stopped):
        if "budget" in stopped:
            return _(
                "{meshes}: in {seconds} seconds no patches could be merged, so the document stays as "
                "it was."
            )
        if "cancelled" in stopped:
            return _(
                "{meshes}: stopped before any patches were merged, so the document stays as it was."
            )
        if "epsilon" not in self.how_much():
            return _(
                "{meshes}: there is no more than that, or no patches can be merged, so the document "
                "stays as it was."
            )
        return _(
            "{meshes}: nothing can be made simpler within an error of {epsilon:g}, so the document "
            "stays as it was."
        )

    def what_would_change(self, result):
        text = _(
            "{id}: {handles} of {handles_before} handles and {after} of {before} patches would be left, "
            "with an error of {metric} {error:.4f}."
        ).format(
            id=result.id,
            handles=result.handles_after,
            handles_before=result.handles_before,
            after=result.patches_after,
            before=result.patches_before,
            metric=self.options.metric.upper(),
            error=result.error,
        )
        if result.objects > 1:
            text += " " + _("They would be {objects} objects.").format(objects=result.objects)
        epsilon = self.how_much().get("epsilon", 1)
        if result.error > epsilon:
            text += " " + _("That is above the largest error, {epsilon:g}.").format(epsilon=epsilon)
        bound = self.how_much()["max_local_error"]
        if bound is not None and result.local_error > bound:
            text += " " + _("In a small part it is {error:.4f}, above {bound:g}.").format(
                error=result.local_error, bound=bound
            )
        return text


def halfedges(text):
    """The numbers in a list such as "12, 40"; ValueError where something else is in it."""
    numbers = text.replace(",", " ").split()
    for number in numbers:
        if not re.fullmatch("[0-9]{1,9}", number):
            raise ValueError(
                _("half-edges are whole numbers with commas between them, not '{text}'").format(
                    text=number
                )
            )
    return list(map(int, numbers))


if __name__ == "__main__":
    Simplify().run()
