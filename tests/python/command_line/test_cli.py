"""The command line's contract: options, reports, exit codes, silence, and files whole or untouched."""

import gzip
import json
import os
import pty
import subprocess
import xml.etree.ElementTree as ET

import pytest

from bad_documents import BAD, DOCUMENT, FIRST, TWO_PATCHES, document, row
from built import PROGRAM, SAMPLES, gradmesh

OPTIONS = {
    "--id": "pear",
    "--method": "grid",
    "--metric": "ssim",
    "--epsilon": "0.02",
    "--resolution": "300",
    "--seed": "7",
    "--time-budget": "50",
    "--threads": "1",
}

QUICK = ("--method", "grid")


@pytest.fixture
def fruit(tmp_path):
    """A copy of a sample, in a folder that is empty otherwise."""
    path = tmp_path / "fruit.svg"
    path.write_bytes((SAMPLES / "fruit.svg").read_bytes())
    return path


def files(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def refused(done, code=1):
    """The sentence of a run that failed."""
    assert (done.returncode, done.stdout) == (code, "")
    assert done.stderr.startswith("gradmesh: ") and done.stderr.endswith(".\n")
    assert done.stderr.count("\n") == 1
    return done.stderr


def test_help_and_version():
    assert "simplify" in gradmesh("--help").stdout
    assert gradmesh("--version").stdout.count(".") == 2
    for command in ("info", "simplify", "render", "compare"):
        done = gradmesh(command, "--help")
        assert (done.returncode, done.stderr) == (0, "") and done.stdout


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["melt"],
        ["info"],
        ["simplify", "fruit.svg"],
        ["simplify", "fruit.svg", "-o", "out.svg", "--metric", "taste"],
        ["simplify", "fruit.svg", "-o", "out.svg", "--method", "magic"],
        ["simplify", "fruit.svg", "-o", "out.svg", "--epsilon", "1.5"],
        ["simplify", "fruit.svg", "-o", "out.svg", "--epsilon", "nan"],
        ["simplify", "fruit.svg", "-o", "out.svg", "--epsilon", "much"],
        ["simplify", "fruit.svg", "-o", "out.svg", "--resolution", "15"],
        ["simplify", "fruit.svg", "-o", "out.svg", "--seed", "-1"],
        ["simplify", "fruit.svg", "-o", "out.svg", "--time-budget", "-1"],
        ["simplify", "fruit.svg", "-o", "out.svg", "--time-budget", "inf"],
        ["simplify", "fruit.svg", "-o", "out.svg", "--threads", "-1"],
        ["simplify", "fruit.svg", "-o", "out.svg", "--handles", "9", "--patches", "3"],
        ["simplify", "fruit.svg", "-o", "out.svg", "--handles", "9", "--ratio", "0.5"],
        ["simplify", "fruit.svg", "-o", "out.svg", "--handles", "9", "--count", "patches"],
        ["simplify", "fruit.svg", "-o", "out.svg", "--patches", "9", "--count", "handles"],
        ["simplify", "fruit.svg", "-o", "out.svg", "--count", "corners"],
    ],
)
def test_wrong_usage_is_exit_code_2(fruit, arguments):
    done = gradmesh(*arguments, cwd=fruit.parent)
    assert done.returncode == 2
    assert done.stderr and not done.stdout
    assert set(files(fruit.parent)) == {"fruit.svg"}


def test_info():
    lines = gradmesh("info", SAMPLES / "two.svg").stdout.splitlines()
    assert [line.split()[0] for line in lines] == ["stalk", "cap"]
    found = json.loads(gradmesh("info", "--json", SAMPLES / "two.svg").stdout)
    assert found["file"] == str(SAMPLES / "two.svg")
    assert [mesh["patches"] for mesh in found["meshes"]] == [36, 280]
    assert lines[0].startswith("stalk (fill): 181 handles, 36 patches, 1 object, ")
    assert [(mesh["handles"], mesh["objects"]) for mesh in found["meshes"]][0] == (181, 1)
    assert {mesh["role"] for mesh in found["meshes"]} == {"fill"}
    assert not any(mesh["simplified"] for mesh in found["meshes"])


