"""In Inkscape without a person nothing waits for one, and a script learns what became of each document."""

import json
import os
import shutil
import subprocess
import xml.etree.ElementTree as ET

import pytest

from bad_documents import BAD
from built import PYTHON, ROOT, SAMPLES, install_extension
from extension_runs import extension, run  # noqa: F401
from in_inkscape import needs
from inkscape_harness import Inkscape
from svg_meshes import Document

import gradmesh

ITEMS = sorted(file.stem.removeprefix("gradmesh_") for file in (ROOT / "inx").glob("*.inx"))
REAL = ROOT.parent / "shared" / "real"
SODIPODI = "{http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd}"

pytestmark = needs()


# Who is there.

ASK = [PYTHON, "-c", "from gradmesh_attended import is_attended; print(is_attended())"]


@pytest.mark.parametrize(
    "words, told, attended",
    [
        ([], {}, True),
        (["--batch-process"], {}, False),
        (["--batch-process", "in.svg"], {"GRADMESH_UNATTENDED": "0"}, True),
        (["--", "--batch-process"], {}, True),  # the name of a file
        (["--actions=x;y", "--export-filename=out.svg"], {}, True),
        ([], {"GRADMESH_UNATTENDED": "1"}, False),
        ([], {"GRADMESH_UNATTENDED": "perhaps"}, True),
    ],
)
def test_whoever_reads_what_is_written_tells_by_its_command_line(extension, words, told, attended):
    read = [PYTHON, "-c", "print(input())", *words]
    env = {**os.environ, "GRADMESH_UNATTENDED": "", **told}
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
    with subprocess.Popen(read, text=True, **pipes) as reader:
        subprocess.run(ASK, cwd=extension, env=env, stdout=reader.stdin, timeout=60)
        assert reader.communicate(timeout=60)[0] == f"{attended}\n"


def test_what_cannot_be_seen_is_a_person(extension, tmp_path):
    """Where a file is written there is no process that reads."""
    with open(tmp_path / "said", "w+") as said:
        subprocess.run(ASK, cwd=extension, stdout=said, timeout=60)
        said.seek(0)
        assert said.read() == "True\n"


@pytest.mark.parametrize("item", ITEMS)
@pytest.mark.full(all_but=1)
def test_no_item_says_anything_where_nobody_is(run, extension, tmp_path, item):
    """Not even where a module does not load that comes before all others."""
    report = tmp_path / "report"
    text = extension / "gradmesh_text.py"
    sound = text.read_text()
    text.write_text("raise RuntimeError('broken')")
    try:
        env = {"GRADMESH_UNATTENDED": "1", "GRADMESH_REPORT": str(report)}
        done = run(SAMPLES / "tensor.svg", item=item, **env)
    finally:
        text.write_text(sound)
    assert (done.stdout, done.stderr) == ("", "") and done.returncode != 0
    (line,) = lines(report)
    assert (line["outcome"], line["message"]) == ("fault", "RuntimeError: broken")
    assert line["document"] == "/home/somebody/apple.svg"
    assert line["action"] == f"org.gradmesh.{item}".replace("_", "-")
    assert "Traceback" in (tmp_path / "cache" / "gradmesh" / "extension.log").read_text()


def test_a_person_is_told_and_the_report_is_written_too(run, tmp_path):
    report = tmp_path / "report"
    done = run(SAMPLES / "fruit.svg", "--id=stem", GRADMESH_REPORT=str(report))
    (line,) = lines(report)
    assert done.stderr == line["message"] + "\n" and line["outcome"] == "refused"
    assert line["ids"] == ["stem"]


def test_a_report_that_cannot_be_written_stops_nothing(run, tmp_path):
    done = run(SAMPLES / "fruit.svg", "--id=pear", item="refine", GRADMESH_REPORT=str(tmp_path))
    assert (done.returncode, done.stderr) == (0, "") and "<svg" in done.stdout
    log = tmp_path / "cache" / "gradmesh" / "extension.log"
    assert "GRADMESH_REPORT" in log.read_text()


