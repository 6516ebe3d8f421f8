"""Simplify does what it says when run as Inkscape runs it."""

import json
import os
import re
import subprocess
import xml.etree.ElementTree as ET

import pytest

from bad_documents import BAD, TWO_PATCHES
from built import PYTHON, ROOT, SAMPLES
from extension_runs import INKEX, SMALL, SVG, by_id, extension, refused, run  # noqa: F401

import gradmesh

LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"

pytestmark = pytest.mark.skipif(not INKEX.is_dir(), reason="Inkscape is not installed")


def test_the_object_becomes_a_labelled_group_and_nothing_is_said(run):
    done = run(SAMPLES / "fruit.svg", "--id=pear", "--result=blocks", SMALL)
    assert (done.returncode, done.stderr) == (0, "")
    pear = by_id(done.stdout)["pear"]
    assert pear.tag == SVG + "g"
    assert pear.get(LABEL).startswith("Gradient mesh: ")
    assert re.fullmatch(
        r"Gradient mesh: \d+ of 660 handles, \d+ of 132 patches, FLIP 0\.0\d+", pear.get(LABEL)
    )


@pytest.mark.parametrize("options", [[], ["--result=simplest"], ["--result=one-mesh"]])
@pytest.mark.full(all_but=1)
def test_but_for_blocks_it_stays_what_it_is_and_nothing_is_said(run, options):
    before = SAMPLES / "fruit.svg"
    done = run(before, "--id=pear", SMALL, *options)
    assert (done.returncode, done.stderr) == (0, "")
    (was,), (now,) = (gradmesh.info(gradmesh.loads(text))["meshes"] for text in (before.read_text(), done.stdout))
    assert now["patches"] <= was["patches"] and not now["simplified"]
    old, new = by_id(before.read_text())["pear"], by_id(done.stdout)["pear"]
    assert new.tag == old.tag and new.get(LABEL) == old.get(LABEL) and new.get("d") == old.get("d")
    assert not [element for element in by_id(done.stdout) if element and "block" in element]


@pytest.mark.parametrize(
    "result, options",
    [
        ("simplest", {}),
        ("one-mesh", {"method": "plain"}),
        ("lines", {"method": "lines"}),
        ("blocks", {"method": "best", "count": "handles"}),
        ("gqe", {"method": "gqe"}),
    ],
)
@pytest.mark.full(all_but=1)
def test_each_result_is_that_of_a_method(run, result, options):
    """With the values of the dialog, which all reach the core."""
    options = {"omega": 0.3, "metric": "ssim", "resolution": 100, "visible_only": False, **options}
    expected = gradmesh.load(SAMPLES / "fruit.svg")
    gradmesh.simplify(expected, "pear", amount="strong", **options)
    chosen = ["--omega=0.3", "--metric=ssim", "--resolution=100", "--visible_only=false", "--amount=strong"]
    done = run(SAMPLES / "fruit.svg", "--id=pear", f"--result={result}", *chosen)
    assert gradmesh.loads(done.stdout).meshes == expected.meshes
    pear, wanted = (by_id(text)["pear"] for text in (done.stdout, expected.to_bytes()))
    assert (pear.tag, pear.get(LABEL)) == (wanted.tag, wanted.get(LABEL))


def test_nothing_is_said_with_all_warnings_on(run):
    """Inkscape shows a ResourceWarning in a dialog."""
    done = run(SAMPLES / "fruit.svg", "--id=pear", SMALL, python=(PYTHON, "-W", "default", "-X", "dev"))
    own = [line for line in done.stderr.splitlines() if "inkex" not in line]
    assert [line for line in own if "gradmesh" in line] == []
    assert "ResourceWarning" not in done.stderr
    assert done.returncode == 0


def test_other_objects_are_not_touched(run):
    before = (SAMPLES / "two.svg").read_text()
    after = by_id(run(before, "--id=cap", SMALL).stdout)
    for name, element in by_id(before).items():
        if name and name != "cap" and not name.startswith("cap-mesh") and not len(element):
            assert after[name].attrib == element.attrib