def test_simplify_and_its_report(fruit):
    out, report = fruit.with_name("out.svg"), fruit.with_name("report.json")
    before = fruit.read_bytes()
    options = [text for pair in OPTIONS.items() for text in pair]
    done = gradmesh("simplify", fruit, "-o", out, *options, "--report", report)
    assert (done.returncode, done.stderr) == (0, "")  # a pipe gets no progress bar
    assert done.stdout.startswith("pear: ")
    (mesh,) = json.loads(report.read_text())["meshes"]
    assert list(mesh) == (
        "id method color_model metric epsilon max_local_error original resolution seed omega "
        "kappa handles_before handles_after patches_before patches_after objects error local_error "
        "evaluations renderer seconds stopped".split()
    )
    assert (mesh["id"], mesh["method"], mesh["metric"]) == ("pear", "grid", "ssim")
    assert (mesh["epsilon"], mesh["resolution"], mesh["seed"]) == (0.02, 300, 7)
    assert mesh["patches_after"] < mesh["patches_before"] == 132
    assert 0 < mesh["error"] <= 0.02 and mesh["evaluations"] > 0
    assert mesh["max_local_error"] is None and mesh["local_error"] > mesh["error"]
    assert mesh["seconds"]["total"] > 0 and mesh["stopped"] == "done"
    (after,) = json.loads(gradmesh("info", "--json", out).stdout)["meshes"]
    assert after["patches"] == mesh["patches_after"] and after["simplified"]
    assert after["handles"] == mesh["handles_after"] and after["objects"] == mesh["objects"] > 1
    assert fruit.read_bytes() == before


def test_the_error_of_small_parts_can_be_bounded(fruit):
    report = fruit.with_name("report.json")

    def run(*options):
        options = ("--resolution", "200", "--report", report, *options)
        done = gradmesh("simplify", fruit, "-o", fruit.with_name("out.svg"), *options)
        assert done.returncode == 0, done.stderr
        return done.stdout, json.loads(report.read_text())["meshes"][0]

    said, free = run()
    assert "small parts" not in said
    bound = free["local_error"] / 2
    said, bounded = run("--max-local-error", str(bound))
    assert bounded["max_local_error"] == bound
    assert bounded["local_error"] <= bound and bounded["error"] <= 0.01
    assert free["patches_after"] < bounded["patches_after"] < 132
    assert f"in small parts up to {bounded['local_error']:.5f}" in said


def test_in_may_be_out(fruit):
    before = fruit.read_bytes()
    assert gradmesh("simplify", fruit, "-o", fruit, *QUICK).returncode == 0
    assert fruit.read_bytes() != before
    ET.parse(fruit)
    assert set(files(fruit.parent)) == {"fruit.svg"}


def test_only_the_named_meshes(tmp_path):
    def left(*options):
        out = tmp_path / "out.svg"
        done = gradmesh("simplify", SAMPLES / "two.svg", "-o", out, *QUICK, *options)
        assert done.returncode == 0
        found = json.loads(gradmesh("info", "--json", out).stdout)
        return [mesh["simplified"] for mesh in found["meshes"]]

    assert left("--id", "cap") == [False, True]
    assert left("--id", "cap", "--id", "stalk") == left("--id", "svg1") == left() == [True, True]


def test_nothing_to_merge_keeps_every_byte(tmp_path):
    face, out, report = SAMPLES / "face.svg", tmp_path / "out.svg", tmp_path / "report.json"
    done = gradmesh("simplify", face, "-o", out, "--epsilon", "0", *QUICK, "--report", report)
    assert done.returncode == 0 and "nothing to merge" in done.stdout
    assert out.read_bytes() == face.read_bytes()
    (mesh,) = json.loads(report.read_text())["meshes"]
    assert mesh["stopped"] == "nothing to merge"
    assert mesh["patches_after"] == mesh["patches_before"]


