"""What the extension says is translated, with what it passes on from the core."""

import ast
import gettext
import os
import re
import subprocess
import xml.etree.ElementTree as ET
from io import BytesIO
from itertools import combinations
from string import Formatter

import pytest

from bad_documents import BAD
from built import BUILD, ROOT, SAMPLES
from extension_runs import INKEX, extension, refused, run  # noqa: F401
from svg_meshes import Document

import gradmesh

PO = ROOT / "extension" / "po" / "de.po"
BUILT = BUILD / "extension" / "po"
GERMAN = {"LANGUAGE": "de", "LC_ALL": "C.UTF-8"}

#: A message in C++ with its template, one literal or several in a row.
TEMPLATE = re.compile(r'\b(?:Message|InputError)(?:\s+\w+)?[({]\s*((?:"(?:[^"\\]|\\.)*"\s*)+)')

pytestmark = [
    pytest.mark.skipif(not INKEX.is_dir(), reason="Inkscape is not installed"),
    pytest.mark.skipif(not BUILT.is_dir(), reason="not installed: gettext, by which the build makes it"),
]


def output(*command, **how):
    return subprocess.run(command, capture_output=True, check=True, **how).stdout


def catalogue(po):
    """The messages of a catalogue and their translations."""
    mo = output("msgfmt", "-o", "-", "-", input=po)
    return {a: b for a, b in gettext.GNUTranslations(BytesIO(mo))._catalog.items() if a}


def test_messages_are_translated(run):
    said = refused(run(SAMPLES / "fruit.svg", item="merge", **GERMAN))
    assert said.startswith("Zwei oder mehr Blöcke eines")


def test_every_message_of_the_core_reaches_the_template():
    """But those of the command line."""
    files = [file for file in (ROOT / "native").rglob("*.*") if file.suffix in (".h", ".cpp")]
    templates = {
        ast.literal_eval(f"({found})")
        for file in files
        if file.parent.name != "cli"
        for found in TEMPLATE.findall(file.read_text())
    }
    assert len(templates) > 100
    assert templates - set(catalogue(output("msgen", BUILT / "gradmesh.pot"))) == set()


def test_the_german_catalogue_is_complete():
    merged = output("msgmerge", "-q", "-o", "-", PO, BUILT / "gradmesh.pot")
    done = subprocess.run(
        ["msgfmt", "--statistics", "-o", os.devnull, "-"], input=merged, capture_output=True
    )
    assert re.fullmatch(rb"\d+ translated messages\.\n", done.stderr), done.stderr


def places(text):
    return {name for _text, name, _format, _conversion in Formatter().parse(text) if name is not None}


def test_a_translation_has_the_places_of_its_message():
    for text, said in catalogue(PO.read_bytes()).items():
        if "{" in text:
            assert places(said) == places(text), text


@pytest.mark.parametrize(
    "document, item, options, said",
    [
        (
            "fruit",
            "merge",
            [],
            'path "pear": bitte Zeilen und Spalten davon oder Blöcke auswählen, nicht das ganze Gitter.',
        ),
        ("fruit", "refine", ["--row=99"], '"pear": es gibt keine Zeile 99, nur 11 Zeilen.'),
        (
            "ragged rows",
            "simplify",
            [],
            'meshgradient "m": Zeile 2 hat nicht so viele Felder wie Zeile 1: 1, nicht 2.',
        ),
        (
            "no path",
            "simplify",
            [],
            'meshgradient "m": Zeile 1, Feld 1, Farbstopp 1: der Pfad "" ist nicht ein Abschnitt c, C, l '
            "oder L aus Zahlen zwischen -1e9 und 1e9.",
        ),
    ],
)
@pytest.mark.full(all_but=1)
def test_a_refusal_of_the_core_is_german_throughout(run, document, item, options, said):
    if document in BAD:
        done = run(BAD[document].text, "--id=box", *options, item=item, **GERMAN)
    else:
        done = run(SAMPLES / f"{document}.svg", "--id=pear", *options, item=item, **GERMAN)
    assert refused(done) == f"apple.svg: {said}\n"


def label(svg):
    """Of the pear."""
    (pear,) = [e for e in ET.fromstring(svg).iter() if e.get("id") == "pear"]
    return pear.get("{http://www.inkscape.org/namespaces/inkscape}label")


@pytest.mark.full
def test_labels_are_german_and_go_with_the_blocks(run):
    options = ("--id=pear", "--result=blocks", "--resolution=150")
    simplified = run(SAMPLES / "fruit.svg", *options, **GERMAN).stdout
    german = label(simplified)
    assert re.fullmatch(r"Verlaufsgitter: \d+ von 660 Anfassern, \d+ von 132 Feldern, FLIP 0\.\d{4}", german)
    assert label(run(simplified, "--id=pear", item="to_one_mesh").stdout) is None
    own = simplified.replace(f'inkscape:label="{german}"', 'inkscape:label="Verlaufsgitter"')
    assert label(run(own, "--id=pear", item="to_one_mesh").stdout) == "Verlaufsgitter"
    saved = run(SAMPLES / "fruit.svg", item="save").stdout
    assert 'inkscape:label="Verlaufsgitter: 660 Anfasser, 132 Felder"' in run(saved, item="open", **GERMAN).stdout


@pytest.mark.parametrize("show", ["edges", "errors", "faces", "motorcycle", "regions"])
@pytest.mark.full(all_but=1)
def test_drawings_are_german_throughout(run, show):
    """No text of a drawing is as in English, but for numbers."""

    def texts(language):
        options = ("--id=pear", f"--show={show}")
        drawn = run(SAMPLES / "fruit.svg", *options, item="show_analysis", **language)
        root = ET.fromstring(drawn.stdout)
        (layer,) = [e for e in root if e.get("{urn:gradmesh}analysis")]
        found = {text for e in layer.iter() for text in (e.text, label_of(e)) if text and text.strip()}
        return {text for text in found if re.search("[A-Za-z]{2}", text)}

    def label_of(element):
        return element.get("{http://www.inkscape.org/namespaces/inkscape}label")

    german = texts(GERMAN)
    assert len(german) > 3
    assert german & texts({}) == set()


def test_why_blocks_cannot_be_merged_is_german_throughout(run, tmp_path):
    document, file = gradmesh.load(SAMPLES / "fruit.svg"), tmp_path / "simple.svg"
    gradmesh.simplify(document, "pear", method="motorcycle", epsilon=0.02, resolution=200)
    gradmesh.save(document, file)
    reasons = {}
    for pair in combinations(Document(file).blocks(), 2):
        try:
            gradmesh.merge(gradmesh.load(file), pair, resolution=100)
        except gradmesh.InputError as error:
            _template, (_mesh, (_sentence, (reason,))) = error.message
            reasons.setdefault(reason[0], pair)
    assert len(reasons) == 2
    for pair in reasons.values():
        said = refused(run(file, *(f"--id={block}" for block in pair), item="merge", **GERMAN))
        assert re.fullmatch(
            'apple.svg: Gruppe "pear": diese Felder können nicht eines werden, '
            "(weil sie einander nicht an einer ganzen Seite berühren"
            "|wegen einer Kante zwischen ihnen: (sie|ein|eine|ihre) [^.]*)[.]\n",
            said,
        )
