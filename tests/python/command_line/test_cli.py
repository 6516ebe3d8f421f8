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
from program import error, listed, meshes, printed, refused, simplified

OPTIONS = (
    "--id pear --method grid --metric ssim --epsilon 0.02 --resolution 300 --seed 7 --time-budget 50 --threads 1"
)
FRUIT = SAMPLES / "fruit.svg"
QUICK = ("--method", "grid")


@pytest.fixture
def fruit(tmp_path):
    """A copy of a sample, in a folder that is empty otherwise."""
    path = tmp_path / "fruit.svg"
    path.write_bytes(FRUIT.read_bytes())
    return path


def files(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_help_and_version():
    assert "simplify" in gradmesh("--help").stdout
    assert gradmesh("--version").stdout.count(".") == 2
    for command in ("info", "simplify", "render", "compare"):
        done = gradmesh(command, "--help")
        assert (done.returncode, done.stderr) == (0, "") and done.stdout


#: By the beginning of a command line: what is wrong after it.
WRONG = {
    "": ["", "melt", "info", "simplify fruit.svg"],
    "simplify fruit.svg -o out.svg": [
        "--metric taste", "--method magic", "--epsilon 1.5", "--epsilon nan", "--epsilon much",
        "--resolution 15", "--seed -1", "--time-budget -1", "--time-budget inf", "--threads -1",
        "--renderer vulkan", "--handles 9 --patches 3", "--handles 9 --ratio 0.5",
        "--handles 9 --count patches", "--patches 9 --count handles", "--count corners",
    ],
    "publish fruit.svg -o out.svg": [
        "--scale=0", "--scale=-1", "--scale=17", "--scale=nan", "--scale=inf", "--scale=large",
    ],
    "draw fruit.svg -o out.svg": [
        "", "--show everything", "--show edges --patch 1", "--show errors --region all",
        "--show regions --region 0", "--show regions --region 1.5",
    ],
    "merge fruit.svg -o out.svg": [
        "--rows 2-", "--rows one", "--rows 3-2", "--rows 2 --patches 3,4", "--patches", "--preview out.png",
    ],
    "refine fruit.svg -o out.svg": [
        "--place 0", "--place 1", "--place nan", "--direction up", "--row 1 --patches 3", "--row one",
    ],
    "color fruit.svg -o out.svg": [
        "", "--points 1", "--color red", "--points 1 --color taste", "--points 1 --color red --join",
        "--points 1 --join --patches 3", "--points one --join",
    ],
    "merge fruit.svg": ["", "--patches 0,1"],
    "convert fruit.svg": [
        "out.hemesh --subdivide 0", "out.hemesh --subdivide 33", "out.hemesh --epsilon 0.1 --subdivide 2", "out.png",
    ],
}  # fmt: skip


@pytest.mark.parametrize("arguments", [f"{command} {end}" for command, ends in WRONG.items() for end in ends])
@pytest.mark.full(all_but=1)
def test_wrong_usage_is_exit_code_2(fruit, arguments):
    done = gradmesh(*arguments.split(), cwd=fruit.parent)
    assert done.returncode == 2
    assert done.stderr and not done.stdout
    assert "--scale" not in arguments or "scale" in done.stderr
    assert set(files(fruit.parent)) == {"fruit.svg"}


@pytest.mark.parametrize(
    "arguments", ["melt", "melt --help", "--help melt", "melt fruit.svg --help", "Simplify --help", "melt --version"]
)
def test_an_unknown_command_is_an_error_even_where_help_is_asked_for(arguments):
    done = gradmesh(*arguments.split())
    name = "Simplify" if "Simplify" in arguments else "melt"
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == f'gradmesh: there is no command "{name}"; gradmesh --help lists them.\n'


def test_info():
    lines = printed("info", SAMPLES / "two.svg").splitlines()
    assert [line.split()[0] for line in lines] == ["stalk", "cap"]
    assert lines[0].startswith("stalk (fill): 181 handles, 36 patches, 1 object, ")
    found = listed(SAMPLES / "two.svg")
    assert found["file"] == str(SAMPLES / "two.svg")
    stalk, cap = found["meshes"]
    assert (stalk["handles"], stalk["objects"], stalk["patches"], cap["patches"]) == (181, 1, 36, 280)
    assert {(mesh["role"], mesh["simplified"]) for mesh in (stalk, cap)} == {("fill", False)}


def test_simplify_and_its_report(fruit):
    out = fruit.with_name("out.svg")
    before = fruit.read_bytes()
    (mesh,) = simplified(fruit, out, *OPTIONS.split())  # a pipe gets no progress bar
    assert list(mesh) == (
        "id method color_model metric epsilon max_local_error max_detail_error original resolution seed omega "
        "kappa handles_before handles_after patches_before patches_after objects protected_patches error "
        "error_before local_error detail_error evaluations renderer seconds stopped".split()
    )
    assert (mesh["id"], mesh["method"], mesh["metric"]) == ("pear", "grid", "ssim")
    assert (mesh["epsilon"], mesh["resolution"], mesh["seed"]) == (0.02, 300, 7)
    assert mesh["patches_after"] < mesh["patches_before"] == 132
    assert 0 < mesh["error"] <= 0.02 and mesh["evaluations"] > 0
    assert mesh["max_local_error"] is None and mesh["local_error"] > mesh["error"]
    assert mesh["max_detail_error"] is None and mesh["protected_patches"] == 0
    assert mesh["seconds"]["total"] > 0 and mesh["stopped"] == "done"
    (after,) = meshes(out)
    assert after["patches"] == mesh["patches_after"] and after["simplified"]
    assert after["handles"] == mesh["handles_after"] and after["objects"] == mesh["objects"] > 1
    assert fruit.read_bytes() == before


def test_the_error_of_small_parts_can_be_bounded(fruit):
    out, report = fruit.with_name("out.svg"), fruit.with_name("report.json")

    def run(*options):
        said = printed("simplify", fruit, "-o", out, "--resolution", 200, "--report", report, *options)
        return said, json.loads(report.read_text())["meshes"][0]

    said, free = run()
    assert "small parts" not in said
    bound = free["local_error"] / 2
    said, bounded = run("--max-local-error", str(bound))
    assert bounded["max_local_error"] == bound
    assert bounded["local_error"] <= bound and bounded["error"] <= 0.01
    assert free["patches_after"] < bounded["patches_after"] < 132
    assert f"in small parts up to {bounded['local_error']:.5f}" in said


@pytest.mark.parametrize("quiet", [(), ("--quiet",)])
def test_in_may_be_out(fruit, quiet):
    before = fruit.read_bytes()
    assert bool(printed("simplify", fruit, "-o", fruit, *QUICK, *quiet)) != bool(quiet)
    assert fruit.read_bytes() != before
    ET.parse(fruit)
    assert set(files(fruit.parent)) == {"fruit.svg"}


def test_only_the_named_meshes(tmp_path):
    def left(*options):
        printed("simplify", SAMPLES / "two.svg", "-o", tmp_path / "out.svg", *QUICK, *options)
        return [mesh["simplified"] for mesh in meshes(tmp_path / "out.svg")]

    assert left("--id", "cap") == [False, True]
    assert left("--id", "cap", "--id", "stalk") == left("--id", "svg1") == left() == [True, True]


def test_nothing_to_merge_keeps_every_byte(tmp_path):
    face, out, report = SAMPLES / "face.svg", tmp_path / "out.svg", tmp_path / "report.json"
    said = printed("simplify", face, "-o", out, "--epsilon", "0", *QUICK, "--report", report)
    assert "nothing to merge" in said and out.read_bytes() == face.read_bytes()
    (mesh,) = json.loads(report.read_text())["meshes"]
    assert mesh["stopped"] == "nothing to merge"
    assert mesh["patches_after"] == mesh["patches_before"]


def test_what_happened_is_told_of_handles_and_of_time(tmp_path):
    one, out = tmp_path / "one.svg", tmp_path / "out.svg"
    printed("simplify", FRUIT, "-o", one, "--handles", "4", "--forget-original")
    said = printed("simplify", one, "-o", out, "--method", "plain")
    assert said.startswith("pear: 4 of 4 handles, 1 of 1 patches left, FLIP 0.00000, ")
    assert said.endswith(" s (no handle could be taken out)\n")
    said = printed("simplify", FRUIT, "-o", out, "--resolution", 4096, "--time-budget", 0.001)
    assert said.startswith("pear: 660 of 660 handles, ")
    assert said.endswith(" s (no time left)\n")
    (mesh,) = simplified(SAMPLES / "photo.svg", out, "--resolution", 4096, "--time-budget", 0.001)
    assert mesh["stopped"] == "budget"
    ET.parse(out)


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
@pytest.mark.full(all_but=1)
def test_targets(fruit, options, left):
    report = fruit.with_name("report.json")
    printed("simplify", fruit, "--preview", "--resolution", 200, "--report", report, *options)
    (mesh,) = json.loads(report.read_text())["meshes"]
    what, most = left
    assert most / 2 <= mesh[f"{what}_after"] <= most < mesh[f"{what}_before"]
    assert (mesh["method"] == "plain") == (what == "handles" and "motorcycle" not in options)


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
    bad, path, out = BAD[name], tmp_path / "bad.svg", tmp_path / "out.svg"
    secret = tmp_path / "secret"
    secret.write_text("#abcdef")
    path.write_text(bad.text.replace("SECRET", secret.as_uri()))
    before = files(tmp_path)
    said = refused("simplify", path, "-o", out)
    assert str(path) in said and all(word in said for word in bad.words)
    listed = gradmesh("info", path)
    if listed.returncode == 0:  # the document can be read, but not its mesh
        assert listed.stdout == f"box (fill): cannot be read: {said}\n"
    else:
        assert refused("info", path) == said
    assert refused("simplify", path, "-o", path) == said
    assert refused("render", path, "-o", tmp_path / "out.png") == said
    assert refused("publish", path, "-o", out) == said
    assert files(tmp_path) == before


def test_external_entities_are_never_read(tmp_path):
    secret, path, out = (tmp_path / name for name in ("secret", "in.svg", "out.svg"))
    secret.write_text("open sesame")
    doctype = f'<!DOCTYPE svg [<!ENTITY e SYSTEM "{secret.as_uri()}">]>'
    path.write_text(doctype + "<svg" + FRUIT.read_text().partition("<svg")[2].replace("Pear<", "&e;<", 1))
    assert "&e;" in path.read_text()
    printed("simplify", path, "-o", out, *QUICK)
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
    said = refused("simplify", path, "-o", out, *(f"--id={name}" for name in ids))
    assert str(path) in said and words in said
    assert not out.exists()


def test_files_that_cannot_be_read_or_written(fruit):
    folder, before = fruit.parent, files(fruit.parent)
    gone = folder / "gone"
    for name, arguments in (
        (gone, ["info", gone]),
        (folder, ["info", folder]),
        (gone / "x", ["simplify", fruit, "-o", gone / "x", *QUICK]),
        (folder, ["simplify", fruit, "-o", folder, *QUICK]),
        (gone / "x", ["render", fruit, "-o", gone / "x"]),
        (gone, ["compare", gone, gone]),
    ):
        assert str(name) in refused(*arguments)
    assert files(folder) == before


def test_files_of_any_name(tmp_path):
    folder = tmp_path.joinpath("Jörg Müller", *["ein Ordner mit langem Namen, один или 日本"] * 6)
    folder.mkdir(parents=True)
    fruit, fewer, picture = (folder / name for name in ("Früchte.svg", "wenig ö.svg", "ä.png"))
    assert len(str(fruit)) > 260
    fruit.write_bytes(FRUIT.read_bytes())
    report, page = folder / "ü.json", folder / "ß.html"
    printed("simplify", fruit, "-o", fewer, *QUICK, "--report", report, "--original", fruit)
    assert json.loads(report.read_text(encoding="utf-8"))["meshes"][0]["original"] == str(fruit)
    printed("report", fruit, fewer, "-o", page, "--resolution", 64, "--id", "pear")
    assert "Früchte.svg" in page.read_text(encoding="utf-8")
    printed("render", fewer, "-o", picture, "--id", "pear")
    assert printed("compare", picture, picture) == "0.000000\n"
    assert len(files(folder)) == 5
    assert "/ä.svg cannot be read" in refused("info", folder / "ä.svg")


def test_compressed_documents(tmp_path, fruit):
    plain, packed = tmp_path / "plain.svg", tmp_path / "packed.svgz"
    quick = ("--id", "pear", *QUICK)
    for out in (plain, packed):
        printed("simplify", fruit, "-o", out, *quick)
    assert gzip.decompress(packed.read_bytes()) == plain.read_bytes()
    # No time and no name in the header: equal documents are equal files.
    assert packed.read_bytes()[3:10] == b"\0\0\0\0\0\x02\xff"

    # By its content, whatever its name; written as the name of OUT says.
    misnamed, again = tmp_path / "misnamed.svg", tmp_path / "again.svg"
    misnamed.write_bytes(gzip.compress(fruit.read_bytes(), mtime=7))
    assert printed("info", misnamed) == printed("info", fruit)
    printed("simplify", misnamed, "-o", again, *quick)
    assert again.read_bytes() == plain.read_bytes()
    # What is not changed stays as it was, packed or not.
    one_patch = document(row(FIRST)).encode()
    misnamed.write_bytes(gzip.compress(one_patch, mtime=7))
    for out, expected in ((packed, misnamed.read_bytes()), (again, one_patch)):
        printed("simplify", misnamed, "-o", out)
        assert out.read_bytes() == expected


@pytest.mark.parametrize("damage", [lambda b: b[:-9], lambda b: b[:99] + b"x" + b[100:], lambda b: b[:2]])
def test_damaged_compressed_documents(tmp_path, damage):
    path = tmp_path / "in.svgz"
    path.write_bytes(damage(gzip.compress(FRUIT.read_bytes())))
    said = refused("info", path)
    assert str(path) in said and ("damaged" in said or "unpacks to" in said)


def test_the_limit_counts_what_is_unpacked(tmp_path):
    path = tmp_path / "in.svgz"
    path.write_bytes(gzip.compress(b"<svg>" + b" " * 10_000_000 + b"</svg>"))
    said = refused("info", path, env={"GRADMESH_LIMITS": "document=9M"})
    assert "unpacks to 10000011 bytes" in said and "GRADMESH_LIMITS=document=10000011" in said


def test_render(tmp_path):
    image = pytest.importorskip("PIL.Image")
    png = tmp_path / "out.png"
    printed("render", FRUIT, "-o", png, "--resolution", 200)
    with image.open(png) as picture:
        assert max(picture.size) == 200 and picture.mode == "RGB"
        assert len(picture.getcolors(1 << 24)) > 1000
    assert "--id" in refused("render", SAMPLES / "two.svg", "-o", png)
    printed("render", SAMPLES / "two.svg", "-o", png, "--id", "cap")


@pytest.mark.parametrize("metric, epsilon", [("flip", 0.01), ("ssim", 0.005)])
@pytest.mark.full(all_but=1)
def test_compare(tmp_path, metric, epsilon):
    out, by = tmp_path / "out.svg", ("--metric", metric)
    (mesh,) = simplified(FRUIT, out, *QUICK, *by, "--epsilon", epsilon, "--whole-mesh")
    pictures = [tmp_path / f"{svg.stem}.png" for svg in (FRUIT, out)]
    for svg, png in zip((FRUIT, out), pictures):
        printed("render", svg, "-o", png)
    assert error(FRUIT, FRUIT, *by) == 0
    assert error(FRUIT, out, *by) == pytest.approx(mesh["error"], abs=2e-4)
    assert error(*pictures, *by) == pytest.approx(mesh["error"], abs=2e-4)


def test_what_cannot_be_compared(tmp_path):
    small, large, empty = tmp_path / "100.png", tmp_path / "200.png", tmp_path / "empty.svg"
    printed("render", FRUIT, "-o", small, "--resolution", 100)
    printed("render", FRUIT, "-o", large, "--resolution", 200)
    assert "size" in refused("compare", small, large)
    assert "must hold one" in refused("compare", SAMPLES / "two.svg", SAMPLES / "two.svg")
    empty.write_text(DOCUMENT.format(defs=""))
    assert str(empty) in refused("compare", FRUIT, empty)
