"""A session over one mesh, in Python: it shows, edits and protects, and writes what the command line
writes. What each edit makes of a mesh is tested in the core."""

import json

import pytest

from built import SAMPLES
from program import meshes, printed, refused

import gradmesh

FRUIT = SAMPLES / "fruit.svg"
#: The pear of the sample, 288 x 400 from (95, 180), half as large.
VIEW = gradmesh.View(200, 260, 240, 380, 0.5)


def opened(file=FRUIT, **options):
    document = gradmesh.load(file)
    return document, gradmesh.Session(document, resolution=64, **options)


def samples(session, **what):
    width, height, pixels = session.paint(VIEW, **what)
    assert (width, height, len(pixels)) == (200, 260, 3 * 200 * 260)
    return pixels


@pytest.mark.full
def test_states_are_written_as_the_command_line_does(tmp_path):
    curve, out = tmp_path / "curve.json", tmp_path / "out.svg"
    printed("simplify", FRUIT, "--curve", curve, "--resolution", 64)
    listed = {each["kind"]: each for each in json.loads(curve.read_text())["meshes"]}
    document, session = opened()
    status = session.refresh(wait=True)
    found = status["curves"]["one gradient"]
    assert found["complete"] and found["states"] == listed["one gradient"]["states"]
    assert found["marks"] == listed["one gradient"]["marks"]
    handles = [state["handles"] for state in found["states"]]
    assert handles == sorted(set(handles), reverse=True) and handles[0] == status["before"]["handles"]

    state = found["marks"]["strong"]
    status = session.show("one gradient", state)
    assert {name: status[name] for name in found["states"][state]} == found["states"][state]
    result = session.write()
    printed("simplify", FRUIT, "-o", out, "--state", state, "--resolution", 64)
    assert document.to_bytes() == out.read_bytes()
    (pear,) = meshes(out)
    assert (result.id, result.handles_after) == ("pear", handles[state]) == (pear["id"], pear["handles"])


@pytest.mark.full
def test_marked_states_are_what_the_amounts_leave(tmp_path):
    curve, state, amount = tmp_path / "curve.json", tmp_path / "state.svg", tmp_path / "amount.svg"
    size = ("--resolution", 128)
    printed("simplify", FRUIT, "--curve", curve, *size)
    (found,) = json.loads(curve.read_text())["meshes"]
    assert list(found["marks"]) == ["gentle", "balanced", "strong"]
    for name, number in found["marks"].items():
        printed("simplify", FRUIT, "-o", state, "--state", number, *size)
        printed("simplify", FRUIT, "-o", amount, "--amount", name, *size)
        assert state.read_bytes() == amount.read_bytes(), name


def test_an_edit_is_shown_before_it_is_made_and_taken_back():
    _document, session = opened()
    before = samples(session)
    # From the middle down, at the first line that the pointer meets.
    pointed = next(
        found
        for y in range(100, 200)
        if (found := session.point(VIEW, 100, y, reach=4)) and found.handles is not None
    )
    assert samples(session, proposal=True) != before == samples(session, proposal=False)
    status = session.make()
    assert (status["handles"], status["patches"]) == (pointed.handles, pointed.patches)
    assert status["error"] == pointed.error and not status["unchanged"] and status["undo"]
    assert samples(session) != before
    assert session.undo()["unchanged"] and samples(session) == before
    assert session.redo()["handles"] == pointed.handles


def at_the_first(session, edit, **how):
    """Where the first edit of that kind is that can be made, row by row, and what it does."""
    for y in range(60, 200, 4):
        for x in range(40, 160, 6):
            found = session.point(VIEW, x, y, edit, reach=4, **how)
            if found and found.handles is not None:
                return x, y, found
    raise AssertionError(f"{edit} is possible nowhere")


def test_what_is_set_by_hand_has_a_price_and_a_name():
    _document, session = opened()
    handles = session.status["handles"]
    x, y, found = at_the_first(session, "straight")
    assert found.handles == handles - 2 and found.face is not None
    assert session.make()["error"] == found.error and session.undo_name == "Make a side straight"
    assert "straight already" in str(session.point(VIEW, x, y, "straight", reach=4).why_not)
    session.undo()
    assert session.redo_name == "Make a side straight" and session.undo_name is None

    _x, _y, found = at_the_first(session, "move", to=(103, 130))
    assert found.face is None and found.error > 0
    session.make()
    assert session.undo_name in ("Move a point", "Move a handle")
    away = session.point(VIEW, 100, 150, "move", reach=100, to=(-9e9, 0)).why_not
    assert "no error is measured" in str(away)
    session.undo()

    sharp = session.point(VIEW, 100, 130, "color", reach=100, color="red", sharp=True)
    assert "blocks" in str(sharp.why_not)
    before = samples(session, lines=False)
    session.set_form("blocks")
    session.point(VIEW, 100, 130, "color", reach=100, color="red", sharp=True)
    session.make()
    assert samples(session, lines=False) != before and session.undo_name == "Set the colour of a corner"
    with pytest.raises(gradmesh.InputError, match="colours are sharp"):
        session.set_form("one gradient")
    session.point(VIEW, 100, 130, "join", reach=100)
    session.make()
    assert session.set_form("one gradient")["form"] == "one gradient"
    with pytest.raises(ValueError, match="no colour"):
        session.point(VIEW, 100, 130, "color", reach=100, color="reddish")
    with pytest.raises(ValueError, match="edits are merge, .* and move"):
        session.point(VIEW, 100, 130, "bend")