@pytest.mark.parametrize("chosen", [["svg1"], ["cap", "stalk"], ["stalk", "title1", "cap"]])
@pytest.mark.full
def test_groups_and_mixed_selections(run, chosen):
    done = run(SAMPLES / "two.svg", *(f"--id={name}" for name in chosen), "--result=blocks", SMALL)
    after = by_id(done.stdout)
    assert after["cap"].tag == after["stalk"].tag == SVG + "g"


def test_a_broken_mesh_elsewhere_does_not_matter(run):
    broken = (
        '<meshgradient id="broken" type="bicubic"/><rect id="other" width="9" height="9" '
        'fill="url(#broken)"/></svg>'
    )
    text = (SAMPLES / "fruit.svg").read_text().replace("</svg>", broken)
    assert 'meshgradient "broken"' in refused(run(text, "--id=other"))
    assert by_id(run(text, "--id=pear", "--result=blocks", SMALL).stdout)["pear"].tag == SVG + "g"


BOUNDS = ("epsilon", "max_local_error", "max_detail_error")


@pytest.mark.parametrize("metric, share", [("flip", 1), ("ssim", 0.5)])
@pytest.mark.parametrize(
    "amount, epsilon, bound, detail",
    [("gentle", 0.005, 0.05, 0.06), ("balanced", 0.01, 0.1, 0.11), ("strong", 0.02, 0.1, 0.3)],
)
@pytest.mark.full(all_but=1)
def test_an_amount_is_a_bound_of_the_core(amount, epsilon, bound, detail, metric, share):
    document = gradmesh.load(SAMPLES / "tensor.svg")
    options = {"metric": metric, "resolution": 16, "preview": True}
    (named,) = gradmesh.simplify(document, amount=amount, **options)
    bounds = dict(zip(BOUNDS, (share * value for value in (epsilon, bound, detail))))
    assert {name: named.run[name] for name in bounds} == bounds
    (told,) = gradmesh.simplify(document, **bounds, **options)
    assert (told.error, told.handles_after) == (named.error, named.handles_after)
    page = (ROOT / "docs" / "simplify.md").read_text()
    (row,) = re.findall(rf"\| {amount.capitalize()} \|((?: [\d.]+ \|){{5}} [\d.]+ )\|", page)
    errors = row.split("|")
    assert errors[metric == "ssim" :: 2] == [f" {value:g} " for value in bounds.values()]


@pytest.mark.full
def test_how_much_by_name_or_number(run):
    def left(*options):
        options = ("--result=gqe", SMALL, *options)
        done = run(SAMPLES / "fruit.svg", "--id=pear", *options)
        label = by_id(done.stdout)["pear"].get(LABEL)
        patches, error = re.fullmatch(r".+ handles, (\d+) of 132 .+ (0\.\d+)", label).groups()
        return int(patches), float(error)

    amounts = [left(f"--amount={name}") for name in ("gentle", "balanced", "strong")]
    assert amounts[0][0] > amounts[1][0] > amounts[2][0]
    for (_, error), epsilon in zip(amounts, (0.005, 0.01, 0.02)):
        assert error <= epsilon
    assert left() == amounts[1]
    assert left("--amount=patches", "--patches=40")[0] <= 40
    assert left("--amount=patch-share", "--share=50")[0] <= 66
    assert left("--amount=strong", "--metric=ssim")[1] <= 0.01


@pytest.mark.parametrize("result", ["simplest", "one-mesh", "blocks"])
@pytest.mark.parametrize(
    "amount, most", [(["handles", "--handles=330"], 330), (["share", "--share=50"], 330)]
)
@pytest.mark.full(all_but=1)
def test_how_many_handles(run, result, amount, most):
    options = [f"--amount={amount[0]}", amount[1], f"--result={result}", SMALL]
    done = run(SAMPLES / "fruit.svg", "--id=pear", *options)
    assert done.stderr == ""
    (mesh,) = gradmesh.loads(done.stdout).meshes
    assert mesh.handles <= most and mesh.simplified == (result == "blocks")


