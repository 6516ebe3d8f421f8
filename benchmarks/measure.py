"""Builds the programs and measures lines, our own and the peers'."""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from drawing import cloth
from figures import SKIMAGE

ROOT = Path(__file__).resolve().parents[1]
HERE = Path(__file__).resolve().parent
#: Debian's own, which sees Debian's packages.
PYTHON = "/usr/bin/python3" if Path("/usr/bin/python3").exists() else sys.executable

#: Runs of whole methods are long, and measured once.
LONG = re.compile(r"^(method/|growth/gqe/|pricing/)")
#: What `--quick` leaves out.
NOT_QUICK = re.compile(
    r"^method/(?!.*/(pear|silk)/)|/patches/(400|900|1600)$|/resolution/1[04]00$|^cli/(duck|1520)|^pricing/"
)

#: The paper's meshes, as lines name them, and the files in ../shared/meshes.
PAPER_MESHES = {
    mesh.lower(): file
    for mesh, file in json.loads((ROOT / "scripts" / "paper_numbers.json").read_text())["files"].items()
}


class BenchError(Exception):
    """One sentence for the person."""


def say(text):
    print(text, file=sys.stderr, flush=True)


# --- building ---


def cache(build):
    """The variables of a build folder; none where it is not configured."""
    file = Path(build) / "CMakeCache.txt"
    lines = file.read_text().splitlines() if file.is_file() else []
    return dict(re.findall(r"^(\w+):\w+=(.*)$", "\n".join(lines), re.MULTILINE))


