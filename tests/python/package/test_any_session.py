"""Whatever a person does by eye, in whatever order: sound meshes, exact undo and redo, and a document that
reads back as it was shown. What cannot be done says why in one sentence and changes nothing."""

import functools
from random import Random

import pytest

pytest.importorskip("hypothesis", reason="Debian package python3-hypothesis is absent")
from hypothesis import Phase, settings, strategies as st  # noqa: E402
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, precondition, rule  # noqa: E402

from built import ROOT, SAMPLES  # noqa: E402

import gradmesh  # noqa: E402

pytestmark = pytest.mark.module_only

SHARED = ROOT.parent / "shared"
SIZE = 60  # pixels of pictures, along each side
#: Grids, smooth colours, tensors, and T-junctions of blocks that were simplified before.
DRAWINGS = [
    ("two.svg", "stalk", False),
    ("smooth.svg", "vase", False),
    ("tensor.svg", "silk", False),
    ("transformed.svg", "leaf", True),
]
MOST_PATCHES = 200  # beyond which nothing is split, as each step would take seconds
FRACTIONS = st.floats(0, 1)
#: What a step of the machine looks at of a status.
SHOWN = ("handles", "patches", "objects", "error", "local_error", "protected", "form", "unchanged")


@functools.lru_cache(maxsize=None)
def drawing(name, mesh, is_merged):
    document = gradmesh.load(SAMPLES / name)
    if is_merged:
        gradmesh.simplify(document, mesh, method="best", resolution=100, epsilon=0.02)
    return document.to_bytes()


class AnySession(RuleBasedStateMachine):
    @initialize(drawn=st.sampled_from(DRAWINGS))
    def open(self, drawn):
        self.begin(gradmesh.loads(drawing(*drawn), drawn[0]), drawn[1])

    def begin(self, document, mesh):
        self.document = document
        self.session = gradmesh.Session(document, mesh, resolution=40)
        left, top, right, bottom = self.session.box
        scale = 0.9 * SIZE / max(right - left, bottom - top)
        self.view = gradmesh.View(SIZE, SIZE, (left + right) / 2, (top + bottom) / 2, scale)
        self.first = self.seen()

    def seen(self):
        status = self.session.refresh()
        return {name: status[name] for name in SHOWN}, self.session.paint(self.view, lines=True)[2]

    def attempt(self, deed):
        """Does something, or sees that its refusal is a sentence and that nothing has changed."""
        before = self.seen()
        try:
            deed()
        except gradmesh.InputError as error:
            text = str(error)
            assert text.endswith(".") and "\n" not in text and "std::" not in text
            assert self.seen() == before

    def patches_around(self, x, y, size):
        """Patches in a rectangle, by shares of the picture."""
        left, top = SIZE * x, SIZE * y
        right, bottom = left + SIZE * size, top + SIZE * size
        return self.session.patches_in(self.view, [(left, top), (right, top), (right, bottom), (left, bottom)])

    @rule(shares=st.lists(FRACTIONS, min_size=1, max_size=3))
    def pulls_the_slider(self, shares):
        kind = "one gradient"
        states = self.session.refresh(wait=True)["curves"].get(kind, {}).get("states", [])
        if not states:
            return
        *passed, last = (round(share * (len(states) - 1)) for share in shares)
        for state in passed:
            self.session.show(kind, state, moving=True)
        self.session.show(kind, last)

    @rule(x=FRACTIONS, y=FRACTIONS, edit=st.sampled_from(["merge", "rows", "columns", "both"]), fits=st.booleans())
    def clicks(self, x, y, edit, fits):
        if self.session.status["patches"] > MOST_PATCHES:
            edit = "merge"

        def click():
            if self.session.point(self.view, SIZE * x, SIZE * y, edit, fits):
                self.session.make()

        self.attempt(click)

    def point_and_make(self, x, y, edit, **how):
        def click():
            pointed = self.session.point(self.view, SIZE * x, SIZE * y, edit, reach=SIZE / 4, **how)
            if pointed and pointed.why_not:
                raise pointed.why_not
            if pointed and pointed.handles is not None:
                self.session.make()
                status = self.session.status
                assert (status["handles"], status["error"]) == (pointed.handles, pointed.error)

        self.attempt(click)

    @rule(x=FRACTIONS, y=FRACTIONS, edit=st.sampled_from(["straight", "curve", "join"]))
    def changes_a_side_or_joins(self, x, y, edit):
        self.point_and_make(x, y, edit)

    @rule(x=FRACTIONS, y=FRACTIONS, color=st.sampled_from(["#e04020", "navy"]), sharp=st.booleans())
    def sets_a_colour(self, x, y, color, sharp):
        self.point_and_make(x, y, "color", color=color, sharp=sharp)

    @rule(x=FRACTIONS, y=FRACTIONS, dx=st.floats(-0.1, 0.1), dy=st.floats(-0.1, 0.1))
    def moves_a_point_or_handle(self, x, y, dx, dy):
        self.point_and_make(x, y, "move", to=(SIZE * (x + dx), SIZE * (y + dy)))

    @rule(x=FRACTIONS, y=FRACTIONS, size=st.floats(0.1, 0.6), fits=st.booleans())
    def merges_a_set(self, x, y, size, fits):
        patches = self.patches_around(x, y, size)
        self.attempt(lambda: self.session.merge(patches, fits))

    @rule(x=FRACTIONS, y=FRACTIONS, size=st.floats(0.1, 0.6), protect=st.booleans())
    def protects(self, x, y, size, protect):
        patches = self.patches_around(x, y, size)
        self.attempt(lambda: self.session.protect(patches, protect))

    @rule(x=FRACTIONS, y=FRACTIONS, size=st.floats(0.3, 1))
    def protects_others(self, x, y, size):
        patches = self.patches_around(x, y, size)
        self.attempt(lambda: self.session.protect_others(patches))

    @rule(x=FRACTIONS, y=FRACTIONS, size=st.floats(0.1, 0.6), factor=st.sampled_from([0.25, 1, 4]))
    def weighs(self, x, y, size, factor):
        patches = self.patches_around(x, y, size)
        self.attempt(lambda: self.session.weigh(patches, factor))

    @rule(form=st.sampled_from(["one gradient", "blocks"]))
    def changes_the_form(self, form):
        self.attempt(lambda: self.session.set_form(form))

    @rule()
    def fits(self):
        self.attempt(self.session.fit)

    @rule()
    def undoes(self):
        self.session.undo()

    @rule()
    def redoes(self):
        self.session.redo()

    @precondition(lambda self: self.session.status["undo"])
    @rule()
    def goes_back_and_forth(self):
        now, name = self.seen(), self.session.undo_name
        self.session.undo()
        before = self.seen()
        assert self.session.redo_name == name and "{" not in name
        self.session.redo()
        assert self.seen() == now
        self.session.undo()
        assert self.seen() == before

    @invariant()
    def patches_have_numbers(self):
        status = self.session.status
        assert 0 <= len(status["protected"]) <= status["patches"] and status["handles"] >= 4

    def teardown(self):
        if not hasattr(self, "first"):
            return
        while self.session.status["undo"]:
            self.session.undo()
        assert self.seen() == self.first
        while self.session.status["redo"]:
            self.session.redo()
        status = self.session.refresh()
        result = self.session.write()
        assert (result.handles_after, result.objects) == (status["handles"], status["objects"])
        read = {mesh.id: mesh for mesh in gradmesh.loads(self.document.to_bytes()).meshes}
        mesh = read[self.session.id]
        assert (mesh.handles, mesh.patches) == (status["handles"], status["patches"])