def test_what_happened_to_handles_is_told_of_handles(tmp_path):
    one, out = tmp_path / "one.svg", tmp_path / "out.svg"
    assert gradmesh("simplify", SAMPLES / "fruit.svg", "-o", one, "--handles", "4", "--forget-original").returncode == 0
    done = gradmesh("simplify", one, "-o", out, "--method", "plain")
    assert done.stdout.startswith("pear: 4 of 4 handles, 1 of 1 patches left, FLIP 0.00000, ")
    assert done.stdout.endswith(" s (no handle could be taken out)\n")
    options = ["--resolution", "4096", "--time-budget", "0.001"]
    done = gradmesh("simplify", SAMPLES / "fruit.svg", "-o", out, *options)
    assert done.stdout.startswith("pear: 660 of 660 handles, ")
    assert done.stdout.endswith(" s (no time left)\n")


@pytest.mark.parametrize(
    "options, left",
    [
        (["--handles", "120"], ("handles", 120)),
        (["--ratio", "0.5"], ("handles", 330)),
        (["--ratio", "0.5", "--count", "patches"], ("patches", 66)),
        (["--ratio", "0.5", "--method", "motorcycle"], ("patches", 66)),
        (["--ratio", "0.5", "--method", "motorcycle", "--count", "handles"], ("handles", 330)),
        (["--patches", "40"], ("patches", 40)),
    ],
)
def test_targets(fruit, options, left):
    report = fruit.with_name("report.json")
    done = gradmesh("simplify", fruit, "--preview", "--resolution", "200", "--report", report, *options)
    assert (done.returncode, done.stderr) == (0, "")
    (mesh,) = json.loads(report.read_text())["meshes"]
    what, most = left
    assert most / 2 <= mesh[f"{what}_after"] <= most < mesh[f"{what}_before"]
    assert (mesh["method"] == "plain") == (what == "handles" and "motorcycle" not in options)


def test_the_time_budget_ends_a_run(tmp_path):
    report = tmp_path / "report.json"
    arguments = ["simplify", SAMPLES / "photo.svg", "-o", tmp_path / "out.svg"]
    done = gradmesh(*arguments, "--resolution", "4096", "--time-budget", "0.001", "--report", report)
    assert done.returncode == 0
    (mesh,) = json.loads(report.read_text())["meshes"]
    assert mesh["stopped"] == "budget"
    ET.parse(tmp_path / "out.svg")


def test_quiet(fruit):
    done = gradmesh("simplify", fruit, "-o", fruit.with_name("out.svg"), "--quiet", *QUICK)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.parametrize("options, shown", [([], True), (["--quiet"], False)])
def test_a_terminal_gets_a_progress_bar(fruit, options, shown):
    terminal, inside = pty.openpty()
    process = subprocess.Popen(
        [PROGRAM, "simplify", fruit, "-o", fruit.with_name("out.svg"), *QUICK, *options],
        stdin=inside,
        stdout=subprocess.DEVNULL,
        stderr=inside,
    )
    os.close(inside)
    seen = b""
    with os.fdopen(terminal, "rb", buffering=0) as screen:
        while True:
            try:
                block = screen.read(4096)
            except OSError:  # Linux's way to say that nobody writes any more
                break
            if not block:
                break
            seen += block
    assert process.wait(timeout=60) == 0
    assert (b"%" in seen and b"patches" in seen) == shown
    assert seen.endswith(b"\r\x1b[K") if shown else seen == b""


@pytest.mark.parametrize("name", BAD)
def test_bad_documents(tmp_path, name):
    bad, path = BAD[name], tmp_path / "bad.svg"
    secret = tmp_path / "secret"
    secret.write_text("#abcdef")
    path.write_text(bad.text.replace("SECRET", secret.as_uri()))
    before = files(tmp_path)
    said = refused(gradmesh("simplify", path, "-o", tmp_path / "out.svg"))
    assert str(path) in said
    for word in bad.words:
        assert word in said
    listed = gradmesh("info", path)
    if listed.returncode == 0:  # the document can be read, but not its mesh
        assert listed.stdout == f"box (fill): cannot be read: {said.removeprefix('gradmesh: ')}"
    else:
        assert refused(listed) == said
    assert refused(gradmesh("simplify", path, "-o", path)) == said
    assert refused(gradmesh("render", path, "-o", tmp_path / "out.png")) == said
    assert files(tmp_path) == before


