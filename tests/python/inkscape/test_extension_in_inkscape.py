"""The extension in a real Inkscape: what its items do to a document, and what it looks like."""

import os
import re
import subprocess
import xml.etree.ElementTree as ET
from itertools import combinations
from pathlib import Path
from typing import NamedTuple

import pytest

import displays
import inkscape_harness
from built import PYTHON, SAMPLES, gradmesh as run, install_extension
from inkscape_harness import Inkscape

pytest.importorskip("numpy")
pytest.importorskip("PIL.Image")

import svg_meshes
from edited_blocks import Group
from pictures import difference, export, flip, info, write_bare_mesh
from test_pictures import SAME

import gradmesh

SVG = "{http://www.w3.org/2000/svg}"
LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
SODIPODI = "{http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd}"
VIEW, FILE_NAME = SODIPODI + "namedview", SODIPODI + "docname"
LABEL_TEXT = re.compile(
    r"Gradient mesh: \d+ of \d+ handles, (\d+) of (\d+) patches, (FLIP|1 - SSIM) (\d\.\d{4})"
)
EPSILON = 0.01
PAGE = 0.003  # the page has other pixels than the mesh was measured at
RAW_ID = "org.gradmesh.simplify"
INKEX = Path("/usr/share/inkscape/extensions")

reason = inkscape_harness.missing()
pytestmark = pytest.mark.skipif(bool(reason), reason=reason or "nothing is missing")

undoes_in_batch_runs = pytest.mark.skipif(
    not inkscape_harness.undoes_in_batch_runs(),
    reason="this Inkscape's action undo takes nothing back in batch runs",
)
window_reason = inkscape_harness.missing(*displays.WINDOW_PROGRAMS)
needs_window = pytest.mark.skipif(bool(window_reason), reason=window_reason or "nothing is missing")


@pytest.fixture(scope="module")
def extension(tmp_path_factory):
    return install_extension(tmp_path_factory.mktemp("installed"))


@pytest.fixture(scope="module")
def inkscape(extension):
    with Inkscape() as running:
        running.install(extension)
        yield running


def by_id(svg):
    return {element.get("id"): element for element in ET.parse(svg).iter() if element.get("id")}


def set_values(inkscape, item="simplify", **values):
    inkscape.set_values({f"org.gradmesh.{item}.{name}": value for name, value in values.items()})


def simplified(inkscape, sample, out, ids, **values):
    """The document out of Inkscape after Simplify ran on `ids` with these values."""
    set_values(inkscape, **values)
    inkscape.run_extension(RAW_ID, SAMPLES / f"{sample}.svg", out, select=ids)
    return by_id(out)


def all_but_the_view(svg):
    """The document, whatever file it was read from and window it was seen in."""
    options = {"exclude_tags": [VIEW], "exclude_attrs": [FILE_NAME]}
    return ET.canonicalize(from_file=svg, rewrite_prefixes=True, **options)


def written(path):
    """The actions that write the document as it is now."""
    return [f"export-filename:{path}", "export-do"]


def chosen(item, *ids):
    """The actions that select these objects and run an item."""
    select = ["select-clear", f"select-by-id:{','.join(ids)}"] if ids else ["select-clear"]
    return [*select, f"org.gradmesh.{item.replace('_', '-')}.noprefs"]


class Item(NamedTuple):
    """One item of the menu, with its values, and what it is tried on."""

    name: str
    document: str  # of those that `documents` makes
    select: str  # an object, or which blocks of the document
    within: float  # how far, in FLIP, the pictures may differ; 0: not but for rounding
    values: dict = {}


