"""What Simplify by Eye shows and does, without its window."""

import sys

import pytest

from built import ROOT, SAMPLES
from extension_runs import extension, refused, run  # noqa: F401

import gradmesh

sys.path.append(str(ROOT / "extension"))  # after the tests' own modules

import gradmesh_eye  # noqa: E402
from gradmesh_eye_words import hint, legend, redo_tip, summary, undo_tip  # noqa: E402

SIZE = (300, 360)


@pytest.fixture
def eye():
    eye = gradmesh_eye.Eye(gradmesh.load(SAMPLES / "two.svg"), ["stalk", "cap"], resolution=100)
    eye.resize(*SIZE)
    eye.fit_to_window()
    yield eye
    eye.close()


def found(eye):
    eye.session.refresh(wait=True)
    return eye


def line_at(eye):
    """A pixel at which a click takes a line out."""
    for y in range(0, SIZE[1], 3):
        eye.point(SIZE[0] / 2, y)
        if eye.pointed is not None and eye.pointed.handles is not None:
            return SIZE[0] / 2, y
    raise AssertionError("there is no line")


def test_what_is_at_a_place_stays_there_when_it_is_enlarged(eye):
    for factor in (1.25, 3, 0.1):
        before = eye.place_at(40, 70)
        eye.zoom(factor, 40, 70)
        assert eye.place_at(40, 70) == pytest.approx(before)
    scale = eye.scale
    eye.pan(10, -20)
    assert eye.place_at(50, 50) == pytest.approx(before)
    eye.zoom(1e-30)
    eye.zoom(1e60)
    assert 0 < eye.scale < float("inf")
    eye.zoom_to(scale)
    assert eye.scale == pytest.approx(scale)


def test_the_mesh_fills_the_window(eye):
    left, top, right, bottom = eye.session.box
    for x, y in ((left, top), (right, bottom)):
        pixel = [s / 2 + (p - m) * eye.scale for s, p, m in zip(SIZE, (x, y), eye.middle)]
        assert all(0 <= p <= s for p, s in zip(pixel, SIZE))
    assert eye.picture()[:2] == SIZE


def test_the_slider_goes_along_the_curve(eye):
    states = found(eye).states
    assert len(states) > 3 and eye.status["state"] == 0 and not eye.is_searching
    assert set(eye.marks) == {"Gentle", "Balanced", "Strong"}
    eye.step(1)
    assert eye.status["handles"] == states[1]["handles"]
    for state in range(2, len(states)):
        eye.slide(state, moving=True)
    eye.slide(len(states) - 1)
    eye.step(5)  # it ends there
    assert eye.status["state"] == len(states) - 1
    eye.undo()
    assert eye.status["state"] == 1, "what only passed by is no step"
    eye.slide(-3)
    assert eye.is_unchanged
    eye.click()
    assert eye.is_unchanged, "nothing was pointed at"


def test_from_an_edit_the_arrow_keys_lead_to_a_state_like_it(eye):
    found(eye)
    eye.point(*line_at(eye))
    assert eye.click() and eye.status["state"] == -1 and eye.pointed is None
    now = eye.status["handles"]
    eye.step(1)
    nearest = min(eye.states, key=lambda state: abs(state["handles"] - now))
    assert eye.states[eye.status["state"]]["handles"] == nearest["handles"]


def test_the_hint_tells_of_the_click_before_it_is_made(eye):
    assert "Point at a line" in hint(eye)
    place = line_at(eye)
    told = hint(eye)
    eye.click()
    assert told.startswith(f"A click: {eye.status['handles']} handles, {eye.status['patches']} patches")
    eye.leave()
    assert "Point at a line" in hint(eye) and place
    assert summary(eye).splitlines()[1] == f"{eye.status['patches']} of 36 patches"


def everywhere():
    width, height = SIZE
    return [(0, 0), (width, 0), (width, height), (0, height)]