def test_external_entities_are_never_read(tmp_path):
    secret, path, out = (tmp_path / name for name in ("secret", "in.svg", "out.svg"))
    secret.write_text("open sesame")
    doctype = f'<!DOCTYPE svg [<!ENTITY e SYSTEM "{secret.as_uri()}">]>'
    text = (SAMPLES / "fruit.svg").read_text()
    path.write_text(doctype + "<svg" + text.partition("<svg")[2].replace("Pear<", "&e;<", 1))
    assert "&e;" in path.read_text()
    assert gradmesh("simplify", path, "-o", out, *QUICK).returncode == 0
    assert "open sesame" not in out.read_text()


def test_a_bomb_in_text_is_never_expanded(tmp_path):
    bomb = BAD["entity bomb"].text.partition("]>")[0] + "]>"
    path, out = tmp_path / "in.svg", tmp_path / "out.svg"
    path.write_text(bomb + TWO_PATCHES.replace("<defs>", "<title>&a9;</title><defs>"))
    gradmesh("simplify", path, "-o", out, "--epsilon", "0.5")
    assert not out.exists() or out.stat().st_size < 10000


@pytest.mark.parametrize(
    "ids, words", [(["gone"], '"gone"'), (["plain"], '"plain"'), (["box", "gone"], '"gone"')]
)
def test_wrong_ids(tmp_path, ids, words):
    path, out = tmp_path / "in.svg", tmp_path / "out.svg"
    path.write_text(TWO_PATCHES)
    said = refused(gradmesh("simplify", path, "-o", out, *(f"--id={name}" for name in ids)))
    assert str(path) in said and words in said
    assert not out.exists()


def test_files_that_cannot_be_read_or_written(fruit):
    gone = fruit.parent / "gone"
    before = files(fruit.parent)
    assert str(gone) in refused(gradmesh("info", gone))
    assert str(fruit.parent) in refused(gradmesh("info", fruit.parent))
    assert str(gone / "x") in refused(gradmesh("simplify", fruit, "-o", gone / "x", *QUICK))
    assert str(fruit.parent) in refused(
        gradmesh("simplify", fruit, "-o", fruit.parent, *QUICK)
    )
    assert str(gone / "x") in refused(gradmesh("render", fruit, "-o", gone / "x"))
    assert str(gone) in refused(gradmesh("compare", gone, gone))
    assert files(fruit.parent) == before


def test_files_of_any_name(tmp_path):
    folder = tmp_path.joinpath("Jörg Müller", *["ein Ordner mit langem Namen, один или 日本"] * 6)
    folder.mkdir(parents=True)
    fruit, fewer, picture = (folder / name for name in ("Früchte.svg", "wenig ö.svg", "ä.png"))
    assert len(str(fruit)) > 260
    fruit.write_bytes((SAMPLES / "fruit.svg").read_bytes())
    report, page = folder / "ü.json", folder / "ß.html"
    done = gradmesh("simplify", fruit, "-o", fewer, *QUICK, "--report", report, "--original", fruit)
    assert (done.returncode, done.stderr) == (0, "")
    assert json.loads(report.read_text(encoding="utf-8"))["meshes"][0]["original"] == str(fruit)
    assert gradmesh("report", fruit, fewer, "-o", page, "--resolution", 64, "--id", "pear").returncode == 0
    assert "Früchte.svg" in page.read_text(encoding="utf-8")
    assert gradmesh("render", fewer, "-o", picture, "--id", "pear").returncode == 0
    assert gradmesh("compare", picture, picture).stdout == "0.000000\n"
    assert len(files(folder)) == 5
    assert "/ä.svg cannot be read" in refused(gradmesh("info", folder / "ä.svg"))