# In Inkscape.


def lines(report):
    """The lines that runs have added to their report."""
    return [json.loads(line) for line in report.read_text().splitlines()] if report.exists() else []


def content(svg):
    """The document, whatever file it was read from and window it was seen in."""
    view, name = SODIPODI + "namedview", SODIPODI + "docname"
    return ET.canonicalize(from_file=svg, exclude_tags=[view], exclude_attrs=[name])


def written(path):
    return [f"export-filename:{path}", "export-do"]


def chosen(action, *ids):
    """The actions that select these objects and run an item."""
    select = [f"select-by-id:{','.join(ids)}"] if ids else []
    return ["select-clear", *select, f"org.gradmesh.{action}.noprefs"]


def expect_left_alone(inkscape, svg, actions, folder):
    """Runs actions on a document, which they leave as it is."""
    plain, after = folder / "plain.svg", folder / "after.svg"
    inkscape.run_actions(svg, [*written(plain), *actions, *written(after)])
    assert content(after) == content(plain)


def set_simplify(inkscape, **values):
    inkscape.set_values({f"org.gradmesh.simplify.{name}": value for name, value in values.items()})


@pytest.fixture(scope="module")
def inkscape(extension):
    with Inkscape(timeout=100) as running:
        running.install(extension)
        yield running


@pytest.fixture
def report(tmp_path, monkeypatch):
    """The file to which every run in Inkscape adds what became of the document."""
    report = tmp_path / "report.jsonl"
    monkeypatch.setenv("GRADMESH_REPORT", str(report))
    return report


@pytest.fixture(scope="module")
def simple(tmp_path_factory):
    """The sample "fruit", its pear simplified."""
    svg = tmp_path_factory.mktemp("simple") / "fruit.svg"
    document = gradmesh.load(SAMPLES / "fruit.svg")
    gradmesh.simplify(document, "pear", method="grid", epsilon=0.03, resolution=200)
    gradmesh.save(document, svg)
    return svg


#: What each item says of the simplified fruit where there is nothing that it can do.
REFUSALS = [
    ("simplify", ["stem"], "refused", "None of the selected objects"),
    ("merge", [], "refused", "Select two or more blocks"),
    ("merge", ["pear"], "refused", "made of blocks"),
    ("merge", ["stem"], "refused", "no block of a simplified mesh"),
    ("refine", [], "refused", "Select one block"),
    ("refine", ["stem"], "refused", "no block of a simplified mesh"),
    ("update", ["stem"], "refused", "None of the selected objects"),
    ("update", ["pear"], "unchanged", "fit together"),
    ("to-one-mesh", [], "refused", "Select an object"),
    ("show-analysis", ["stem"], "refused", "None of the selected objects"),
    ("remove-analysis", [], "unchanged", "There is no analysis"),
]


def test_no_refusal_stops_the_run(inkscape, simple, report, tmp_path):
    actions = [action for item, ids, *_ in REFUSALS for action in chosen(item, *ids)]
    expect_left_alone(inkscape, simple, actions, tmp_path)
    found = lines(report)
    for line, (item, ids, outcome, words) in zip(found, REFUSALS):
        assert (line["action"], line["ids"]) == (f"org.gradmesh.{item}", ids)
        assert line["outcome"] == outcome and words in line["message"]
        assert line["document"] == str(simple)
    assert len(found) == len(REFUSALS)