def test_what_is_marked_is_merged_protected_and_released(eye):
    eye.lasso = everywhere()
    eye.mark()
    assert len(eye.marked) == 36 and not eye.lasso
    assert "Marked patches: 36" in hint(eye) and "makes them one: error 0.3" in hint(eye)
    x, y = line_at(eye)
    eye.mark_patch(x, y + 12)  # a line is met from outside, too
    assert len(eye.marked) == 35
    assert not eye.is_release
    eye.protect_marked()
    assert len(eye.status["protected"]) == 35 and not eye.marked
    assert "36 of 36 patches, 35 protected" in summary(eye)
    eye.lasso = everywhere()
    eye.mark()
    assert not eye.is_release, "one of them is not protected yet"
    eye.protect_marked()
    eye.lasso = everywhere()
    eye.mark()
    assert eye.is_release
    with pytest.raises(gradmesh.InputError, match="protected"):
        eye.merge_marked()
    eye.protect_marked()
    assert not eye.status["protected"]
    eye.lasso = everywhere()
    eye.mark()
    eye.merge_marked()
    assert eye.status["patches"] == 1
    assert undo_tip(eye) == "Take back: Merge 36 patches (Ctrl+Z)" and redo_tip(eye) == "Nothing to make again"


def test_errors_count_more_in_what_is_marked(eye):
    eye.lasso = everywhere()
    eye.mark()
    before = eye.picture()
    eye.weigh_marked(4)
    assert eye.status["weighted"] and not eye.marked and eye.picture() != before
    assert undo_tip(eye) == "Take back: Let errors count otherwise (Ctrl+Z)"
    eye.undo()
    assert not eye.status["weighted"]


def test_a_straight_drag_spans_a_rectangle(eye):
    width, height = SIZE
    eye.lasso = [(0, 0), (width / 2, height / 2 + 8), (width, height)]
    assert len(eye.outline) == 4
    eye.mark()
    assert len(eye.marked) == 36
    eye.lasso = [(0, 0), (width, 0), (width, height)]
    assert eye.outline == eye.lasso


def test_only_what_is_marked_changes_whatever_was_protected(eye):
    width, height = SIZE
    eye.lasso = everywhere()
    eye.mark()
    eye.protect_marked()
    eye.lasso = [(0, 0), (width, 0), (width, height / 2), (0, height / 2)]
    eye.mark()
    free = eye.marked
    eye.protect_others()
    assert free and sorted([*free, *eye.status["protected"]]) == list(range(36))
    eye.undo()
    assert len(eye.status["protected"]) == 36


def test_a_brush_marks_what_it_touches(eye):
    x, y = line_at(eye)
    eye.brushes = True
    eye.point(x, y + 12)
    assert eye.pointed.handles is None and "brush" in hint(eye), "a click would only mark"
    eye.brush([(x, y + 12)])
    assert eye.marked == [eye.pointed.face] and "One patch is marked" in hint(eye)
    eye.brush([(x, 0), (x, SIZE[1])])
    assert len(eye.marked) > 3
    eye.brush([(-50, -50), (-40, -40)])
    assert "Marked patches" in hint(eye)


def known(eye, what):
    """What is found out, and its picture, without what is marked."""
    eye.show_known(what)
    if what != "nothing":
        eye.session.find_out(what, wait=True)
        eye.find_out()
    return eye.picture()


def test_each_thing_that_is_known_has_a_picture_and_a_legend(eye):
    x, y = line_at(eye)
    eye.point(x, y + 12)
    pictures = {what: known(eye, what) for what in gradmesh_eye.KNOWN}
    assert len(set(pictures.values())) == 4
    words = {}
    for what in gradmesh_eye.KNOWN:
        known(eye, what)
        words[what] = legend(eye)
    assert words["nothing"] == ""
    assert words["prices"].count("<span background=") == 4
    assert words["regions"].startswith("Region 1 of ")
    assert words["parts"].startswith("Parts: ")


def test_what_is_known_is_forgotten_with_the_mesh(eye):
    known(eye, "prices")
    assert not eye.is_finding_out
    eye.point(*line_at(eye))
    eye.click()
    assert eye.is_finding_out and "found out" in legend(eye)
    assert not eye.look_for_news(), "the mesh may still go on changing"
    assert eye.look_for_news() and eye.found
    eye.session.find_out("prices", wait=True)
    assert eye.look_for_news() and not eye.is_finding_out
    assert not eye.look_for_news()
    eye.fits = False
    eye.picture()
    assert eye.is_finding_out, "without fits lines cost something else"
    eye.choose("cap")
    assert eye.is_finding_out


