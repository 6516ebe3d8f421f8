"""A run in parts ends with what failed: whichever part it was, whatever came after it."""

import os
import shutil
import subprocess

import pytest

from built import PYTHON, ROOT

#: A pytest that passes, one that fails, one that cannot run.
TESTS = """
import pytest
def test_passes(): pass
def test_fails(): assert 1 + 1 == 3, "the sum"
@pytest.mark.skip(reason="no such program")
def test_cannot_run(): pass
"""
#: Fails at first, passes when it is run again.
FLAKY = """
from pathlib import Path
def test_is_in_time():
    tried = Path(__file__).with_suffix(".tried")
    again = tried.exists()
    tried.touch()
    assert again, "too late"
"""
GTEST = r"""
echo '/src/merge_test.cpp:12: Failure'
echo 'Expected equality of these values:'
exit 1
"""


@pytest.fixture
def run(tmp_path):
    """run(script): a script of these lines that runs in parts, in a folder of its own."""

    def run(script):
        (tmp_path / "scripts").mkdir(exist_ok=True)
        for name in ("parts.sh", "summary.py"):
            shutil.copy(ROOT / "scripts" / name, tmp_path / "scripts")
        pytest_here = f"{PYTHON} -m pytest -q -p no:cacheprovider -c /dev/null --rootdir {tmp_path}"
        begin = f"set -euo pipefail\ncd {tmp_path}\npytest='{pytest_here}'\n. scripts/parts.sh\n"
        env = {name: value for name, value in os.environ.items() if name != "GRADMESH_PARTS"}
        lines = f"{begin}{script}\nend_of_parts\n"
        return subprocess.run(["bash", "-c", lines], capture_output=True, text=True, env=env)

    return run


def last_part(text):
    return text[text.rindex("\n== "):]


def test_a_fault_in_pytest_is_the_last_thing_said(run, tmp_path):
    (tmp_path / "test_sums.py").write_text(TESTS)
    done = run("""
tests() { $pytest test_sums.py --junitxml "$results"; }
part pytest tests || true
part other echo fine""")
    assert done.returncode == 1
    said = last_part(done.stdout)
    assert "FAILED   pytest: 1 passed, 1 failed, 1 skipped" in said and "passed   other" in said
    assert "Could not run:\n  pytest: 1 for this reason: no such program" in said
    assert "FAILED:\n  pytest: test_sums.py::test_fails: AssertionError: the sum" in said
    assert said.endswith("tests: 1 passed, 1 failed, 1 skipped\n")


@pytest.mark.skipif(shutil.which("ctest") is None, reason="ctest is not installed")
def test_a_fault_in_ctest_is_the_last_thing_said(run, tmp_path):
    (tmp_path / "merge").write_text(GTEST)
    tests = "add_test(Merge.keeps_corners bash merge)\nadd_test(Merge.is_quick true)\n"
    (tmp_path / "CTestTestfile.cmake").write_text(tests)
    done = run("""
tests() { ctest --output-junit "$results"; }
part ctest tests || true
part other echo fine""")
    assert done.returncode == 1
    fault = "/src/merge_test.cpp:12: Failure Expected equality of these values:"
    assert f"FAILED:\n  ctest: Merge.keeps_corners: {fault}\n" in last_part(done.stdout)
    assert last_part(done.stdout).endswith("tests: 1 passed, 1 failed, 0 skipped\n")


def test_a_fault_of_a_program_is_told_by_its_log(run):
    done = run("""
builds() { echo 'a.cpp:1: error: no such name'; echo more; return 2; }
part build builds || end_of_parts
part other true""")
    assert done.returncode == 1
    said = last_part(done.stdout)
    assert "FAILED:\n  build: a.cpp:1: error: no such name" in said and "other" not in said


def test_what_passes_alone_is_told_and_does_not_fail(run, tmp_path):
    (tmp_path / "test_window.py").write_text(FLAKY)
    done = run("""
tests() {
  $pytest test_window.py --junitxml "$results" && return
  $pytest test_window.py --junitxml "${results%.xml}-alone.xml"
  /usr/bin/python3 scripts/summary.py --alone "$results" "${results%.xml}-alone.xml"
}
part pytest tests""")
    said = last_part(done.stdout)
    assert done.returncode == 0, said
    assert "passed   pytest: 0 passed, 0 failed, 1 passed alone" in said
    assert "Passed alone:\n  pytest: test_window.py::test_is_in_time" in said and "FAILED" not in said


def test_a_part_that_could_not_run_is_named_and_does_not_fail(run):
    done = run("fuzz() { echo 'There is no libFuzzer.'; return 77; }\npart fuzzers fuzz || true")
    assert done.returncode == 0
    said = last_part(done.stdout)
    assert "not run  fuzzers" in said and "Could not run:\n  fuzzers: There is no libFuzzer." in said


def test_a_script_in_a_script_adds_its_parts(run, tmp_path):
    inner = "set -euo pipefail\n. scripts/parts.sh\npart inner false || true\nend_of_parts\n"
    (tmp_path / "inner").write_text(inner)
    done = run("bash inner || failed=1\npart outer true")
    assert done.returncode == 1
    assert done.stdout.count("parts in") == 1
    assert "FAILED   inner" in last_part(done.stdout) and "passed   outer" in last_part(done.stdout)


def test_quiet_parts_are_a_line_each(run):
    done = run("quiet=1\nloud() { echo much; }\npart loud loud\npart bad false || true")
    assert [line[6:].strip() for line in done.stdout.splitlines()[:2]] == ["passed   loud", "FAILED   bad"]