def any_deed(machine, random):
    """Does something, chosen and placed at random."""
    x, y, size = random.random(), random.random(), random.uniform(0.1, 0.6)
    is_so = random.random() < 0.5
    deeds = {
        "slider": lambda: machine.pulls_the_slider([random.random()]),
        "click": lambda: machine.clicks(x, y, random.choice(["merge", "rows", "columns", "both"]), is_so),
        "side": lambda: machine.changes_a_side_or_joins(x, y, random.choice(["straight", "curve", "join"])),
        "colour": lambda: machine.sets_a_colour(x, y, "#e04020", is_so),
        "move": lambda: machine.moves_a_point_or_handle(x, y, size / 10, -size / 10),
        "merge": lambda: machine.merges_a_set(x, y, size, is_so),
        "protect": lambda: machine.protects(x, y, size, is_so),
        "weigh": lambda: machine.weighs(x, y, size, 4),
        "form": lambda: machine.changes_the_form(random.choice(["one gradient", "blocks"])),
        "fit": machine.fits,
        "back": machine.undoes,
        "again": machine.redoes,
    }
    deeds[random.choice(list(deeds))]()


#: Documents that people have made, and the paper's duck.
REAL = [*sorted((SHARED / "real").glob("*.svg")), *(SHARED / "meshes").glob("global_duck.hemesh")]


@pytest.mark.skipif(not REAL, reason="the documents beside the project are absent")
@pytest.mark.parametrize("file", REAL, ids=lambda file: file.stem)
@pytest.mark.full(all_but=1)
def test_any_session_over_real_documents(file):
    document = gradmesh.load(file)
    try:
        session = gradmesh.Session(document, document.meshes[0].id, resolution=40)
    except gradmesh.InputError as error:
        pytest.skip(str(error).replace(str(file), file.name))
    random = Random(len(file.name))
    machine = AnySession()
    machine.begin(document, session.id)
    for _step in range(8):
        any_deed(machine, random)
    machine.teardown()


def so_many(examples, steps):
    # To make an example of seconds smaller takes more minutes than it saves.
    return settings(
        max_examples=examples,
        stateful_step_count=steps,
        deadline=None,
        derandomize=True,
        phases=[Phase.generate],
    )


AnySession.TestCase.settings = so_many(12, 25)
TestAnySession = AnySession.TestCase


@pytest.mark.long
def test_many_sessions():
    from hypothesis.stateful import run_state_machine_as_test

    run_state_machine_as_test(AnySession, settings=so_many(2000, 50))