def test_regions_of_a_patch_are_looked_through_the_largest_first(eye):
    known(eye, "regions")
    assert "Point at a patch" in legend(eye)
    x, y = line_at(eye)
    eye.mark_patch(x, y + 12)
    sizes = []
    seen = {eye.picture()}
    for _number in range(eye.found["regions"]):
        sizes.append(len(eye.region_shown["patches"]))
        assert eye.patch in eye.region_shown["patches"]
        eye.step_region(1)
        seen.add(eye.picture())
    assert len(sizes) > 1 and sizes == sorted(sizes, reverse=True) and len(seen) == len(sizes)
    assert eye.region == 0, "after the last comes the first"
    eye.step_region(-1)
    eye.picture()
    assert len(eye.to_merge) == sizes[-1] and f"Region {len(sizes)} of {len(sizes)}" in legend(eye)
    eye.merge_marked()
    assert eye.status["patches"] == 36 - sizes[-1] + 1


def test_numbers_of_patches_may_have_gaps(eye):
    eye.set_form(gradmesh_eye.BLOCKS)
    eye.point(*line_at(eye))
    assert eye.click() and eye.status["patches"] == 35
    eye.lasso = everywhere()
    eye.mark()
    everything, eye.marked = eye.marked, eye.marked[:1]
    eye.protect_others()
    assert eye.status["protected"] == everything[1:] and len(everything) == 35


def test_each_mesh_has_its_own_history_and_all_are_written(eye):
    eye.slide(len(found(eye).states) - 1)
    stalk = eye.status["handles"]
    eye.choose("cap")
    assert eye.status["unchanged"] and not eye.is_unchanged
    results = eye.apply()
    assert [(result.id, result.handles_after) for result in results] == [("stalk", stalk)]


def test_the_original_is_seen_while_a_key_is_held(eye):
    eye.slide(len(found(eye).states) - 1)
    shown = eye.picture()
    eye.flicker(True)
    held = eye.picture()
    eye.flicker(False)
    assert held != shown == eye.picture()
    eye.ground, eye.lines = "original", False
    assert eye.picture() == held


def test_the_worst_places_come_into_the_middle(eye):
    eye.slide(len(found(eye).states) - 1)
    places = eye.worst_places()
    assert places and places == sorted(places, key=lambda place: -place["error"])
    scale = eye.scale
    eye.look_at(places[0])
    assert eye.place_at(SIZE[0] / 2, SIZE[1] / 2) == pytest.approx((places[0]["x"], places[0]["y"]))
    assert eye.scale > scale


@pytest.mark.parametrize("is_dark", [False, True])
def test_the_chart_shows_where_one_is(eye, is_dark):
    first = found(eye).chart(200, 80, is_dark)
    assert first[:2] == (200, 80) and len(first[2]) == 3 * 200 * 80
    eye.step(3)
    assert eye.chart(200, 80, is_dark) != first


def test_without_a_window_a_sentence_names_the_dialog(run):  # noqa: F811
    assert "Gradient Mesh > Simplify does the same" in refused(
        run(SAMPLES / "fruit.svg", "--id=pear", item="simplify_by_eye", GRADMESH_UNATTENDED="0")
    )


def test_a_document_has_one_window(monkeypatch, tmp_path):
    from gradmesh_lock import only_window

    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setenv("DOCUMENT_PATH", "/home/somebody/apple.svg")
    for _ in range(2):
        with only_window() as is_first, only_window() as is_second:
            assert is_first and not is_second
            monkeypatch.setenv("DOCUMENT_PATH", "/home/somebody/pear.svg")
            with only_window() as is_other:
                assert is_other
        monkeypatch.setenv("DOCUMENT_PATH", "/home/somebody/apple.svg")
    assert not list(tmp_path.rglob("*.lock"))


def test_selected_shapes_protect_what_they_cover(run):  # noqa: F811
    eye = '<circle id="eye" cx="240" cy="420" r="40"/></svg>'
    drawing = (SAMPLES / "fruit.svg").read_text().replace("</svg>", eye)

    def handles(*options):
        done = run(drawing, "--id=pear", "--id=eye", "--resolution=100", *options)
        assert (done.returncode, done.stderr) == (0, "")
        (pear,) = gradmesh.loads(done.stdout).meshes
        return pear.handles

    assert handles() < handles("--protect_selected=true")