def run_to_end(command, what):
    """What the command prints; where it fails that is shown."""
    done = subprocess.run(
        [str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    if done.returncode != 0:
        say(done.stdout)
        raise BenchError(f"{what} has failed.")
    return done.stdout


def build(source, folder, targets=("gradmesh", "gradmesh_bench"), options=()):
    """Builds the targets for speed, in a folder that may be there already."""
    known = cache(folder)
    if known and (known.get("CMAKE_BUILD_TYPE") != "Release" or known.get("GRADMESH_SANITIZE")):
        raise BenchError(f"{folder} is not a Release build.")
    if not known:
        options = ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", *options]
        if shutil.which("ccache"):
            options += ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"]
    benchmarks = "ON" if "gradmesh_bench" in targets else "OFF"
    configure = ["cmake", "-S", source, "-B", folder, f"-DGRADMESH_BENCHMARKS={benchmarks}"]
    try:
        run_to_end([*configure, *options], f"Configuring {source}")
    except BenchError:
        if cache(folder).get("benchmark_DIR", "").endswith("-NOTFOUND"):
            raise BenchError("Google Benchmark (libbenchmark-dev) is absent.") from None
        raise
    run_to_end(["cmake", "--build", folder, "--target", *targets], f"Building {source}")


# --- Google Benchmark ---


#: How Google Benchmark ends the names of what is timed by the clock.
SEVERAL_THREADS = "/process_time/real_time"


def line_name(benchmark):
    return benchmark.removesuffix(SEVERAL_THREADS)


def native_names(program):
    return run_to_end([program, "--benchmark_list_tests"], f"Listing {program}").split()


def native_line(entry):
    """One repetition as Google Benchmark writes it."""
    if entry.get("error_occurred"):
        return {"left_out": entry["error_message"]}
    wall, cpu = entry["real_time"] / 1e3, entry["cpu_time"] / 1e3
    if entry["run_name"].endswith(SEVERAL_THREADS):
        line = {"seconds": wall, "clock": "wall", "cpu_seconds": cpu}
    else:
        line = {"seconds": 1 / entry["items_per_second"] if "items_per_second" in entry else cpu, "clock": "cpu"}
    if entry.get("label"):
        line["renderer"] = entry["label"]
    counted = ("patches", "left", "evaluations", "error")
    return line | {key: entry[key] for key in counted if key in entry}


def keep_fastest(lines, name, line):
    if name not in lines or line.get("seconds", 0) < lines[name].get("seconds", 0):
        lines[name] = line


def run_native(program, names, repetitions, min_time):
    """Lines by name; of several repetitions, which are mixed up, the fastest counts."""
    if not names:
        return {}
    escaped = [re.sub(r"([.+*?()\[\]{}|^$\\])", r"\\\1", name) for name in names]
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out.json"
        command = [program, f"--benchmark_filter=^({'|'.join(escaped)})$"]
        command += [f"--benchmark_out={out}", "--benchmark_out_format=json"]
        command += [f"--benchmark_min_time={min_time}", f"--benchmark_repetitions={repetitions}"]
        if repetitions > 1:
            command.append("--benchmark_enable_random_interleaving=true")
        if subprocess.run(command, stdout=sys.stderr.fileno()).returncode != 0:
            raise BenchError(f"{program} has failed.")
        entries = json.loads(out.read_text())["benchmarks"]
    lines = {}
    for name in names:  # in their order, which the mixing lost
        for entry in entries:
            if entry["run_name"] == name and entry["run_type"] == "iteration":
                keep_fastest(lines, line_name(name), native_line(entry))
    return lines


def native(program, selects, repetitions, quick):
    """All lines of the program that are selected, and cairo's absence as one."""
    names = native_names(program)
    lines = {}
    if not any(name.startswith("cairo/") for name in names) and selects("cairo/paint"):
        lines["cairo/paint"] = {"left_out": "cairo (libcairo2-dev) was not found by the build"}
    chosen = [name for name in names if selects(line_name(name))]
    min_time = 0.02 if quick else 0.2
    short = [name for name in chosen if not LONG.match(name)]
    lines |= run_native(program, short, repetitions, min_time)
    lines |= run_native(program, [name for name in chosen if LONG.match(name)], 1, min_time)
    return lines


# --- scikit-image ---


def skimage(program, selects, repetitions):
    if not selects(SKIMAGE):
        return {}
    found = subprocess.run([PYTHON, "-c", "import skimage.metrics, PIL"], capture_output=True)
    if found.returncode != 0:
        return {SKIMAGE: {"left_out": "scikit-image (python3-skimage) is absent"}}
    with tempfile.TemporaryDirectory() as folder:
        run_to_end([program, "--image-pair", folder], "Writing the images")
        script = [PYTHON, "-W", "ignore", HERE / "skimage_ssim.py"]
        found = json.loads(run_to_end([*script, folder, repetitions], "scikit-image's SSIM"))
    return {
        SKIMAGE: {
            "seconds": found["cpu_seconds"],
            "clock": "cpu",
            "error": found["error"],
        }
    }


# --- the command line ---


def hand_cases(folder):
    """What a person waits for: name -> (file, options)."""
    for name, rows, columns in (("100-patches", 5, 5), ("1520-patches", 19, 20)):
        (Path(folder) / f"{name}.svg").write_text(cloth(rows, columns))
    flip = ["--metric", "flip", "--method", "gqe"]
    duck = ROOT.parent / "shared" / "meshes" / "global_duck.hemesh"
    return {
        "cli/100-patches": (Path(folder) / "100-patches.svg", [*flip, "--epsilon", "0.01"]),
        "cli/duck": (duck, [*flip, "--epsilon", "0.02"]),
        "cli/1520-patches": (
            Path(folder) / "1520-patches.svg",
            [*flip, "--epsilon", "0.01", "--resolution", "1000"],
        ),
    }


def mesh_cases():
    """gqe on every mesh there is, for revisions without benchmarks of their own."""
    cases = {}
    for name, file in PAPER_MESHES.items():
        path = ROOT.parent / "shared" / "meshes" / f"{file}.hemesh"
        for metric, epsilon in (("ssim", "0.005"), ("flip", "0.02")):
            options = ["--metric", metric, "--epsilon", epsilon, "--method", "gqe"]
            cases[f"cli/gqe/{name}/{metric}"] = (path, options)
    for path in sorted((ROOT / "samples").glob("*.svg")):
        options = ["--metric", "flip", "--epsilon", "0.01", "--method", "gqe"]
        cases[f"cli/gqe/{path.name}/flip"] = (path, options)
    return cases


def run_cli(program, file, options):
    """One run of `gradmesh simplify`, start to finish."""
    if not file.exists():
        return {"left_out": f"{file.name} is absent"}
    with tempfile.TemporaryDirectory() as folder:
        report, out = Path(folder) / "report.json", Path(folder) / f"out{file.suffix}"
        command = [program, "simplify", file, "-o", out, "--report", report, "--quiet", *options]
        start = time.perf_counter()
        child = subprocess.Popen([str(c) for c in command], stderr=subprocess.PIPE, text=True)
        message = child.stderr.read()
        _, status, usage = os.wait4(child.pid, 0)
        seconds = time.perf_counter() - start
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode != 0:
            return {"left_out": message.strip().splitlines()[-1] if message.strip() else "it has failed"}
        meshes = json.loads(report.read_text())["meshes"]
    return {
        "seconds": seconds,
        "clock": "wall",
        "cpu_seconds": usage.ru_utime + usage.ru_stime,
        "patches": sum(mesh["patches_before"] for mesh in meshes),
        "left": sum(mesh["patches_after"] for mesh in meshes),
        "evaluations": sum(mesh["evaluations"] for mesh in meshes),
        "error": max(mesh["error"] for mesh in meshes),
        "megabytes": usage.ru_maxrss / 1024,
    }


def command_line(program, cases, selects, repetitions):
    """Lines of the selected cases; one run is enough where it takes long."""
    lines = {}
    for name, (file, options) in cases.items():
        if not selects(name):
            continue
        for _ in range(repetitions):
            line = run_cli(program, file, options)
            keep_fastest(lines, name, line)
            if "seconds" not in line or line["seconds"] > 10:
                break
        say(f"{name}: {lines[name].get('left_out') or '%.3f s' % lines[name]['seconds']}")
    return lines