def test_merging_a_set_has_a_price():
    _document, session = opened()
    patches = session.patches_in(VIEW, [(60, 100), (140, 100), (140, 180), (60, 180)])[:2]
    price = session.propose_merge(patches)
    assert price.patches == session.status["patches"] - len(patches) + 1 and price.error > 0
    assert session.status["unchanged"]
    status = session.make()
    assert status["patches"] == price.patches and status["error"] <= price.error
    assert session.undo_name == f"Merge {len(patches)} patches"
    assert "two or more" in str(session.propose_merge(session.status["protected"]).why_not)


@pytest.mark.full
def test_errors_count_more_in_some_patches():
    document, session = opened()
    patches = session.patches_in(VIEW, [(60, 60), (140, 60), (140, 180), (60, 180)])
    session.refresh(wait=True)
    session.show("one gradient", session.status["curves"]["one gradient"]["marks"]["strong"])
    before, picture = session.status["error"], samples(session)
    patches = session.patches_in(VIEW, [(60, 60), (140, 60), (140, 180), (60, 180)])
    assert not session.status["weighted"]
    status = session.weigh(patches, 4)
    assert status["weighted"] and before < status["error"] < 4 * before and samples(session) != picture
    assert session.undo_name == "Let errors count otherwise"
    with pytest.raises(gradmesh.InputError, match="a quarter to four times"):
        session.weigh(patches, 10)
    session.undo()
    assert session.status["error"] == before and samples(session) == picture


@pytest.mark.full
def test_protected_patches_stay():
    _document, session = opened()
    everything = [(0, 0), (200, 0), (200, 260), (0, 260)]
    upper = session.patches_in(VIEW, [(0, 0), (200, 0), (200, 80), (0, 80)])
    assert 0 < len(upper) < len(session.patches_in(VIEW, everything)) == session.status["patches"]
    free = session.refresh(wait=True)["curves"]["one gradient"]["states"]
    before = samples(session)
    status = session.protect(upper)
    assert status["protected"] == upper and session.undo_name == f"Protect patches: {len(upper)}"
    assert samples(session) != before, "they are hatched"
    held = session.refresh(wait=True)["curves"]["one gradient"]["states"]
    assert held[-1]["handles"] > free[-1]["handles"]
    with pytest.raises(gradmesh.InputError, match="protected"):
        session.merge(upper)
    assert session.protect(upper, False)["protected"] == []
    assert session.undo()["protected"] == upper
    assert session.undo()["protected"] == [] and session.status["unchanged"]
    assert session.refresh(wait=True)["curves"]["one gradient"]["states"] == free


@pytest.mark.full
def test_the_first_state_is_the_mesh_as_it_is():
    _document, session = opened()
    first = session.refresh(wait=True)["curves"]["one gradient"]["states"][0]
    (pear,) = meshes(FRUIT)
    assert {name: first[name] for name in ("handles", "patches", "objects")} == {
        name: pear[name] for name in ("handles", "patches", "objects")
    }
    assert (first["error"], session.status["error"], session.worst_places()) == (0, 0, [])


def test_only_what_is_named_changes():
    _document, session = opened()
    everything = session.patches_in(VIEW, [(0, 0), (200, 0), (200, 260), (0, 260)])
    session.protect(everything)
    assert session.protect_others(everything[3:])["protected"] == everything[:3]


def test_what_is_known_is_found_out_and_forgotten():
    _document, session = opened()
    before = samples(session)
    assert not session.find_out("prices")["complete"]
    prices = session.find_out("prices", wait=True)
    errors = [step["error"] for step in prices["scale"]]
    assert errors == sorted(errors) and prices["failure"] is None
    costs = [price["error"] for price in prices["prices"]]
    assert errors[-1] == max(cost for cost in costs if cost is not None)
    left, top, right, bottom = session.box
    assert all(left <= p["x"] <= right and top <= p["y"] <= bottom for p in prices["prices"])
    assert samples(session, known="prices") != before == samples(session)
    assert samples(session, known="prices", density=2) != samples(session, known="prices")

    parts = session.find_out("parts", wait=True)
    assert parts["parts"] > 0 and parts["limit"] == 0.05 * 0.01
    (patch,) = session.patches_in(VIEW, [(100, 130)], touched=True)
    known = session.find_out("regions", patch=patch, wait=True)
    sizes = []
    for number in range(known["regions"]):
        region = session.find_out("regions", patch=patch, region=number)["region"]
        assert patch in region["patches"] and region["error"] <= 0.01
        assert region["rows"] * region["columns"] == len(region["patches"])
        sizes.append(len(region["patches"]))
    assert sizes and sizes == sorted(sizes, reverse=True)
    assert session.find_out("regions", patch=patch, region=len(sizes))["region"] is None

    session.merge(session.find_out("regions", patch=patch)["region"]["patches"])
    assert not session.find_out("parts")["complete"], "that was another mesh"
    with pytest.raises(ValueError, match="prices, regions and parts"):
        session.find_out("nothing")