@pytest.mark.full
def test_what_was_done_is_reported_too(inkscape, simple, report):
    # The mesh remembers what it was before it was simplified, so that more must be allowed now.
    set_simplify(inkscape, resolution=100, amount="custom", epsilon=0.06)
    items = ["show-analysis", "remove-analysis", "refine", "to-one-mesh", "simplify"]
    block = next(iter(Document(simple).blocks()))
    ids = ["pear", "pear", block, "pear", "pear"]
    inkscape.run_actions(simple, [action for pair in zip(items, ids) for action in chosen(*pair)])
    found = lines(report)
    assert [line["action"] for line in found] == [f"org.gradmesh.{item}" for item in items]
    assert {line["outcome"] for line in found} == {"done"}
    assert {line["message"] for line in found} == {""}
    (refined,), (whole,), (simplified,) = (line["meshes"] for line in found[2:])
    assert refined["patches_before"] < refined["patches_after"] == whole["patches_before"]
    assert whole["patches_after"] == simplified["patches_before"] > simplified["patches_after"]
    assert refined["handles_before"] < refined["handles_after"] == whole["handles_before"]
    assert whole["handles_after"] == simplified["handles_before"] and whole["objects"] == 1
    assert {mesh["id"] for mesh in (refined, whole, simplified)} == {"pear"}
    assert 0 < simplified["error"] <= 0.06


@pytest.mark.parametrize(
    "values, outcome, words",
    [
        ({"result": "magic"}, "refused", "'magic'"),
        ({"amount": "magic"}, "refused", "'magic'"),
        ({"preview": "true", "resolution": 100}, "unchanged", "of 36 patches would be left"),
        ({"result": "gqe", "epsilon": 0}, "unchanged", "nothing can be made simpler within an error"),
    ],
)
@pytest.mark.full(all_but=1)
def test_settings(inkscape, report, tmp_path, values, outcome, words):
    values = {"amount": "custom", "resolution": 2000, "visible_only": "false", **values}
    set_simplify(inkscape, **values)
    expect_left_alone(inkscape, SAMPLES / "two.svg", chosen("simplify", "stalk"), tmp_path)
    (line,) = lines(report)
    assert line["outcome"] == outcome and words in line["message"]


#: Of the documents that gradmesh refuses those that Inkscape opens. With missing stops it paints points
#: that were never set, if the window comes to be painted before the run ends, and 1.2.2 crashed once.
OPENED = ["no mesh", "dangling href", "huge", "zero size"]


@pytest.mark.full
def test_bad_documents_in_one_run(inkscape, report, tmp_path):
    inkscape.set_values({})
    files = [tmp_path / f"{name}.svg" for name in OPENED]
    for file in files:
        file.write_text(BAD[file.stem].text)
    done = inkscape.run_actions(files, chosen("simplify", "box"))
    assert done.returncode == 0
    found = lines(report)
    assert [line["document"] for line in found] == list(map(str, files))
    for line, name in zip(found, OPENED):
        assert line["outcome"] == "refused"
        assert all(word in line["message"] for word in BAD[name].words)


@pytest.mark.parametrize("suffix", [".svg", ".hemesh"])
@pytest.mark.full(all_but=1)
def test_hemesh_files(inkscape, report, tmp_path, suffix):
    """Refused, Inkscape 1.2.2 writes no file; of a document that it cannot save it ends at once."""
    inkscape.set_values({})
    if suffix == ".svg":
        inkscape.run_actions(SAMPLES / "two.svg", written(tmp_path / "out.hemesh"))
        action, words = "org.gradmesh.save", "holds one gradient mesh"
    else:
        (tmp_path / "bad.hemesh").write_text("HEMESH\nnot a mesh\n")
        inkscape.run_actions(tmp_path / "bad.hemesh", written(tmp_path / "out.svg"))
        action, words = "org.gradmesh.open", "is not a whole number"
    (line,) = lines(report)
    assert (line["action"], line["outcome"]) == (action, "refused") and words in line["message"]
    assert not list(tmp_path.glob("out.*"))


LOUD = "import os, warnings\nwarnings.warn('a warning')\nos.write(2, b'of a library')\n"
FAULTS = {
    "at the start": ("gradmesh_text.py", lambda text: "raise RuntimeError('broken')", "RuntimeError: broken"),
    "before the report": ("gradmesh_report.py", lambda text: "raise RuntimeError('broken')", None),
    "in a module beside": ("gradmesh_cache.py", lambda text: "import nothing", "No module named 'nothing'"),
    "in the package": ("gradmesh/api.py", lambda text: "import nothing", "install gradmesh again"),
    "in the run": ("gradmesh/api.py", lambda text: text.replace("to_bytes(", "to_nothing("), "AttributeError"),
    "abort": ("gradmesh/api.py", lambda text: text.replace("edges = list(", "edges = os.abort() or list("), None),
}


