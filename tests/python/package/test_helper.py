"""The program that does the module's work: the same results, and one sentence where it fails."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from built import PACKAGES, PROGRAM, PYTHON, SAMPLES

import gradmesh
from gradmesh import core as cores
from gradmesh import helper as helpers
from gradmesh.interrupts import Interrupts

TWO = SAMPLES / "two.svg"

pytestmark = pytest.mark.module_only


def new_core(program=PROGRAM):
    return cores.Core(helpers.Helper(Path(program), cores.PROTOCOL))


@pytest.fixture
def use(monkeypatch):
    """Makes the package use a core from now on, or the helper that is this program."""

    def use(core):
        chosen = core if isinstance(core, cores.Core) else new_core(core)
        monkeypatch.setattr(cores, "_core", chosen)
        return chosen

    return use


@pytest.fixture
def fake(tmp_path, use):
    """Uses a program whose answers after the greeting are the result of a few lines of Python, in
    which say() and hear() send and read messages."""

    def fake(lines, hello='{"result": {"protocol": 5, "version": "0"}}'):
        program = tmp_path / "program"
        program.write_text(
            f"#!{PYTHON}\n"
            "import json, os, sys, time\n"
            "def hear():\n"
            "    return json.loads(sys.stdin.buffer.read(int(sys.stdin.buffer.readline())))\n"
            "def say(text):\n"
            "    sys.stdout.buffer.write(b'%d\\n%b' % (len(text), text.encode()))\n"
            "    sys.stdout.buffer.flush()\n"
            f"hear()\nsay({hello!r})\n{lines}\n"
        )
        program.chmod(0o755)
        return use(program)

    return fake


def failure():
    """What a person is told when a document is read."""
    with pytest.raises(gradmesh.HelperError) as raised:
        gradmesh.load(TWO)
    assert raised.value.message[0].format(*raised.value.message[1]) == str(raised.value)
    return str(raised.value)


def module_core():
    return cores.Core(pytest.importorskip("gradmesh._core").Service())


def everything(sample):
    """What a person gets of a sample: its meshes, results, bytes and picture."""
    document = gradmesh.load(SAMPLES / f"{sample}.svg")
    seen = []
    before = document.meshes
    results = gradmesh.simplify(
        document, resolution=100, renderer="software", progress=seen.append
    )
    facts = [{**vars(result), "seconds": 0, "run": {**result.run, "seconds": 0}} for result in results]
    painted = gradmesh.render(document, results[0].id, 100)
    # How often progress is told depends on the threads.
    return before, facts, document.to_bytes(), painted.tobytes(), painted.shape, bool(seen)


@pytest.mark.parametrize("sample", ["fruit", "opacity", "stroke", "tensor"])
@pytest.mark.full(all_but=1)
def test_the_same_comes_of_module_and_helper(use, sample):
    use(module_core())
    by_module = everything(sample)
    use(PROGRAM)
    by_helper = everything(sample)
    assert by_module == by_helper
    assert by_helper[-1]


def test_numbers_and_bytes_arrive_as_they_are():
    values = [0.1, -1e-300, 1e308, 2**64 - 1, -(2**63), "ä\u2028\0", bytes(range(256)), None, True]
    values += [float("inf"), float("-inf"), [], {"a": [{}]}]
    text = json.dumps(helpers.plain(values))
    assert json.loads(text, object_hook=helpers.restored) == values


def test_a_greeting_of_another_version(fake):
    fake("", hello='{"result": {"protocol": 99, "version": "9"}}')
    assert "is of another version than the rest of gradmesh (99, not 5): install" in failure()


NO_SENSE, DIED = "gave an answer that makes no sense.", "ended before its work was done."
FAULTY = {
    "text": ("print('Segmentation fault', flush=True); time.sleep(60)", NO_SENSE),
    "no JSON": ("sys.stdout.buffer.write(b'5\\nabcde'); sys.stdout.flush(); time.sleep(60)", NO_SENSE),
    "too long": ("sys.stdout.buffer.write(b'99999999999\\n{}'); sys.stdout.flush(); time.sleep(60)", NO_SENSE),
    "a list": ("say('[1, 2]'); time.sleep(60)", NO_SENSE),
    "empty": ("say('{}'); time.sleep(60)", NO_SENSE),
    "no message": ("say('{\"error\": \"input\", \"message\": 3}'); time.sleep(60)", NO_SENSE),
    "no text": ("say('{\"error\": \"value\"}'); time.sleep(60)", NO_SENSE),
    "dies": ("sys.exit(3)", DIED),
    "dies at work": ("hear(); os.kill(os.getpid(), 9)", DIED),
    "dies within a message": ("sys.stdout.buffer.write(b'50\\n{')", NO_SENSE),
}


@pytest.mark.parametrize("fault", FAULTY)
def test_a_program_that_is_no_helper(fake, fault):
    lines, words = FAULTY[fault]
    fake(lines)
    assert failure().endswith(words)


@pytest.mark.parametrize(
    "lines",
    ["time.sleep(600)", "hear(); time.sleep(600)", "hear(); say('{\"alive\": true}'); time.sleep(600)"],
    ids=["neither reads nor writes", "only reads", "lived once"],
)
@pytest.mark.full(all_but=1)
def test_a_program_that_hangs(fake, monkeypatch, lines):
    monkeypatch.setattr(helpers, "SILENCE", 1.0)
    core = fake(lines)
    data = b" " * (4 << 20)  # more than a pipe takes
    with pytest.raises(gradmesh.HelperError, match="did not answer for 1 seconds"):
        gradmesh.loads(data)
    assert not core.works


def test_signs_of_life_are_waited_for(fake, monkeypatch):
    monkeypatch.setattr(helpers, "SILENCE", 2.0)
    fake(
        "hear()\n"
        "for i in range(6):\n    say('{\"alive\": true}'); time.sleep(0.5)\n"
        "say('{\"error\": \"value\", \"text\": \"in the end\"}'); time.sleep(60)"
    )
    with pytest.raises(ValueError, match="in the end"):
        gradmesh.load(TWO)


def test_a_program_that_cannot_be_started(tmp_path, use):
    use(tmp_path / "missing")
    assert "cannot be started (No such file or directory): install gradmesh in a folder" in failure()
    (tmp_path / "text").write_text("no program")
    use(tmp_path / "text")
    assert "cannot be started (Exec format error)" in failure()


def test_the_bit_to_run_it_may_be_lost(tmp_path, use):
    folder = tmp_path / "ein Ordner, täglich"
    folder.mkdir()
    program = folder / "gradmesh"
    program.write_text(f'#!/bin/sh\nexec "{PROGRAM}" "$@"\n')
    program.chmod(0o644)
    use(program)
    assert gradmesh.load(TWO).ids == ["stalk", "cap"]


def helper_of(core):
    return core._service._process.pid


def test_after_a_crash_documents_are_lost_and_others_can_be_read(use, monkeypatch):
    monkeypatch.setenv(cores.CHOICE, "helper")
    core = use(PROGRAM)
    document = gradmesh.load(TWO)
    os.kill(helper_of(core), signal.SIGKILL)
    with pytest.raises(gradmesh.HelperError, match="ended before its work was done"):
        gradmesh.simplify(document)
    with pytest.raises(gradmesh.HelperError, match="read the document again"):
        document.to_bytes()
    other = gradmesh.load(TWO)
    assert other.to_bytes() == TWO.read_bytes()
    with pytest.raises(gradmesh.HelperError, match="read the document again"):
        gradmesh.simplify(other, original=document)


def test_what_progress_raises_ends_the_run_and_nothing_else(use):
    use(PROGRAM)
    document = gradmesh.load(TWO)

    def progress(*_):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        gradmesh.simplify(document, resolution=100, progress=progress)
    assert document.to_bytes() == TWO.read_bytes()


def test_progress_goes_on_with_anything_that_is_true(use):
    use(PROGRAM)
    document = gradmesh.load(TWO)
    answers = iter((1, "yes", None, True))
    results = gradmesh.simplify(
        document, method="grid", resolution=100, progress=lambda *_: next(answers, None)
    )
    assert {result.stopped for result in results} == {"done"}


@pytest.mark.parametrize("epsilon", [object(), "0.01", [1]])
def test_an_argument_of_another_type_loses_nothing(use, epsilon):
    core = use(PROGRAM)
    document = gradmesh.load(TWO)
    with pytest.raises(TypeError):
        gradmesh.simplify(document, epsilon=epsilon)
    with pytest.raises(UnicodeEncodeError):
        gradmesh.save(document, "no Unicode \udc80")
    assert core.works and document.ids


def test_relative_paths_begin_where_python_is(use, tmp_path, monkeypatch):
    use(PROGRAM)
    document = gradmesh.load(TWO)
    monkeypatch.chdir(tmp_path)
    gradmesh.save(document, "copy.svg")
    assert (tmp_path / "copy.svg").read_bytes() == TWO.read_bytes()
    with pytest.raises(gradmesh.InputError, match="^missing.svg cannot be read"):
        gradmesh.load("missing.svg")


def test_files_of_any_name(use, tmp_path):
    use(PROGRAM)
    folder = tmp_path.joinpath("Jörg Müller", *["ein Ordner mit langem Namen, один или 日本"] * 6)
    folder.mkdir(parents=True)
    copy = folder / "Früchte.svg"
    gradmesh.save(gradmesh.load(TWO), copy)
    assert len(str(copy)) > 260 and copy.read_bytes() == TWO.read_bytes()
    assert gradmesh.load(copy).ids == ["stalk", "cap"]


def test_a_callback_cannot_ask_for_more(use):
    use(PROGRAM)
    document = gradmesh.load(TWO)
    with pytest.raises(RuntimeError, match="gradmesh is at work"):
        gradmesh.simplify(document, resolution=100, progress=lambda *_: document.ids)
    assert document.ids == ["stalk", "cap"]


def test_documents_that_are_gone_are_released(use):
    core = use(PROGRAM)
    number = gradmesh.load(TWO)._core.number  # the document itself is gone at once
    assert gradmesh.load(TWO).ids
    with pytest.raises(ValueError, match=f"there is no document {number}"):
        core.call("ids", document=number)


def ends(pid, seconds=20):
    """Whether a process ends."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        try:
            # A zombie, whom nobody has asked how it ended, works no more.
            if Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "Z":
                return True
        except FileNotFoundError:
            return True
        time.sleep(0.05)
    return False