ONE_MESH = {"amount": "strong", "result": "one-mesh", "resolution": 600}
HERE = {"place": 30, "row": 1, "column": 1}
ITEMS = {
    "simplify": Item("simplify", "whole", "pear", EPSILON, {"resolution": 600}),
    "simplify to blocks": Item("simplify", "whole", "pear", EPSILON, {"result": "blocks", "resolution": 600}),
    "simplify to one mesh": Item("simplify", "whole", "pear", 2 * EPSILON, ONE_MESH),
    "merge": Item("merge", "simple", "pair", 2 * EPSILON, {"tell": "false"}),
    "refine": Item("refine", "simple", "block", 0, HERE),
    "refine across": Item("refine", "simple", "block", 0, {"whole": "true"}),
    "refine the whole": Item("refine", "whole", "pear", 0, {"direction": "rows"}),
    "update": Item("update", "torn", "pear", EPSILON),
    "to one mesh": Item("to_one_mesh", "simple", "pear", 0),
}


@pytest.fixture(scope="module")
def documents(tmp_path_factory):
    """The sample "fruit" with its pear as it is, simplified, and torn by an edit."""
    folder = tmp_path_factory.mktemp("documents")
    document = gradmesh.load(SAMPLES / "fruit.svg")
    gradmesh.save(document, folder / "whole.svg")
    gradmesh.simplify(document, "pear", method="motorcycle", epsilon=0.02)
    for name in ("simple", "torn"):
        gradmesh.save(document, folder / f"{name}.svg")
    group = Group(folder / "torn.svg")
    corner = group.shared_corner(3)
    group.move(group.owners(corner)[0], corner, 3 + 2j)
    return folder


def selection(which, document):
    """The ids of the object, of the first block, or of the blocks that merge with least error."""
    if which == "block":
        return [next(iter(svg_meshes.Document(document).blocks()))]
    if which != "pair":
        return [which]
    errors = {}
    for pair in combinations(svg_meshes.Document(document).blocks(), 2):
        try:
            edit = gradmesh.merge(gradmesh.load(document), pair, resolution=100)
            errors[pair] = edit.error
        except gradmesh.InputError:  # no neighbours, or no rectangle
            continue
    return min(errors, key=errors.get)


class Ran(NamedTuple):
    """What Inkscape has written before an item of the menu ran, after it, and after one undo."""

    item: Item
    before: Path
    after: Path
    undone: Path


@pytest.fixture(scope="module", params=ITEMS, ids=lambda name: name.replace(" ", "-"))
def ran(request, inkscape, documents, tmp_path_factory):
    item = ITEMS[request.param]
    document = documents / f"{item.document}.svg"
    folder = tmp_path_factory.mktemp("ran")
    ran = Ran(item, *(folder / f"{name}.svg" for name in ("before", "after", "undone")))
    set_values(inkscape, item.name, **item.values)
    actions = chosen(item.name, *selection(item.select, document)) + written(ran.after)
    actions = [*written(ran.before), *actions]
    if inkscape_harness.undoes_in_batch_runs():
        actions += ["undo", *written(ran.undone)]
    inkscape.run_actions(document, actions)
    return ran


def alike(before, after, within):
    """Whether two pictures are the same within this FLIP, or with 0 but for a level up or down:
    colours at new points have eight bits."""
    if within:
        return flip(before, after) <= within
    return (difference(before, after) > 1).mean() <= 0.001


def stated(svg):
    """The error in the label of the pear, against the mesh as it was at first."""
    return float(LABEL_TEXT.fullmatch(by_id(svg)["pear"].get(LABEL))[4])


def test_an_item_changes_the_mesh_but_not_the_picture(inkscape, documents, ran):
    was, found = info(ran.before)["pear"], info(ran.after)["pear"]
    if ran.item.name in ("simplify", "merge"):
        assert found["patches"] < was["patches"]
    elif ran.item.name in ("refine", "to_one_mesh"):
        assert found["patches"] > was["patches"]
    assert all_but_the_view(ran.after) != all_but_the_view(ran.before)
    first, before, after = export(inkscape, [documents / "whole.svg", ran.before, ran.after])
    assert alike(before, after, ran.item.within)
    if ran.item.name == "merge":
        assert flip(first, after) <= stated(ran.after)