@pytest.mark.full
def test_small_parts_have_a_limit_of_their_own(run):
    def left(*options):
        done = run(SAMPLES / "two.svg", "--id=stalk", "--result=blocks", "--resolution=400", *options)
        meshes = {mesh.id: mesh for mesh in gradmesh.loads(done.stdout).meshes}
        return meshes["stalk"].handles

    free = left("--amount=custom", "--epsilon=0.02")
    assert left("--amount=custom", "--epsilon=0.02", "--max_local_error=0.15") > free
    # The named amounts bring theirs, whatever is set for the others.
    assert left("--amount=strong") > free
    assert left("--amount=strong") == left("--amount=strong", "--max_local_error=0.01")


def test_nothing_selected_is_all(run):
    after = by_id(run(SAMPLES / "two.svg", "--result=blocks", "--resolution=100").stdout)
    assert after["cap"].tag == after["stalk"].tag == SVG + "g"
    assert "no gradient mesh" in refused(run(BAD["no mesh"].text))


def test_one_mesh_gradient(run):
    done = run(SAMPLES / "fruit.svg", "--id=pear", "--result=one-mesh", "--amount=strong", SMALL)
    assert done.stderr == ""
    pear = by_id(done.stdout)["pear"]
    assert pear.tag == SVG + "path"
    (gradient,) = [e for e in ET.fromstring(done.stdout).iter(SVG + "meshgradient")]
    assert f"url(#{gradient.get('id')})" in pear.get("style")
    assert len(list(gradient.iter(SVG + "meshpatch"))) < 132
    sides = [stop.get("path")[0] for stop in gradient.iter(SVG + "stop")]
    assert set(sides) <= set("lc") and sides.count("l") > 0


@pytest.mark.full
def test_the_original_can_be_kept_or_forgotten(run):
    pear = [SAMPLES / "fruit.svg", "--id=pear", SMALL]
    blocks = run(*pear, "--result=blocks").stdout
    forgetful = run(*pear, "--result=blocks", "--remember_original=false").stdout
    assert len(forgetful) < len(blocks)
    for result in ("simplest", "blocks"):
        after = by_id(run(*pear, "--keep_original=true", f"--result={result}").stdout)
        kept = after["pear-original"]
        assert kept.tag == SVG + "path" and "display:none" in kept.get("style")


@pytest.mark.full
def test_a_preview_only_tells(run):
    def told(document, *options):
        done = run(document, "--preview=true", "--resolution=100", "--amount=custom", *options)
        assert (done.returncode, done.stdout) == (0, "")
        return done.stderr

    error = r"an error of FLIP 0\.\d{4}\."
    would = rf"(\w+): \d+ of \d+ handles and \d+ of \d+ patches would be left, with {error}"
    stalk = told(SAMPLES / "two.svg", "--id=stalk", "--result=blocks")
    assert re.fullmatch(would + r" They would be \d objects\.\n", stalk)
    assert re.fullmatch(rf"({would}\n){{2}}", told(SAMPLES / "two.svg", "--id=stalk", "--id=cap"))
    # What was simplified before may be above a smaller error, and stays as it is.
    simpler = run(SAMPLES / "two.svg", "--id=stalk", "--amount=strong", "--resolution=100").stdout
    cap, stalk = sorted(told(simpler, "--epsilon=0.005", "--max_local_error=0.01").splitlines())
    above = r" That is above the largest error, 0\.005\. In a small part it is 0\.\d{4}, above 0\.01\."
    assert re.fullmatch(would, cap)[1] == "cap" and re.fullmatch(would + above, stalk)[1] == "stalk"


