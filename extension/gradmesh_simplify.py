#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Extensions > Gradient Mesh > Simplify: takes needless handles and patches out of gradient meshes."""

from gradmesh_effect import (
    MORE_THAN_STRONG,
    SHAPES,
    STRONG,
    GradmeshEffect,
    NothingToDo,
    etree,
    gradmesh,
    refusals_as_sentences,
)
from gradmesh_cache import analysis_cache
from gradmesh_inkex import Boolean
from gradmesh_log import log
from gradmesh_report import report
from gradmesh_text import _
from gradmesh_window import LongWork

#: The method by which a mesh becomes what the dialog offers.
METHODS = {"simplest": "simplest", "one-mesh": "plain", "lines": "lines", "blocks": "best", "gqe": "gqe"}
#: What preferences and scripts of before say for the amount that the dialog begins with.
USUAL = {"usual": "balanced"}
AMOUNTS = {"gentle": _("Gentle"), "balanced": _("Balanced"), "strong": _("Strong")}
#: What is counted by the amounts that are a number or a share.
COUNTED = {"handles": "handles", "share": "handles", "patches": "patches", "patch-share": "patches"}

AS_SIMPLE_AS_ALLOWED = _(
    "{meshes}: as simple as {amount} allows, with {handles} handles, so the document stays as it was."
)
#: Why nothing changed, by how a run ended: where all meshes were to lose handles, and otherwise.
NO_HANDLE_WENT = {
    "budget": _(
        "{meshes}: in {seconds} seconds no handle could be taken out, so the document stays as "
        "it was."
    ),
    "cancelled": _(
        "{meshes}: stopped before any handle was taken out, so the document stays as it was."
    ),
    "target": _(
        "{meshes}: there is no more than that, or no handle can be taken out, so the document "
        "stays as it was."
    ),
    "amount": AS_SIMPLE_AS_ALLOWED,
    "epsilon": _(
        "{meshes}: no handle can be taken out within an error of {epsilon:g}, so the document stays "
        "as it was."
    ),
}
NOTHING_WAS_MERGED = {
    "budget": _(
        "{meshes}: in {seconds} seconds no patches could be merged, so the document stays as "
        "it was."
    ),
    "cancelled": _(
        "{meshes}: stopped before any patches were merged, so the document stays as it was."
    ),
    "target": _(
        "{meshes}: there is no more than that, or no patches can be merged, so the document "
        "stays as it was."
    ),
    "amount": AS_SIMPLE_AS_ALLOWED,
    "epsilon": _(
        "{meshes}: nothing can be made simpler within an error of {epsilon:g}, so the document "
        "stays as it was."
    ),
}


