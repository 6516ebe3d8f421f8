"""The dialogs are as Inkscape and inkex have them, and what they ask for is what the core gets."""

import json
import os
import subprocess
import xml.etree.ElementTree as ET

import pytest

from built import PYTHON, ROOT
from extension_runs import INKEX, extension  # noqa: F401

import gradmesh

INX = "{http://www.inkscape.org/namespace/inkscape/extension}"
#: Of the menu, and of File > Open, Save As and Save a Copy.
ITEMS = sorted(file.stem.removeprefix("gradmesh_") for file in (ROOT / "inx").glob("*.inx"))

pytestmark = pytest.mark.skipif(not INKEX.is_dir(), reason="Inkscape is not installed")


@pytest.mark.parametrize("item", ITEMS)
def test_inkscape_accepts_the_dialog(item):
    from lxml import etree

    schema_file = INKEX / "inkscape.extension.rng"
    if not schema_file.exists():
        pytest.skip("this Inkscape brings no schema of dialogs")
    schema = etree.RelaxNG(etree.parse(str(schema_file)))
    dialog = etree.parse(str(ROOT / "inx" / f"gradmesh_{item}.inx"))
    # Inkscape reads it, but its schema knows it only since Inkscape 1.4.
    assert dialog.getroot().attrib.pop("translationdomain") == "gradmesh"
    # Heeded since 1.4.
    for effect in dialog.findall("{*}effect"):
        effect.attrib.pop("show-stderr", None)
    # Its schema has it as an attribute, but 1.2 looks for an element: with that alone Save As lists no copy.
    copies = dialog.findall("{*}output/{*}savecopyonly")
    assert [element.text for element in copies] == ["true"] * (item in ("publish", "swift", "compose"))
    for element in copies:
        element.getparent().remove(element)
    schema.assertValid(dialog)


@pytest.mark.parametrize("item", ITEMS)
def test_dialog_and_script_agree(extension, item):
    check = (
        "import unittest\n"
        "from inkex.tester.inx import InxMixin\n"
        "class Conventions(InxMixin, unittest.TestCase):\n"
        "    def test(self):\n"
        f"        self.assertInxIsGood('gradmesh_{item}.inx')\n"
        "unittest.main()\n"
    )
    done = subprocess.run(
        [PYTHON, "-c", check],
        cwd=extension,
        env={**os.environ, "PYTHONPATH": str(INKEX)},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr


#: What the dialog of Simplify has a default of its own for: targets, and bounds that may be off.
OWN_DEFAULTS = {"handles", "patches", "max_local_error", "time_budget"}


@pytest.mark.parametrize("item", ["simplify", "show_analysis"])
def test_dialogs_have_the_ranges_and_defaults_of_the_core(item):
    dialog = ET.parse(ROOT / "inx" / f"gradmesh_{item}.inx")
    held = 0
    for param in dialog.iter(INX + "param"):
        name, option = param.get("name"), gradmesh.options().get(param.get("name"))
        if option is None:
            continue
        offered = [choice.get("value") for choice in param]
        default = offered[0] if offered else param.text
        if name == "amount":
            # Inkscape's default is the first.
            assert offered == ["balanced", "gentle", "strong", "handles", "custom"]
            assert sorted(offered[:3]) == sorted(option["names"])
        elif offered:
            assert offered == option["names"] and default == option["default"]
        elif param.get("type") == "bool":
            assert json.loads(default) == option["default"]
        else:
            least, most = float(param.get("min")), float(param.get("max"))
            assert option.get("least", 1) <= least <= float(default) <= most <= option.get("most", float("inf"))
            assert name in OWN_DEFAULTS or float(default) == option["default"]
        held += 1
    assert held == {"simplify": 10, "show_analysis": 2}[item]


BALANCED, SIMPLEST, LEAST = {"amount": "balanced"}, {"method": "simplest"}, {"max_local_error": None}
BLOCKS = {"method": "best", "count": "handles"}
#: By what is said on the command line, or by preferences: how much and which method the core is asked
#: for. The first part is what dialogs before the one of two pages had, which scripts go on to say.
ASKED = {
    "": {**BALANCED, **SIMPLEST},
    "--amount=balanced --result=simplest --tab=result": {**BALANCED, **SIMPLEST},
    "--amount=gentle --visible_only=false": {"amount": "gentle", **SIMPLEST, "visible_only": False},
    "--amount=strong --result=one-mesh": {"amount": "strong", "method": "plain"},
    "--result=lines": {**BALANCED, "method": "lines"},
    "--result=gqe --tab=help": {**BALANCED, "method": "gqe"},
    "--result=blocks": {**BALANCED, **BLOCKS},
    "--amount=custom": {"epsilon": None, **SIMPLEST, **LEAST},
    "--amount=custom --epsilon=0.03": {"epsilon": 0.03, **SIMPLEST, **LEAST},
    "--amount=custom --epsilon=0 --max_local_error=0.2": {"epsilon": 0, **SIMPLEST, "max_local_error": 0.2},
    "--amount=handles --handles=7 --result=blocks": {"handles": 7, **BLOCKS, **LEAST},
    "--amount=patches --patches=9 --result=blocks": {"patches": 9, "method": "best", **LEAST},
    "--amount=share --share=20": {"ratio": 0.2, "count": "handles", **SIMPLEST, **LEAST},
    "--amount=patch-share --share=20 --result=gqe": {"ratio": 0.2, "count": "patches", "method": "gqe", **LEAST},
    # What the page More holds, where the first leaves it to that page, and where it does not.
    "--amount=usual --limit=share --other_result=gqe": {**BALANCED, **SIMPLEST},
    "--amount=custom --limit=epsilon --epsilon=0.03": {"epsilon": 0.03, **SIMPLEST, **LEAST},
    "--amount=custom --limit=share --share=20": {"ratio": 0.2, "count": "handles", **SIMPLEST, **LEAST},
    "--amount=custom --limit=patches --patches=9": {"patches": 9, **SIMPLEST, **LEAST},
    "--amount=custom --limit=patch-share --share=20": {"ratio": 0.2, "count": "patches", **SIMPLEST, **LEAST},
    "--result=more --other_result=lines": {**BALANCED, "method": "lines"},
    "--result=more --other_result=gqe": {**BALANCED, "method": "gqe"},
}


def test_what_is_asked_for_is_what_the_core_gets(extension):
    check = (
        "import json, sys\n"
        "from gradmesh_simplify import Simplify\n"
        "for line in json.load(sys.stdin):\n"
        "    simplify = Simplify()\n"
        "    simplify.parse_arguments(line.split())\n"
        "    print(json.dumps(simplify.core_options()))\n"
    )
    done = subprocess.run(
        [PYTHON, "-c", check],
        cwd=extension,
        env={**os.environ, "PYTHONPATH": f"{extension.parent}{os.pathsep}{INKEX}", "GRADMESH_UNATTENDED": "0"},
        input=json.dumps(list(ASKED)),
        capture_output=True,
        text=True,
    )
    got_each = [json.loads(line) for line in done.stdout.splitlines()]
    assert done.stderr == "" and len(got_each) == len(ASKED)
    names = {name for options in ASKED.values() for name in options}
    for line, got in zip(ASKED, got_each):
        wanted = {"visible_only": None, **ASKED[line]}
        assert {name: got[name] for name in got if name in names} == wanted, line