@undoes_in_batch_runs
def test_one_undo_brings_everything_back(ran):
    assert all_but_the_view(ran.undone) == all_but_the_view(ran.before)


@pytest.mark.skipif(inkscape_harness.undoes_in_batch_runs(), reason="the test above needs no window")
@needs_window
@pytest.mark.parametrize("name", ITEMS, ids=lambda name: name.replace(" ", "-"))
def test_one_undo_in_the_window_brings_everything_back(inkscape, documents, tmp_path, name):
    item, document = ITEMS[name], tmp_path / "document.svg"
    document.write_bytes((documents / f"{ITEMS[name].document}.svg").read_bytes())
    set_values(inkscape, item.name, **item.values)
    before = document.read_bytes()
    undone, redone = inkscape.undone_in_window(document, chosen(item.name, *selection(item.select, document)))
    assert undone == before != redone


def others(svg):
    """The objects that have no mesh, with all that is in them, in their order."""
    layer = by_id(svg)["layer1"]
    return [ET.tostring(element) for element in layer if element.get("id") != "pear"]


def test_an_item_leaves_other_objects(ran):
    assert others(ran.after) == others(ran.before)
    order = [[element.get("id") for element in by_id(svg)["layer1"]] for svg in ran[1:3]]
    assert order[0] == order[1]


@pytest.mark.full(all_but=1)
def test_inkscape_opens_and_saves_it_again_without_change(inkscape, ran):
    (again,) = export(inkscape, [ran.after], kind="svg")
    assert info(again) == info(ran.after)
    assert all_but_the_view(again) == all_but_the_view(ran.after)


@undoes_in_batch_runs
def test_undone_it_is_saved_byte_for_byte_as_after_an_item_of_inkscapes_own(inkscape, tmp_path):
    """Any extension, undone, leaves the attributes of the root in another order."""
    set_values(inkscape, resolution=100)
    own, ours = tmp_path / "own.svg", tmp_path / "ours.svg"
    items = {
        own: ["select-by-id:stem", "org.inkscape.color.brighter.noprefs"],
        ours: chosen("simplify", "pear"),
    }
    for file, actions in items.items():
        changed = tmp_path / f"changed-{file.name}"
        actions = [*actions, *written(changed), "undo", *written(file)]
        inkscape.run_actions(SAMPLES / "fruit.svg", actions)
        assert changed.read_bytes() != file.read_bytes()
    assert ours.read_bytes() == own.read_bytes()


def test_analysis_comes_above_and_goes(inkscape, tmp_path):
    set_values(inkscape, "show_analysis", show="regions")
    files = [tmp_path / f"{name}.svg" for name in ("before", "shown", "removed")]
    before, shown, removed = files
    actions = [*written(before), *chosen("show_analysis", "pear"), *written(shown)]
    actions += [*chosen("remove_analysis"), *written(removed)]
    inkscape.run_actions(SAMPLES / "fruit.svg", actions)

    layer = list(ET.parse(shown).getroot())[-1]
    assert (layer.get("{urn:gradmesh}analysis"), layer.get(LABEL)) == ("regions", "Regions of pear")
    assert others(shown) == others(before) and info(shown)["pear"] == info(before)["pear"]
    assert all_but_the_view(removed) == all_but_the_view(before)

    pictures = export(inkscape, files)
    drawn = difference(*pictures[:2]) > 16
    assert 0.01 < drawn.mean() < 0.3
    assert not drawn[:60].any(), "drawn beside the pear"
    assert (difference(pictures[0], pictures[2]) == 0).all()