@pytest.mark.full
def test_each_ground_is_another_picture():
    _document, session = opened()
    session.show("one gradient", len(session.refresh(wait=True)["curves"]["one gradient"]["states"]) - 1)
    pictures = {ground: samples(session, ground=ground) for ground in ("result", "original", "halves", "error")}
    assert len(set(pictures.values())) == 4
    with pytest.raises(ValueError, match="ground"):
        session.paint(VIEW, ground="nothing")


def test_what_cannot_be_is_refused():
    document = gradmesh.load(SAMPLES / "two.svg")
    with pytest.raises(gradmesh.InputError, match="pear"):
        gradmesh.Session(document, "pear")
    with pytest.raises(gradmesh.InputError):
        gradmesh.Session(document)  # of which of the two?
    session = gradmesh.Session(document, "cap", resolution=64)
    assert session.point(VIEW, -1e6, 0) is None
    with pytest.raises(ValueError, match="no state 9999"):
        session.show("one gradient", 9999)
    session.close()
    with pytest.raises(ValueError):
        session.refresh()
    assert not any(mesh.simplified for mesh in document.meshes)


@pytest.mark.parametrize(
    "edit",
    [
        lambda session: session.set_form("blocks"),
        lambda session: session.merge([0, 1]),
        lambda session: session.protect([9999]),
        lambda session: session.protect_others([-1]),
        lambda session: session.merge([0, 9999]),
        lambda session: session.find_out("regions", patch=9999),
        lambda session: session.paint(VIEW, marked=[9999]),
    ],
)
@pytest.mark.full(all_but=1)
def test_what_a_smooth_mesh_or_no_mesh_allows_is_refused(edit):
    _document, session = opened(SAMPLES / "smooth.svg")
    before = dict(session.status)
    with pytest.raises(gradmesh.InputError, match="follow those of the neighbours|no patch (9999|-1)") as why:
        edit(session)
    assert str(why.value).count(". ") == 0 and str(why.value).endswith(".")
    now = session.refresh()
    assert {name: now[name] for name in before} == before
    assert before["unchanged"] and before["form"] == "one gradient"


def test_lines_of_a_smooth_mesh_only_go():
    _document, session = opened(SAMPLES / "smooth.svg")
    left, top, right, bottom = session.box
    view = gradmesh.View(200, 200, (left + right) / 2, (top + bottom) / 2, 150 / max(right - left, bottom - top))
    for edit in ("rows", "columns", "both"):
        assert "follow those of the neighbours" in str(session.point(view, 100, 100, edit).why_not)
    lines = session.status["patches"]
    assert session.point(view, 100, 100, "merge", reach=100).patches < lines
    assert session.make()["patches"] < lines and session.undo()["unchanged"]


SHAPE = '<{} id="eye" fill="none"/>'


def with_shape(tmp_path, shape):
    svg = tmp_path / "shape.svg"
    svg.write_text(FRUIT.read_text().replace("</svg>", SHAPE.format(shape) + "</svg>"))
    return svg


def test_shapes_protect_what_they_cover(tmp_path):
    svg, out = with_shape(tmp_path, 'circle cx="240" cy="420" r="40"'), tmp_path / "out.svg"
    report = tmp_path / "report.json"
    handles = {}
    for protect in ((), ("--protect", "eye")):
        said = printed("simplify", svg, "-o", out, "--report", report, "--resolution", 64, *protect)
        (pear,) = json.loads(report.read_text())["meshes"]
        assert bool(pear["protected_patches"]) == bool(protect) == (" protected, " in said)
        handles[protect] = pear["handles_after"]
    assert handles[()] < handles["--protect", "eye"] < pear["handles_before"]

    document = gradmesh.load(svg)
    (result,) = gradmesh.simplify(document, resolution=64, protect=["eye"])
    assert f", {result.protected_patches} patches protected, " in said
    assert result.protected_patches == pear["protected_patches"] > 1
    assert result.handles_after == pear["handles_after"] and document.to_bytes() == out.read_bytes()
    assert gradmesh.Session(gradmesh.load(svg), "pear", protect=["eye"]).status["protected"]


def test_what_is_no_shape_protects_nothing(tmp_path):
    svg, out = with_shape(tmp_path, "g"), tmp_path / "out.svg"
    for name, words in (("eye", "eye"), ("brow", "brow")):
        assert words in refused("simplify", svg, "-o", out, "--protect", name)
    assert not out.exists()