def start_python(code, **environment):
    """Starts Python by itself, with the helper unless the environment says otherwise."""
    return subprocess.Popen(
        [sys.executable, "-c", code],
        env={**os.environ, "PYTHONPATH": str(PACKAGES), cores.CHOICE: "helper", **environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )


def python(code, **environment):
    """What Python has said and complained, once it has ended."""
    running = start_python(code, **environment)
    return running.communicate(timeout=100)


@pytest.mark.parametrize("at_work", [False, True], ids=["idle", "at work"])
def test_the_helper_ends_with_python(at_work):
    work = "gradmesh.simplify(d, resolution=2000, method='best', progress=tell)"
    running = start_python(
        "import gradmesh, gradmesh.core, time\n"
        "told = []\n"
        "def tell(*_):\n"
        "    if not told: print(gradmesh.core.core()._service._process.pid, flush=True)\n"
        "    told.append(1)\n"
        f"d = gradmesh.load({str(SAMPLES / 'photo.svg')!r})\n"
        f"{work if at_work else 'tell(); time.sleep(600)'}\n"
    )
    pid = int(running.stdout.readline())
    running.kill()
    running.communicate()
    assert ends(pid)


#: What a shell starts in the background may have been told to pass over Ctrl+C.
HEARS_CTRL_C = "import signal\nsignal.signal(signal.SIGINT, signal.default_int_handler)\n"


@pytest.fixture
def hears_ctrl_c():
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def test_ctrl_c_gives_the_run_up_and_keeps_the_document():
    running = start_python(
        f"{HEARS_CTRL_C}import gradmesh, gradmesh.core\n"
        f"d = gradmesh.load({str(SAMPLES / 'photo.svg')!r})\n"
        "try:\n"
        "    gradmesh.simplify(d, resolution=2000, progress=lambda *_: print('at work', flush=True))\n"
        "except KeyboardInterrupt:\n"
        "    print('given up', len(d.to_bytes()), gradmesh.core.core().works)\n"
    )
    assert running.stdout.readline() == "at work\n"
    os.killpg(running.pid, signal.SIGINT)  # as a terminal does
    said, _ = running.communicate(timeout=60)
    size = (SAMPLES / "photo.svg").stat().st_size
    assert said.splitlines()[-1] == f"given up {size} True"


def test_ctrl_c_loses_no_document_whenever_it_comes():
    """Seeded moments, of which many lie between two steps of a conversation."""
    said, complained = python(
        f"{HEARS_CTRL_C}import gradmesh, gradmesh.core, _thread, random, threading\n"
        "moments = random.Random(20)\n"
        f"d = gradmesh.load({str(SAMPLES / 'tensor.svg')!r})\n"
        "size, given_up = len(d.to_bytes()), 0\n"
        "for _ in range(200):\n"
        "    timer = threading.Timer(moments.uniform(0, 0.03), _thread.interrupt_main)\n"
        "    try:\n"
        "        timer.start()\n"
        "        while timer.is_alive():\n"
        "            gradmesh.simplify(d, method='grid', resolution=16, epsilon=0, progress=lambda *_: None)\n"
        "        timer.join()\n"
        "    except KeyboardInterrupt:\n"
        "        given_up += 1\n"
        "    timer.join()\n"
        "    assert gradmesh.core.core().works and len(d.to_bytes()) == size\n"
        "print(given_up)\n"
    )
    assert said == "200\n", complained


def test_ctrl_c_twice_does_not_wait(hears_ctrl_c):
    reached = []
    with pytest.raises(KeyboardInterrupt), Interrupts():
        for press in (1, 2):
            signal.raise_signal(signal.SIGINT)
            reached.append(press)
    assert reached == [1]


def test_ctrl_c_is_held_until_it_is_allowed(hears_ctrl_c):
    reached = []
    with Interrupts() as interrupts:
        signal.raise_signal(signal.SIGINT)
        with pytest.raises(KeyboardInterrupt), interrupts.allowed():
            reached.append("while it is held")
        with interrupts.allowed():
            reached.append("after it was let go")
    assert reached == ["after it was let go"]
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_a_handler_of_ones_own_gets_ctrl_c():
    pressed = []
    before = signal.signal(signal.SIGINT, lambda *_: pressed.append(1))
    try:
        with Interrupts():
            signal.raise_signal(signal.SIGINT)
            assert not pressed
        assert pressed == [1]
    finally:
        signal.signal(signal.SIGINT, before)


def test_a_forked_process_has_a_helper_of_its_own(use, monkeypatch):
    monkeypatch.setenv(cores.CHOICE, "helper")
    core = use(PROGRAM)
    document = gradmesh.load(TWO)
    child = os.fork()
    if child == 0:
        try:
            with pytest.raises(gradmesh.HelperError):
                document.to_bytes()
            os._exit(0 if gradmesh.load(TWO).ids == ["stalk", "cap"] else 1)
        finally:
            os._exit(2)
    assert os.waitpid(child, 0)[1] == 0
    assert core.works and document.to_bytes() == TWO.read_bytes()


def test_what_computes_can_be_chosen():
    kind = "import gradmesh.core as c; print(type(c.core()._service).__name__)"
    for choice, said in {"module": "Service\n", "helper": "Helper\n", "": "Service\n", "both": ""}.items():
        outcome = python(kind, GRADMESH_CORE=choice)
        assert outcome[0] == said
    assert "ImportError: GRADMESH_CORE is module or helper, not 'both'" in outcome[1]


def test_the_helper_where_the_module_does_not_load(tmp_path):
    package = tmp_path / "gradmesh"
    package.mkdir()
    for file in (PACKAGES / "gradmesh").glob("*.py"):
        (package / file.name).write_bytes(file.read_bytes())
    code = f"import gradmesh; print(gradmesh.load({str(TWO)!r}).ids)"
    alone = {"PYTHONPATH": str(tmp_path), "GRADMESH_CORE": "", "GRADMESH_HELPER": ""}
    for module in ("raise ImportError('of another Python')", "protocol = 0"):
        (package / "_core.py").write_text(module)
        said, _ = python(code, **{**alone, "GRADMESH_HELPER": str(PROGRAM)})
        assert said == "['stalk', 'cap']\n"
        if "raise" in module:
            assert "ImportError: of another Python" in python(code, **alone)[1]