def test_compressed_documents(tmp_path, fruit):
    plain, packed = tmp_path / "plain.svg", tmp_path / "packed.svgz"
    quick = ("--id", "pear", *QUICK)
    assert gradmesh("simplify", fruit, "-o", plain, *quick).returncode == 0
    assert gradmesh("simplify", fruit, "-o", packed, *quick).returncode == 0
    assert gzip.decompress(packed.read_bytes()) == plain.read_bytes()
    # No time and no name in the header: equal documents are equal files.
    assert packed.read_bytes()[3:10] == b"\0\0\0\0\0\x02\xff"

    # By its content, whatever its name; written as the name of OUT says.
    misnamed, again = tmp_path / "misnamed.svg", tmp_path / "again.svg"
    misnamed.write_bytes(gzip.compress(fruit.read_bytes(), mtime=7))
    assert gradmesh("info", misnamed).stdout == gradmesh("info", fruit).stdout
    assert gradmesh("simplify", misnamed, "-o", again, *quick).returncode == 0
    assert again.read_bytes() == plain.read_bytes()
    # What is not changed stays as it was, packed or not.
    one_patch = document(row(FIRST)).encode()
    misnamed.write_bytes(gzip.compress(one_patch, mtime=7))
    for out, expected in ((packed, misnamed.read_bytes()), (again, one_patch)):
        assert gradmesh("simplify", misnamed, "-o", out).returncode == 0
        assert out.read_bytes() == expected


@pytest.mark.parametrize("damage", [lambda b: b[:-9], lambda b: b[:99] + b"x" + b[100:], lambda b: b[:2]])
def test_damaged_compressed_documents(tmp_path, damage):
    path = tmp_path / "in.svgz"
    path.write_bytes(damage(gzip.compress((SAMPLES / "fruit.svg").read_bytes())))
    said = refused(gradmesh("info", path))
    assert str(path) in said and ("damaged" in said or "unpacks to" in said)


def test_the_limit_counts_what_is_unpacked(tmp_path, monkeypatch):
    path = tmp_path / "in.svgz"
    path.write_bytes(gzip.compress(b"<svg>" + b" " * 10_000_000 + b"</svg>"))
    monkeypatch.setenv("GRADMESH_LIMITS", "document=9M")
    said = refused(gradmesh("info", path))
    assert "unpacks to 10000011 bytes" in said and "GRADMESH_LIMITS=document=10000011" in said


def test_render(tmp_path):
    image = pytest.importorskip("PIL.Image")
    png = tmp_path / "out.png"
    assert gradmesh("render", SAMPLES / "fruit.svg", "-o", png, "--resolution", "200").returncode == 0
    with image.open(png) as picture:
        assert max(picture.size) == 200 and picture.mode == "RGB"
        assert len(picture.getcolors(1 << 24)) > 1000
    said = refused(gradmesh("render", SAMPLES / "two.svg", "-o", png))
    assert "--id" in said
    assert gradmesh("render", SAMPLES / "two.svg", "-o", png, "--id", "cap").returncode == 0


@pytest.mark.parametrize("metric, epsilon", [("flip", 0.01), ("ssim", 0.005)])
def test_compare(tmp_path, metric, epsilon):
    fruit, out, report = SAMPLES / "fruit.svg", tmp_path / "out.svg", tmp_path / "report.json"
    options = ["--metric", metric, "--epsilon", epsilon, "--report", report, "--whole-mesh"]
    gradmesh("simplify", fruit, "-o", out, *QUICK, *options)
    for svg in (fruit, out):
        gradmesh("render", svg, "-o", tmp_path / f"{svg.stem}.png")

    def error(a, b):
        return float(gradmesh("compare", a, b, "--metric", metric).stdout)

    assert error(fruit, fruit) == 0
    reported = json.loads(report.read_text())["meshes"][0]["error"]
    assert error(fruit, out) == pytest.approx(reported, abs=2e-4)
    assert error(tmp_path / "fruit.png", tmp_path / "out.png") == pytest.approx(reported, abs=2e-4)


def test_what_cannot_be_compared(tmp_path):
    for size in (100, 200):
        gradmesh("render", SAMPLES / "fruit.svg", "-o", tmp_path / f"{size}.png", "--resolution", size)
    assert "size" in refused(gradmesh("compare", tmp_path / "100.png", tmp_path / "200.png"))
    assert "must hold one" in refused(gradmesh("compare", SAMPLES / "two.svg", SAMPLES / "two.svg"))
    empty = tmp_path / "empty.svg"
    empty.write_text(DOCUMENT.format(defs=""))
    assert str(empty) in refused(gradmesh("compare", SAMPLES / "fruit.svg", empty))
