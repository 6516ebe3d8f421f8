# SPDX-License-Identifier: GPL-2.0-or-later
"""What all items of Inkscape's Extensions > Gradient Mesh share: a document to gradmesh, and back.

Inkscape shows every byte on stderr in a dialog that waits for a person, and says that something may be
wrong. So only faults are written there, as plain sentences. What was done, and why nothing was done where
nothing is wrong, is said by the line at the lower end of the screen, where that can be seen.
"""

# First of all, so that what fails from here on is told to somebody.
import gradmesh_attended  # noqa: F401

import io
import os
import sys
import traceback
from contextlib import contextmanager
from functools import cached_property

from gradmesh_log import log
from gradmesh_report import report
from gradmesh_needs import why_it_does_not_load
from gradmesh_text import _, in_all_languages, sentence, translated
from gradmesh_toast import is_seen, toast

# Drivers of graphics processors that gradmesh looks at would otherwise warn on stderr.
os.environ.setdefault("EGL_LOG_LEVEL", "fatal")

try:
    import gradmesh
    from gradmesh_inkex import (
        AbortExtension,
        EffectExtension,
        OutputExtension,
        errormsg,
        etree,
        load_svg,
    )
except ImportError as missing:
    report.messages.append(why_it_does_not_load(missing))
    sys.exit(report.messages[-1])


NAMESPACE = "urn:gradmesh"
etree.register_namespace("gradmesh", NAMESPACE)
#: Of elements that Show Analysis has added.
MARK = f"{{{NAMESPACE}}}analysis"
#: Of shapes where a trace is to come closer to its picture.
CLOSER = f"{{{NAMESPACE}}}closer"
LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
#: The same where gradmesh wrote it.
WRITTEN_LABEL = f"{{{NAMESPACE}}}label"
LOCKED = "{http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd}insensitive"
HREF = "{http://www.w3.org/1999/xlink}href"
#: What covers something.
SHAPES = {"path", "rect", "circle", "ellipse", "polygon", "polyline"}
#: The error that Strong allows, by metric.
STRONG = {"flip": 0.02, "ssim": 0.01}
MORE_THAN_STRONG = _("That is more than Strong allows: it will be seen.")


class News(Exception):
    """Raised with a sentence where the document stays as it is though nothing is broken: another selection or
    other settings help. Of an AbortExtension Inkscape's dialog would tell."""


class NothingToDo(News):
    """Raised where no other selection is needed either."""


def say(text):
    """Says something although the run goes on."""
    errormsg(text)
    report.messages.append(text)


class Gradmesh:
    """Mixed into effects and readers: refusals in one sentence, faults in the log."""

    #: The sentences that are told after a run.
    became = ()
    #: Those on what was left alone although the run went on.
    left_alone = ()

    def add_arguments(self, pars):
        def refuse(message):
            raise AbortExtension(settings_do_not_work(message))

        pars.error = refuse  # argparse would print its usage too

    def run(self, *args, **keywords):
        try:
            super().run(*args, **keywords)
            report.outcome = report.outcome or "done"
            self.tell_what_became()
        except News as news:
            report.outcome = "unchanged" if isinstance(news, NothingToDo) else "refused"
            self.tell(str(news))
            sys.exit(1)
        except SystemExit as end:  # by inkex, which has told the message of an AbortExtension
            report.outcome = "refused"
            report.messages.append(str(end.__context__))
            raise
        except gradmesh.HelperError as error:
            report.outcome = "refused"
            say(sentence(translated(error.message)))
            sys.exit(1)
        except Exception as error:  # pylint: disable=broad-except
            where = log(traceback.format_exc())
            fault = _("Nothing was done because of a fault in gradmesh ({fault}).")
            if where:
                fault = _("Nothing was done because of a fault in gradmesh ({fault}), described in {file}.")
            say(fault.format(fault=type(error).__name__, file=where))
            sys.exit(1)
        finally:
            report.ids = getattr(self.options, "ids", [])

    def tell(self, text):
        """Says what is no fault by the line, or as faults are said where no line is seen."""
        if self.has_a_line():
            toast(text, self.options.input_file)
            report.messages.append(text)
        else:
            say(text)

    def tell_what_became(self):
        sentences = list(self.became)
        if self.left_alone and self.has_a_line():
            sentences += self.left_alone
            report.messages.extend(self.left_alone)
        else:
            for reason in self.left_alone:
                say(reason)
        if sentences:
            toast(" ".join(sentences), self.options.input_file)

    def has_a_line(self):
        """Whether what is no fault is said by the line: not where a file is read or written, which then fails."""
        return isinstance(self, EffectExtension) and is_seen()