def log_of_a_run_with(file, change, item, folder):
    """The log of an item's run whose installed file was changed."""
    with Inkscape() as inkscape:
        inkscape.install(install_extension(folder / "installed"))
        path = inkscape.extensions / "gradmesh" / file
        path.write_text(change(path.read_text()))
        if item == "refine":
            inkscape.run_actions(SAMPLES / "tensor.svg", chosen(item, "silk"))
        else:
            expect_left_alone(inkscape, SAMPLES / "tensor.svg", chosen(item, "silk"), folder)
        return (inkscape.home / "cache" / "gradmesh" / "extension.log").read_text()


@pytest.mark.parametrize("fault", FAULTS)
@pytest.mark.full(all_but=1)
def test_faults(report, tmp_path, fault):
    """Where the report cannot be written either, the log says that there was a run."""
    file, broken, words = FAULTS[fault]
    log = log_of_a_run_with(file, broken, "simplify", tmp_path)
    found = lines(report)
    if words:
        (line,) = found
        assert line["outcome"] == "fault" and words in line["message"]
        assert words in log or line["message"] in log
    else:
        assert found == [] and "gradmesh_simplify.py" in log


def test_warnings_and_libraries_are_heard_by_nobody(report, tmp_path):
    log = log_of_a_run_with("gradmesh_text.py", lambda text: LOUD + text, "refine", tmp_path)
    (line,) = lines(report)
    assert line["outcome"] == "done"
    assert "a warning" in log and "of a library" in log


@pytest.mark.skipif(not REAL.is_dir(), reason=f"there is no {REAL}")
@pytest.mark.full
def test_documents_of_others_do_not_hold_up_the_run(inkscape, report, tmp_path):
    set_simplify(inkscape, resolution=200)
    files = [REAL / "elementary-wallpaper-64.svg", REAL / "nordzy-carla.svg", SAMPLES / "tensor.svg"]
    copies = [tmp_path / file.name for file in files]
    for file, copy in zip(files, copies):
        shutil.copyfile(file, copy)
    export = ["export-overwrite", "export-do"]
    inkscape.run_actions(copies, export)
    plain = list(map(content, copies))
    inkscape.run_actions(copies, [*chosen("simplify"), *export])
    found = lines(report)
    assert [line["document"] for line in found] == list(map(str, copies))
    for line, copy, before in zip(found, copies, plain):
        assert line["outcome"] in ("done", "unchanged")
        assert (content(copy) != before) == (line["outcome"] == "done")
    assert found[-1]["outcome"] == "done"


def test_a_mesh_that_cannot_be_read_beside_one_that_can(inkscape, report, tmp_path):
    inkscape.set_values({})
    before, after = tmp_path / "before.svg", tmp_path / "after.svg"
    bad = ET.fromstring(BAD["missing stops"].text)
    root = ET.parse(SAMPLES / "two.svg").getroot()
    root.extend([bad[0], bad[1]])
    ET.ElementTree(root).write(before)
    done = inkscape.run_actions(before, [*chosen("simplify", "stalk", "box"), *written(after)])
    assert done.returncode == 0
    (line,) = lines(report)
    assert line["outcome"] == "done"
    assert all(word in line["message"] for word in BAD["missing stops"].words)
    good, left = line["meshes"]
    assert good["id"] == "stalk" and good["patches_after"] < good["patches_before"]
    assert left == {"id": "box", "refused": left["refused"]}
    assert line["message"] == f"Left as it was: {left['refused']}".replace(str(before), before.name)
    assert Document(after).by_id["box"].get("fill") == "url(#m)"
