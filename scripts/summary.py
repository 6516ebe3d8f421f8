"""What the parts of a run have come to; called by scripts/parts.sh.

    scripts/summary.py FOLDER [--last | --rest]
    scripts/summary.py --alone RESULTS ALONE

FOLDER holds parts.tsv (name, exit status, seconds) and of each part NAME.log, NAME.xml where its tests
wrote their results (JUnit's XML, of ctest or pytest), and NAME-alone.xml where those that failed were run
again. Prints a line for each part, what could not run and why, and at the end each test that failed, with the
first line of what it said; with --last the line of the last part alone, with --rest all but these lines.
Exit status 1 where a part failed; with --alone unless all tests that failed in RESULTS passed in ALONE.
"""

import re
import sys
import xml.etree.ElementTree as ET
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

NOT_RUN = 77
WIDTH = 240  # of what a failing test said


@dataclass
class Test:
    name: str
    outcome: str  # "passed", "failed" or "skipped"
    said: str  # the first line of why


def first_line(text):
    return next((line.strip() for line in text.splitlines() if line.strip()), "")


def said_by_googletest(output):
    """The place of the first failure and what stands below it; of a crash the last line."""
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    for i, line in enumerate(lines):
        if re.search(r": (Failure|Skipped)$", line):
            return " ".join(lines[i:i + 2])
    return lines[-1] if lines else ""


def test_of(case):
    """The result of an element `testcase`."""
    file, name = case.get("classname", ""), case.get("name", "")
    is_pytest = case.get("status") is None
    full = f"{file.replace('.', '/')}.py::{name}" if is_pytest else name
    for tag, outcome in (("failure", "failed"), ("error", "failed"), ("skipped", "skipped")):
        found = case.find(tag)
        if found is not None:
            said = found.get("message", "")
            if not is_pytest:
                said = said_by_googletest(case.findtext("system-out") or "") or said
            return Test(full, outcome, first_line(said)[:WIDTH])
    return Test(full, "passed", "")


def tests_in(file):
    """The tests of a file of results by name; none where it is not there or was not written to its end."""
    try:
        return {test.name: test for test in map(test_of, ET.parse(file).iter("testcase"))}
    except (OSError, ET.ParseError):
        return {}


def failed_twice(tests, alone):
    """The names of tests that failed, and of these, those that did not pass alone."""
    failed = [name for name, test in tests.items() if test.outcome == "failed"]
    return failed, [name for name in failed if name not in alone or alone[name].outcome != "passed"]


class Part:
    def __init__(self, folder, name, status, seconds):
        self.name, self.status, self.seconds = name, int(status), int(seconds)
        self._log = folder / f"{name}.log"
        self.tests = tests_in(folder / f"{name}.xml")
        failed, twice = failed_twice(self.tests, tests_in(folder / f"{name}-alone.xml"))
        self.passed_alone = [name for name in failed if name not in twice]

    def of(self, outcome):
        return [t for t in self.tests.values() if t.outcome == outcome and t.name not in self.passed_alone]

    @property
    def line(self):
        word = "passed" if self.status == 0 else "not run" if self.status == NOT_RUN else "FAILED"
        counts = [f"{len(self.of(outcome))} {outcome}" for outcome in ("passed", "failed") if self.tests]
        counts += [f"{len(self.of('skipped'))} skipped"] if self.of("skipped") else []
        counts += [f"{len(self.passed_alone)} passed alone"] if self.passed_alone else []
        time = f"{self.seconds // 60:3d}:{self.seconds % 60:02d}"
        return f"{time}  {word:<7}  {self.name}" + (f": {', '.join(counts)}" if counts else "")

    @property
    def not_run(self):
        """Lines that name what could not run, each reason once."""
        if self.status == NOT_RUN:
            yield f"{self.name}: {self._last_line}"
        for reason, count in Counter(t.said for t in self.of("skipped")).items():
            yield f"{self.name}: {count} for this reason: {reason}"

    @property
    def failures(self):
        """Lines that name what failed; where no test did, what the log says of an error."""
        if self.status in (0, NOT_RUN):
            return
        for test in self.of("failed"):
            yield f"{self.name}: {test.name}: {test.said}"
        if not self.of("failed"):
            lines = self._lines
            errors = [line for line in lines if re.search(r"\berror\b|\bFAILED\b|\bFehler\b", line, re.I)]
            for line in (errors or lines[-3:])[:5]:
                yield f"{self.name}: {line.strip()[:WIDTH]}"

    @property
    def _lines(self):
        try:
            return [line for line in self._log.read_text(errors="replace").splitlines() if line.strip()]
        except OSError:
            return []

    @property
    def _last_line(self):
        return self._lines[-1].strip() if self._lines else ""


def show(title, lines):
    lines = list(lines)
    if lines:
        print(f"{title}:")
        print(*(f"  {line}" for line in lines), sep="\n")


def passed_alone(results, alone):
    failed, twice = failed_twice(tests_in(results), tests_in(alone))
    return bool(failed) and not twice


def main(folder, which=None):
    rows = [row.split("\t") for row in (folder / "parts.tsv").read_text().splitlines()]
    if which == "--last":
        print(Part(folder, *rows[-1]).line, flush=True)
        return 0
    parts = [Part(folder, *row) for row in rows]
    if which != "--rest":
        # What a part's own script adds lies within its time.
        whole = [p for p in parts if not any(p.name.startswith(f"{other.name}:") for other in parts)]
        seconds = sum(part.seconds for part in whole)
        print(f"\n== {len(parts)} parts in {seconds // 60}:{seconds % 60:02d} minutes")
        print(*(part.line for part in parts), sep="\n")
    show("Could not run", (line for part in parts for line in part.not_run))
    show("Passed alone", (f"{part.name}: {name}" for part in parts for name in part.passed_alone))
    show("FAILED", (line for part in parts for line in part.failures))
    counts = [sum(len(part.of(outcome)) for part in parts) for outcome in ("passed", "failed", "skipped")]
    print("tests: {} passed, {} failed, {} skipped".format(*counts), flush=True)
    return int(any(part.status not in (0, NOT_RUN) for part in parts))


if __name__ == "__main__":
    if sys.argv[1] == "--alone":
        sys.exit(not passed_alone(*sys.argv[2:]))
    sys.exit(main(Path(sys.argv[1]), *sys.argv[2:]))
