"""How much less a person waits on more cores: whole runs of the command line."""

import os
import statistics
import tempfile
import time
from pathlib import Path

from measure import ROOT, run_to_end, say
from tables import seconds_text, table

SHARED = ROOT.parent / "shared"
CHELSEA = Path("/usr/lib/python3/dist-packages/skimage/data/chelsea.png")  # Debian's python3-skimage
BALANCED = ("--amount", "balanced")

SAMPLES = ("photo", "face", "fruit", "ellipse")

#: Name -> (command, file, options).
CASES = {
    **{name: ("simplify", ROOT / "samples" / f"{name}.svg", BALANCED) for name in SAMPLES},
    "dense/face": ("simplify", SHARED / "dense" / "face_sampled_41.svg", ("--epsilon", "0.01")),
    "dense/sunset": ("simplify", SHARED / "dense" / "sunset_sampled_41.svg", ("--epsilon", "0.01")),
    "oxygen-juk": ("simplify", SHARED / "real" / "oxygen-juk.svg", BALANCED),
    "suru-disks-app": ("simplify", SHARED / "real" / "suru-disks-app.svg", BALANCED),
    "trace/chelsea": ("trace", CHELSEA, ("--handles", "600")),
    "best/duck": ("simplify", SHARED / "meshes" / "global_duck.hemesh", ("--method", "best", "--epsilon", "0.02")),
}


def counts():
    """The numbers of threads that are compared here."""
    return [n for n in (1, 2, 4, 8, 16) if n <= (os.cpu_count() or 1)]


def run(program, case, threads):
    """The seconds by the clock and of the processor that a run takes, and the bytes it writes."""
    command, file, options = case
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / f"out{'.hemesh' if file.suffix == '.hemesh' else '.svg'}"
        line = [program, command, file, "-o", out, "--threads", threads, "--quiet", *options]
        before, start = os.times(), time.perf_counter()
        run_to_end(line, file.name)
        seconds, after = time.perf_counter() - start, os.times()
        spent = sum(after[2:4]) - sum(before[2:4])
        return seconds, spent, out.read_bytes()


def measured(program, selects, repetitions):
    """Name -> number of threads -> seconds and the processor's, each the least of some runs; or why not."""
    found = {}
    for name, case in CASES.items():
        if not selects(f"threads/{name}"):
            continue
        if not case[1].exists():
            found[name] = f"{case[1].name} is absent"
            continue
        runs = {threads: [] for threads in counts()}
        for _ in range(repetitions):
            for threads, of in runs.items():
                of.append(run(program, case, threads))
        if len({written for of in runs.values() for *_, written in of}) > 1:
            found[name] = "the bytes DIFFER"
            continue
        found[name] = {n: (min(r[0] for r in of), min(r[1] for r in of)) for n, of in runs.items()}
        say(f"threads/{name}: " + ", ".join(f"{n}: {s:.2f} s" for n, (s, _) in found[name].items()))
    return found


def report(found):
    """A table: what one thread takes, how many times as fast more are, and the processor time of the most."""
    several = counts()[1:]
    rows = []
    for name, times in found.items():
        if isinstance(times, str):
            rows.append([name, times, *[""] * (len(several) + 1)])
            continue
        alone = times[1]
        ratios = [f"{alone[0] / times[n][0]:.2f}" for n in several]
        rows.append([name, seconds_text(alone[0]), *ratios, f"{times[counts()[-1]][1] / alone[1]:.2f}"])
    known = [times for times in found.values() if not isinstance(times, str)]
    if known:
        medians = [f"{statistics.median(t[1][0] / t[n][0] for t in known):.2f}" for n in several]
        work = statistics.median(t[counts()[-1]][1] / t[1][1] for t in known)
        rows.append(["median", "", *medians, f"{work:.2f}"])
    return table(["times as fast on", "one thread", *several, "processor time"], rows)