class Simplify(GradmeshEffect):
    """Simplifies the selected gradient meshes, or all of the document where nothing is selected."""

    def add_arguments(self, pars):
        super().add_arguments(pars)
        pars.add_argument("--tab")  # the page that was open, which Inkscape passes too
        # The core checks the values, as Inkscape passes on any choice that its preferences hold, and
        # has defaults for what is not named here.
        pars.add_argument("--amount", default="balanced")
        pars.add_argument("--limit", default="epsilon")
        pars.add_argument("--epsilon", type=float)
        pars.add_argument("--handles", type=int, default=100)
        pars.add_argument("--patches", type=int, default=50)
        pars.add_argument("--share", type=float, default=50)
        pars.add_argument("--result", default="simplest")
        pars.add_argument("--other_result", default="lines")
        pars.add_argument("--omega", type=float)
        pars.add_argument("--keep_original", type=Boolean)
        pars.add_argument("--remember_original", type=Boolean)
        pars.add_argument("--metric")
        pars.add_argument("--max_local_error", type=float, default=0)
        pars.add_argument("--resolution", type=int)
        pars.add_argument("--visible_only", type=Boolean)
        pars.add_argument("--time_budget", type=int, default=30)
        pars.add_argument("--preview", type=Boolean)
        pars.add_argument("--protect_selected", type=Boolean)

    def effect(self):
        ids = self.selected_or_all()
        with refusals_as_sentences():
            options = self.core_options()
            work = LongWork(self.titles(ids), lambda tell: self.simplify(ids, options, tell))
            results = work.run()
        report.meshes = results
        if not any(result.changed for result in results):
            raise NothingToDo(self.why_nothing_changed(results))
        if self.options.preview:
            self.tell("\n".join(map(self.what_would_change, results)))
            report.outcome = "unchanged"
        else:
            self.take_over()
            self.became = self.what_became(results)

    def titles(self, ids):
        """What the progress window says while each of the meshes is at work."""
        if len(ids) == 1:
            return [_("Simplifying {id}").format(id=self.called(ids[0]))]
        text = _("Simplifying {id}, {number} of {count}")
        titles = [text.format(id=self.called(name), number=n, count=len(ids)) for n, name in enumerate(ids, 1)]
        if self.options.ids:
            return titles
        return [_("Nothing is selected, so all are simplified.") + "\n" + title for title in titles]

    @property
    def amount(self):
        """How much, which the first page of the dialog may leave to the second."""
        amount = self.options.limit if self.options.amount == "custom" else self.options.amount
        return USUAL.get(amount, amount)

    @property
    def result(self):
        """What each mesh becomes, which the first page of the dialog may leave to the second."""
        return self.options.other_result if self.options.result == "more" else self.options.result

    def core_options(self):
        """What the dialog says, in the words of gradmesh.simplify()."""
        if self.result not in METHODS:
            raise ValueError(f"results are {', '.join(METHODS)}, not '{self.result}'")
        names = (
            "metric resolution omega time_budget preview visible_only keep_original remember_original"
        )
        chosen = {name: getattr(self.options, name) for name in names.split()}
        chosen.update(self.how_much(), method=METHODS[self.result])
        if self.options.protect_selected:
            chosen["protect"] = self.shapes_beside()
        # Blocks that a person is to edit have few handles, unless it is patches that are to be few.
        if self.result == "blocks" and "patches" not in chosen:
            chosen.setdefault("count", "handles")
        return chosen

    def shapes_beside(self):
        """Ids of the selected shapes that no mesh paints."""
        painted = {e for e in self.svg.iter("*") if e.get("id") in self.meshes.ids}
        return [
            element.get("id")
            for element in self.chosen_elements()
            if etree.QName(element).localname in SHAPES
            and not painted.intersection([element, *element.iterancestors()])
        ]

    def how_much(self):
        options, amount = self.options, self.amount
        bound = {"max_local_error": options.max_local_error or None}
        if amount == "epsilon":
            return {"epsilon": options.epsilon, **bound}
        if amount not in COUNTED:
            return {"amount": amount}
        count = COUNTED[amount]
        if amount == count:
            return {count: getattr(options, count), **bound}
        return {"ratio": options.share / 100, "count": count, **bound}

    def simplify(self, ids, options, tell):
        with analysis_cache() as cache:
            return gradmesh.simplify(
                self.meshes, ids, **options, analysis_cache=cache, progress=tell, device_lost=log
            )

    def why_nothing_changed(self, results):
        are_plain = all(result.method == "plain" for result in results)
        stopped = {result.stopped for result in results}
        ends = [end for end in ("budget", "cancelled") if end in stopped]
        ends.append("target" if self.amount in COUNTED else "amount" if self.amount in AMOUNTS else "epsilon")
        why = (NO_HANDLE_WENT if are_plain else NOTHING_WAS_MERGED)[ends[0]].format(
            meshes=", ".join(self.called(result.id) for result in results),
            amount=AMOUNTS.get(self.amount),
            handles=sum(result.handles_after for result in results),
            seconds=self.options.time_budget,
            epsilon=results[0].run["epsilon"],
        )
        return " ".join([why, *self.what_was_protected(results)])

    def what_was_protected(self, results):
        """The sentence, if there is one, that says why so much was kept."""
        count = sum(result.protected_patches for result in results)
        if count and all(result.objects == 1 for result in results):
            yield _("{count} patches are protected, and lines that cross them stay.").format(count=count)
        elif count:
            yield _("{count} patches are protected.").format(count=count)

    def what_became(self, results):
        """The sentences that a person is told after a run."""
        changed = [result for result in results if result.changed]
        numbers = {
            "id": self.called(changed[0].id),
            "count": len(changed),
            "handles": sum(result.handles_after for result in changed),
            "before": sum(result.handles_before for result in changed),
            "metric": changed[0].run["metric"].upper(),
            "error": max(result.error for result in changed),
            "more": max(result.error - result.error_before for result in changed),
        }
        if len(changed) == 1:
            yield _("{id}: {handles} of {before} handles are left, {metric} {error:.3f}.").format(**numbers)
        else:
            text = _("{count} gradient meshes: {handles} of {before} handles are left, {metric} up to {error:.3f}.")
            yield text.format(**numbers)
        yield from self.what_was_protected(results)
        if self.amount in COUNTED and numbers["more"] > STRONG[changed[0].run["metric"]]:
            yield MORE_THAN_STRONG
        if any(result.stopped == "cancelled" for result in results):
            if len(results) == 1:
                yield _("It was stopped before the end; Ctrl+Z takes it back.")
            else:
                text = _(
                    "Stopped: {count} of {all} meshes are simplified, the last one not to the end; "
                    "Ctrl+Z takes it back."
                )
                yield text.format(count=len(changed), all=len(results))
        elif any(result.stopped == "budget" for result in results):
            yield _("The time that is allowed under More was over before the end.")
        if self.left_out:
            yield _("{count} locked or hidden meshes were left out.").format(count=self.left_out)

    def what_would_change(self, result):
        text = _(
            "{id}: {handles} of {handles_before} handles and {after} of {before} patches would be left, "
            "with an error of {metric} {error:.4f}."
        ).format(
            id=self.called(result.id),
            handles=result.handles_after,
            handles_before=result.handles_before,
            after=result.patches_after,
            before=result.patches_before,
            metric=result.run["metric"].upper(),
            error=result.error,
        )
        if result.objects > 1:
            text += " " + _("They would be {objects} objects.").format(objects=result.objects)
        epsilon, bound = result.run["epsilon"], result.run["max_local_error"]
        if self.amount not in COUNTED and result.error - result.error_before > epsilon:
            text += " " + _("That is above the largest error, {epsilon:g}.").format(epsilon=epsilon)
        if bound is not None and result.local_error > bound:
            text += " " + _("In a small part it is {error:.4f}, above {bound:g}.").format(
                error=result.local_error, bound=bound
            )
        return text


if __name__ == "__main__":
    Simplify().run()