@pytest.mark.parametrize(
    "options, words",
    [
        (["--id=gone"], '"gone"'),
        (["--id=stem"], "None of the selected objects"),
        (["--id=pear", "--metric=taste"], "'taste'"),
        (["--id=pear", "--result=magic"], "'magic'"),
        (["--id=pear", "--amount=magic"], "'magic'"),
        # What is in the dialog no more.
        (["--id=pear", "--method=manual"], "--method"),
        (["--id=pear", "--omega=1.5"], "omega"),
        (["--id=pear", "--omega=nan"], "omega"),
        (["--id=pear", "--epsilon=nan"], "epsilon"),
        (["--id=pear", "--epsilon=much"], "'much'"),
        (["--id=pear", "--max_local_error=-1"], "local error"),
        (["--id=pear", "--resolution=3"], "resolution"),
        (["--id=pear", "--time_budget=-1"], "time budget"),
        (["--id=pear", "--colour=red"], "--colour"),
        # At 700 pixels there are merges that change none of them.
        (
            ["--id=pear", "--epsilon=0", "--resolution=2000", "--visible_only=false"],
            "pear: no handle can be taken out within an error of 0",
        ),
        (
            ["--id=pear", "--epsilon=0", "--resolution=2000", "--visible_only=false", "--result=blocks"],
            "pear: nothing can be made simpler within an error of 0",
        ),
    ],
)
@pytest.mark.full(all_but=1)
def test_what_cannot_be_done_is_said_in_one_sentence(run, options, words):
    assert words in refused(run(SAMPLES / "fruit.svg", "--amount=custom", *options))


@pytest.mark.parametrize("name", sorted(set(BAD) - {"no mesh"}))
@pytest.mark.full(all_but=1)
def test_bad_documents(run, name):
    bad = BAD[name]
    said = refused(run(bad.text, "--id=box"))
    assert said.startswith("apple.svg")
    for word in bad.words:
        assert word in said


def test_a_document_without_a_mesh(run):
    assert "None of the selected objects" in refused(run(BAD["no mesh"].text, "--id=box"))


def test_a_document_that_was_never_saved_has_a_name(run):
    assert refused(run(BAD["NaN"].text, "--id=box", path="")).startswith("the document: ")


def test_the_document_may_come_through_a_pipe(extension):
    done = subprocess.run(
        [PYTHON, "gradmesh_simplify.py", "--id=pear", "--result=blocks", SMALL],
        cwd=extension,
        env={**os.environ, "PYTHONPATH": str(INKEX)},
        input=(SAMPLES / "fruit.svg").read_bytes(),
        capture_output=True,
    )
    assert (done.returncode, done.stderr) == (0, b"")
    assert b"Gradient mesh: " in done.stdout


def test_the_program_works_where_the_module_is_missing(run, extension):
    (module,) = (extension / "gradmesh").glob("_core*.so")
    # The program, whose window the extension shows, would do the work instead.
    program = extension / "bin"
    aside, program_aside = module.rename(extension / "aside"), program.rename(extension / "bin aside")
    try:
        blocks = ("--id=box", "--result=blocks")
        said = refused(run(TWO_PATCHES, *blocks, GRADMESH_CORE="", GRADMESH_HELPER=""))
        program_aside.rename(program)
        helped = run(TWO_PATCHES, *blocks, GRADMESH_CORE="", GRADMESH_HELPER="")
    finally:
        aside.rename(module)
        if program_aside.exists():
            program_aside.rename(program)
    assert "bin/linux-" in said and "install gradmesh again" in said
    assert (helped.returncode, helped.stderr) == (0, "")
    assert "Gradient mesh: " in helped.stdout