def test_hemesh_is_saved_and_opened(inkscape, tmp_path):
    saved, opened = tmp_path / "saved.hemesh", tmp_path / "opened.svg"
    inkscape.run_actions(SAMPLES / "fruit.svg", written(saved))
    inkscape.run_actions(saved, written(opened))

    ours, converted = tmp_path / "ours.hemesh", tmp_path / "converted.svg"
    run("convert", SAMPLES / "fruit.svg", ours)
    run("convert", ours, converted)
    assert saved.read_bytes() == ours.read_bytes()
    assert list(info(opened).values()) == list(info(converted).values())
    bare, ours = tmp_path / "bare.svg", tmp_path / "ours.png"
    document = svg_meshes.Document(opened)
    write_bare_mesh(document, document.by_id["mesh"], bare)
    run("render", opened, "--like-inkscape", "-o", ours)
    (painted,) = export(inkscape, [bare])
    assert flip(painted, ours) <= SAME
    (reopened,) = export(inkscape, [opened], kind="svg")
    assert info(reopened) == info(opened)


def test_inkex_compares_the_output(extension, tmp_path):
    """As inkex.tester has it, with the sample itself as what is expected."""
    before, after = tmp_path / "before.svg", SAMPLES / "fruit.svg"
    layer = '<g xmlns:m="urn:gradmesh" m:analysis="edges"><path d="M 0,0 9,9"/></g></svg>'
    before.write_text(after.read_text().replace("</svg>", layer))
    check = tmp_path / "check.py"
    check.write_text(
        "import unittest\n"
        "from inkex.tester import ComparisonMixin, TestCase\n"
        "from gradmesh_remove_analysis import RemoveAnalysis\n"
        "class Comparison(ComparisonMixin, TestCase):\n"
        "    effect_class = RemoveAnalysis\n"
        f"    compare_file = {str(before)!r}\n"
        "    comparisons = [()]\n"
        "    def get_compare_cmpfile(self, args, addout=None):\n"
        f"        return {str(after)!r}\n"
        "unittest.main()\n"
    )
    done = subprocess.run(
        [PYTHON, check],
        cwd=extension,
        env={**os.environ, "PYTHONPATH": f"{extension}{os.pathsep}{INKEX}"},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert "Ran 1 test" in done.stderr


@pytest.mark.parametrize(
    "sample, ids",
    [
        ("fruit", ["pear"]),
        ("face", ["face"]),
        ("stroke", ["loop"]),
        ("transformed", ["leaf"]),
        ("two", ["cap", "stalk"]),
    ],
)
@pytest.mark.full(all_but=1)
def test_the_mesh_is_smaller_and_looks_the_same(inkscape, tmp_path, sample, ids):
    before, after = SAMPLES / f"{sample}.svg", tmp_path / "after.svg"
    elements = simplified(inkscape, sample, after, ids, result="blocks")
    found, was = info(after), info(before)
    for name in ids:
        label = elements[name].get(LABEL)
        patches, all_patches, metric, error = LABEL_TEXT.fullmatch(label).groups()
        assert elements[name].tag == SVG + "g"
        assert int(patches) == found[name]["patches"] < was[name]["patches"] == int(all_patches)
        assert metric == "FLIP" and 0 < float(error) <= EPSILON
    pictures = [
        inkscape.export_png(svg, tmp_path / f"{when}.png", width=700)
        for when, svg in (("before", before), ("after", after))
    ]
    assert float(run("compare", *pictures).stdout) <= EPSILON + PAGE


@pytest.fixture(scope="module")
def untouched(inkscape, tmp_path_factory):
    """What Inkscape makes of the sample "two" without the extension."""
    plain = tmp_path_factory.mktemp("untouched") / "plain.svg"
    inkscape.run_actions(SAMPLES / "two.svg", written(plain))
    return plain


STALK = 36  # patches, so few that every method is quick
#: Of a method that the dialog has no longer, and its settings, as preferences may still hold them.
OLD_CHOICE = {"method": "manual", "edges": "100, 120", "kappa": 0.2, "seed": 2}
NO_ERROR = {"amount": "custom", "epsilon": 0, "resolution": 2000, "visible_only": "false"}


@pytest.mark.parametrize(
    "values, options",
    [
        ({"result": "blocks", "omega": 0.6}, {"method": "best", "count": "handles", "omega": 0.6}),
        ({"result": "gqe", "omega": 0.3}, {"method": "gqe", "omega": 0.3}),
        ({"result": "gqe", **OLD_CHOICE}, {"method": "gqe"}),
        ({"result": "gqe", "metric": "ssim"}, {"method": "gqe", "metric": "ssim"}),
        *(
            ({"result": "gqe", "amount": "custom", "epsilon": epsilon}, {"method": "gqe", "epsilon": epsilon})
            for epsilon in (0.03, 0.003)
        ),
        ({"result": "blocks", "amount": "patches", "patches": 20}, {"method": "best", "patches": 20}),
    ],
)
@pytest.mark.full(all_but=1)
def test_blocks_with_their_settings(inkscape, tmp_path, values, options):
    """The same comes out as from Python: so every value of the preferences has reached the core."""
    document = gradmesh.load(SAMPLES / "two.svg")
    bound = {} if "amount" in values else {"amount": "balanced"}
    (expected,) = gradmesh.simplify(document, "stalk", resolution=100, **bound, **options)
    elements = simplified(inkscape, "two", tmp_path / "after.svg", ["stalk"], resolution=100, **values)
    left, _, metric, error = LABEL_TEXT.fullmatch(elements["stalk"].get(LABEL)).groups()
    assert int(left) == expected.patches_after < STALK
    assert metric == ("1 - SSIM" if "metric" in values else "FLIP")
    assert error == f"{expected.error:.4f}" and 0 < float(error) <= options.get("epsilon", 0.05)
    assert info(tmp_path / "after.svg")["stalk"]["patches"] == int(left)


def test_a_fault_changes_nothing(inkscape, untouched, tmp_path):
    set_values(inkscape, resolution=100, result="magic")
    after = tmp_path / "after.svg"
    said = inkscape.said_by_extension(RAW_ID, SAMPLES / "two.svg", after, select=["stalk"])
    assert "'magic'" in said and said.count("\n") == 1 and said.endswith(".\n")
    assert all_but_the_view(after) == all_but_the_view(untouched)


@pytest.mark.parametrize(
    "values, words",
    [
        (NO_ERROR, "no handle can be taken out within an error of 0"),
        ({"preview": "true"}, "patches would be left, with an error of FLIP 0."),
    ],
)
@pytest.mark.full
def test_what_is_only_said_changes_nothing(inkscape, untouched, tmp_path, values, words):
    """It is said in a dialog only where Python has no GTK 3, and always in the log."""
    set_values(inkscape, **{"resolution": 100, **values})
    after = tmp_path / "after.svg"
    said = inkscape.said_by_extension(RAW_ID, SAMPLES / "two.svg", after, select=["stalk"])
    log = (inkscape.home / "cache" / "gradmesh" / "extension.log").read_text()
    assert words in log
    assert said in ("", log.splitlines()[-1] + "\n")
    assert all_but_the_view(after) == all_but_the_view(untouched)


@pytest.mark.full
def test_twice_is_once_more(inkscape, tmp_path):
    """What Inkscape saved is simplified again, and the label still counts from the first mesh."""
    once, twice = tmp_path / "once.svg", tmp_path / "twice.svg"
    values = {"result": "blocks", "resolution": 300}
    simplified(inkscape, "fruit", once, ["pear"], amount="gentle", **values)
    set_values(inkscape, amount="strong", **values)
    inkscape.run_extension(RAW_ID, once, twice, select=["pear"])
    left, all_patches, *_ = LABEL_TEXT.fullmatch(by_id(twice)["pear"].get(LABEL)).groups()
    assert int(left) == info(twice)["pear"]["patches"] < info(once)["pear"]["patches"]
    assert all_patches == "132"
