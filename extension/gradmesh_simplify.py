#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Inkscape's Extensions > Gradient Mesh > Simplify: hands the document to gradmesh, and back.

Inkscape shows every byte on stderr in a dialog that waits for a person. So a run that succeeds is
silent; one that does not, or that was only to tell what it would do, writes plain sentences and
leaves the document as it is.
"""

import io
import os
import re
import sys
import traceback
from pathlib import Path

NOT_INSTALLED = (
    "Gradient meshes cannot be simplified because a part of the extension does not load in Python "
    "{version} ({error}): run scripts/demo of gradmesh again, which installs what is missing."
)

try:
    import inkex
    from inkex.elements import load_svg

    import gradmesh
except ImportError as missing:
    sys.exit(NOT_INSTALLED.format(version=sys.version.split()[0], error=missing))


class Simplify(inkex.EffectExtension):
    """Simplifies the gradient meshes among the selected objects."""

    def add_arguments(self, pars):
        def refuse(message):
            raise inkex.AbortExtension(sentence(f"These settings do not work: {message}"))

        pars.error = refuse  # argparse would print its usage too
        pars.add_argument("--tab")  # the one that was open, which Inkscape passes too
        # The core checks the values: Inkscape passes on any choice that its preferences hold.
        pars.add_argument("--epsilon", type=float, default=0.01)
        pars.add_argument("--time_budget", type=int, default=60)
        pars.add_argument("--preview", type=inkex.Boolean, default=False)
        pars.add_argument("--method", default="motorcycle")
        pars.add_argument("--kappa", type=float, default=0.05)
        pars.add_argument("--omega", type=float, default=0.75)
        pars.add_argument("--seed", type=int, default=0)
        pars.add_argument("--edges", default="")
        pars.add_argument("--metric", default="flip")
        pars.add_argument("--resolution", type=int, default=700)

    def load(self, stream):
        data = getattr(stream, "buffer", stream).read()
        # Inkscape sends a copy under a temporary name and says the real one here.
        name = os.path.basename(os.environ.get("DOCUMENT_PATH") or "") or "the document"
        try:
            self.meshes = gradmesh.loads(data, name)
        except gradmesh.InputError as error:
            raise inkex.AbortExtension(sentence(error)) from error
        return super().load(io.BytesIO(data))

    def effect(self):
        results = self.simplify(self.selected_meshes())
        if all(result.patches_after == result.patches_before for result in results):
            raise inkex.AbortExtension(self.why_nothing_changed(results))
        if self.options.preview:
            inkex.errormsg("\n".join(map(self.what_would_change, results)))
        else:
            self.document = load_svg(self.meshes.to_bytes())

    def simplify(self, ids):
        options = self.options
        try:
            return gradmesh.simplify(
                self.meshes,
                ids,
                method=options.method,
                metric=options.metric,
                epsilon=options.epsilon,
                resolution=options.resolution,
                seed=options.seed,
                omega=options.omega,
                kappa=options.kappa,
                # The dialog keeps what was typed there for another run.
                edges=halfedges(options.edges) if options.method == "manual" else (),
                time_budget=options.time_budget,
                preview=options.preview,
            )
        except gradmesh.InputError as error:
            raise inkex.AbortExtension(sentence(error)) from error
        except ValueError as error:
            raise inkex.AbortExtension(sentence(f"These settings do not work: {error}")) from error

    def selected_meshes(self):
        """Ids of the selected objects that a mesh paints, in groups too."""
        if not self.options.ids:
            raise inkex.AbortExtension("Select an object that is painted by a gradient mesh first.")
        missing = [name for name in self.options.ids if self.svg.getElementById(name) is None]
        if missing:
            raise inkex.AbortExtension(f'There is no object with the id "{missing[0]}".')
        inside = {
            element.get("id")
            for chosen in self.svg.selection
            for element in chosen.iter("*")
        }
        found = [name for name in self.meshes.ids if name in inside]
        if not found:
            raise inkex.AbortExtension(
                "None of the selected objects is painted by a gradient mesh; select one that is."
            )
        return found

    def why_nothing_changed(self, results):
        names = ", ".join(result.id for result in results)
        if any(result.stopped == "budget" for result in results):
            why = f"in {self.options.time_budget} seconds no patches could be merged"
        else:
            why = f"no patches can be merged within an error of {self.options.epsilon:g}"
        return f"{names}: {why}, so the document stays as it was."

    def what_would_change(self, result):
        error = f"{self.options.metric.upper()} {result.error:.4f}"
        patches = f"{result.patches_after} of {result.patches_before} patches"
        text = f"{result.id}: {patches} would be left, with an error of {error}."
        if result.error > self.options.epsilon:
            text += f" That is above the largest error, {self.options.epsilon:g}."
        return text

    def run(self, args=None, output=inkex.base.stdout):
        try:
            super().run(args, output)
        except Exception as error:  # pylint: disable=broad-except
            where = log(traceback.format_exc())
            inkex.errormsg(
                f"The meshes were not simplified because of a fault in gradmesh "
                f"({type(error).__name__}){where}; the document stays as it was."
            )
            sys.exit(1)


def halfedges(text):
    """The numbers in a list such as "12, 40"; ValueError where something else is in it."""
    numbers = text.replace(",", " ").split()
    for number in numbers:
        if not re.fullmatch("[0-9]+", number):
            raise ValueError(f"half-edges are whole numbers with commas between them, not '{number}'")
    return list(map(int, numbers))


def sentence(message):
    """The message as a sentence: one line, a full stop at its end."""
    text = " ".join(str(message).split())
    return text if text.endswith(".") else text + "."


def log(text):
    """Adds to the log in the user's cache folder; says where, or nothing where that fails."""
    cache = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    file = Path(cache) / "gradmesh" / "simplify.log"
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        with open(file, "a", encoding="utf-8") as stream:
            stream.write(text + "\n")
    except OSError:
        return ""
    return f", described in {file}"


if __name__ == "__main__":
    Simplify().run()