def test_a_helper_that_fails_ends_in_one_sentence(run, tmp_path):
    broken = tmp_path / "broken"
    broken.write_text("#!/bin/sh\nexit 3\n")
    broken.chmod(0o755)
    said = refused(run(TWO_PATCHES, "--id=box", GRADMESH_CORE="helper", GRADMESH_HELPER=str(broken)))
    assert said == "Nothing was done because gradmesh's helper program ended before its work was done.\n"
    said = refused(
        run(
            TWO_PATCHES,
            "--id=box",
            LANGUAGE="de",
            LC_ALL="C.UTF-8",
            GRADMESH_CORE="helper",
            GRADMESH_HELPER=str(broken),
        )
    )
    assert said.startswith("Es wurde nichts getan, weil das Hilfsprogramm von gradmesh")


def test_a_fault_goes_to_the_log(run, extension, tmp_path):
    api = extension / "gradmesh" / "api.py"
    sound = api.read_text()
    api.write_text(sound.replace("def to_bytes(", "def to_nothing("))
    try:
        said = refused(run(SAMPLES / "fruit.svg", "--id=pear"))
    finally:
        api.write_text(sound)
    log = tmp_path / "cache" / "gradmesh" / "extension.log"
    assert "AttributeError" in said and str(log) in said
    assert "Traceback" in log.read_text()


def test_a_killed_run_writes_nothing(extension, tmp_path):
    """Inkscape takes what an extension wrote; half a document would be the person's loss."""
    running = subprocess.Popen(
        [PYTHON, "gradmesh_simplify.py", "--id=photo", "--resolution=4000", SAMPLES / "photo.svg"],
        cwd=extension,
        env={
            **os.environ,
            "PYTHONPATH": str(INKEX),
            "XDG_CACHE_HOME": str(tmp_path / "cache"),
            "DISPLAY": "",
        },
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    with pytest.raises(subprocess.TimeoutExpired):
        running.communicate(timeout=3)  # long before it ends
    running.kill()
    assert running.communicate() == (b"", b"")


def test_long_work_is_stopped_and_says_what_became_of_it(extension):
    """Without a display, as in a batch run; the window only calls stop()."""
    check = (
        "from gradmesh import Progress\n"
        "from gradmesh_window import LongWork\n"
        "def work(tell):\n"
        "    seen.append(tell(Progress(1, 4, 30, 0.001, 0)))\n"
        "    long.stop()\n"
        "    seen.append(tell(Progress(2, 4, 20, 0.002, 0)))\n"
        "    return 'the best so far'\n"
        "seen = []\n"
        "long = LongWork(['Something'], work)\n"
        "assert long.run() == 'the best so far' and seen == [True, False], seen\n"
        "assert long.share == 0.5 and 'Stopping' in long.words\n"
        "def fail(tell):\n"
        "    raise ValueError('no mesh')\n"
        "try:\n"
        "    LongWork(['Something'], fail).run()\n"
        "except ValueError as error:\n"
        "    assert str(error) == 'no mesh'\n"
        "else:\n"
        "    raise AssertionError\n"
    )
    env = {**os.environ, "DISPLAY": "", "LANGUAGE": "en"}
    done = subprocess.run([PYTHON, "-c", check], cwd=extension, env=env, capture_output=True)
    assert (done.returncode, done.stderr) == (0, b"")


def test_without_gtk_the_log_says_so_once_and_the_time_limit_holds(run, extension, tmp_path):
    (tmp_path / "gi.py").write_text("raise ImportError('there is no gi')")
    report, log = tmp_path / "report", tmp_path / "cache" / "gradmesh" / "extension.log"
    path = os.pathsep.join(map(str, (tmp_path, extension.parent, INKEX)))
    for _ in range(2):
        done = run(
            SAMPLES / "photo.svg",
            "--resolution=4000",
            "--time_budget=2",
            PYTHONPATH=path,
            GRADMESH_REPORT=str(report),
        )
        assert done.stderr == "" or "in 2 seconds" in refused(done)
    ((first,), (second,)) = (json.loads(line)["meshes"] for line in report.read_text().splitlines())
    assert first["stopped"] == second["stopped"] == "budget"
    said = log.read_text()
    assert said.count("gir1.2-gtk-3.0") == said.count("there is no gi") == 1