class _GradmeshDocument(Gradmesh):
    """Reads the document with gradmesh, too; its meshes are in `meshes`."""

    #: The document as Inkscape has it on its canvas.
    shown = None
    #: How many meshes were left out as they are locked or hidden.
    left_out = 0

    def load(self, stream):
        data = getattr(stream, "buffer", stream).read()
        self.shown = data
        self.load_meshes(data)
        return super().load(io.BytesIO(data))

    def load_meshes(self, data):
        with refusals_as_sentences(AbortExtension):
            self.meshes = gradmesh.loads(data, self.document_name, _, self.folders)

    @property
    def folders(self):
        """Where linked pictures are looked for: beside Inkscape's copy of the document, to which it makes links
        relative, and beside the document, as it leaves some."""
        files = (self.options.input_file, os.environ.get("DOCUMENT_PATH"))
        return [os.path.dirname(os.path.abspath(file)) for file in files if isinstance(file, str) and file]

    @property
    def document_name(self):
        """What sentences call the document: Inkscape sends a copy under a temporary name and says the real
        one here."""
        return os.path.basename(os.environ.get("DOCUMENT_PATH") or "") or _("the document")

    def selected_meshes(self):
        """Ids of the selected objects that a mesh paints, those in selected groups, and those whose
        blocks are selected."""
        if not self.options.ids:
            raise News(_("Select an object that is painted by a gradient mesh first."))
        touched = {
            element.get("id")
            for chosen in self.chosen_elements()
            for element in (*chosen.iter("*"), *chosen.iterancestors("{*}g"))
        }
        found = [name for name in self.meshes.ids if name in touched]
        if not found:
            self.refuse_clones()
            raise News(
                _("None of the selected objects is painted by a gradient mesh; select one that is.")
            )
        return self.readable(found)

    def refuse_clones(self):
        """Says of a selected clone of a mesh how its original is selected."""
        elements = self.elements_by_id()
        for name in self.options.ids:
            if original_of(name, elements) in self.meshes.ids:
                raise News(
                    _("{id} is a clone: Shift+D selects its original, which can be changed.").format(id=name)
                )

    def selected_or_all(self):
        """Ids as of selected_meshes(), or, where nothing is selected, of all meshes that Inkscape would
        select with all: not of those that are locked or hidden."""
        if self.options.ids:
            return self.selected_meshes()
        if not self.meshes.ids:
            raise News(_("There is no gradient mesh in the document."))
        elements = self.elements_by_id()
        ids = [mesh.id for mesh in self.meshes.meshes]
        within_reach = [name for name in ids if not is_locked_or_hidden(elements[name])]
        self.left_out = len(ids) - len(within_reach)
        if not within_reach:
            raise News(
                _("All gradient meshes, or their layers, are locked or hidden. Select the meshes that you mean.")
            )
        return self.readable(within_reach)

    def readable(self, ids):
        """Those of the meshes that can be read. Says why the others are left alone; where there are
        no others, that ends the run."""
        meshes = [mesh for mesh in self.meshes.meshes if mesh.id in ids]
        refused = [mesh for mesh in meshes if mesh.refused]
        why = [sentence(translated(mesh.refused.message)) for mesh in refused]
        if len(refused) == len(meshes):
            raise AbortExtension(why[0])
        self.left_alone = [_("Left as it was: {reason}").format(reason=reason) for reason in why]
        report.refused = refused
        readable = {mesh.id for mesh in meshes if not mesh.refused}
        return [name for name in ids if name in readable]

    def chosen_elements(self):
        elements = self.elements_by_id()
        missing = [name for name in self.options.ids if name not in elements]
        if missing:
            raise News(_('There is no object with the id "{id}".').format(id=missing[0]))
        return [elements[name] for name in self.options.ids]

    def called(self, name):
        """What a person calls an object: its label, or else its id."""
        return self._labels.get(name) or name

    @cached_property
    def _labels(self):
        """Of the objects as they came, but those labels that gradmesh wrote."""
        return {e.get("id"): e.get(LABEL) for e in self.svg.iter("*") if e.get(LABEL) and not has_written_label(e)}

    def elements_by_id(self):
        return {element.get("id"): element for element in self.svg.iter("*")}


def has_written_label(element):
    """Whether gradmesh wrote the label of an element, such as "Gradient mesh: 140 handles, 80 patches"."""
    label = element.get(LABEL)
    if label == element.get(WRITTEN_LABEL):
        return True
    beginnings = (text.partition("{")[0] for text in in_all_languages("Gradient mesh: {0} handles, {1} patches"))
    return any(words and label.startswith(words) for words in beginnings)


def original_of(name, elements):
    """The id of what a clone shows, or a clone of a clone; another's own. Clones in a circle show none."""
    passed = set()
    while name in elements and name not in passed and etree.QName(elements[name]).localname == "use":
        passed.add(name)
        name = (elements[name].get(HREF) or elements[name].get("href") or "").lstrip("#")
    return name


def is_locked_or_hidden(element):
    """Whether Inkscape leaves an object out where all are selected."""
    for each in (element, *element.iterancestors()):
        style = (each.get("style") or "").replace(" ", "")
        if each.get(LOCKED) == "true" or each.get("display") == "none" or "display:none" in style:
            return True
    return False


class GradmeshEffect(_GradmeshDocument, EffectExtension):
    """An effect on gradient meshes of the document."""

    def take_over(self):
        """Makes what gradmesh made of the document that Inkscape shows the document."""
        self.called("")  # as the objects came
        self.document = load_svg(self.meshes.to_bytes(over=self.shown))


class GradmeshOutput(_GradmeshDocument, OutputExtension):
    """Writes what is not SVG."""


@contextmanager
def refusals_as_sentences(kind=News, news=()):
    """What gradmesh refuses ends the run with its sentence, raised as this kind; as news if it is in such words."""
    try:
        yield
    except gradmesh.InputError as error:
        kind = News if error.message[0] in news else kind
        raise kind(sentence(translated(error.message))) from error
    except MemoryError as error:
        raise AbortExtension(
            _("There is not enough memory for this, so the document stays as it was.")
        ) from error
    except ValueError as error:
        raise AbortExtension(settings_do_not_work(error)) from error


def settings_do_not_work(why):
    return sentence(_("These settings do not work: {why}").format(why=why))
