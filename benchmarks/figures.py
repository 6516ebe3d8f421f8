"""What measured lines say: how cost grows, ratios to peers, and which goals are reached.

Lines are a dictionary from names to dictionaries with `seconds`, `clock` ("cpu" for one thread,
"wall" for several) and whatever else was counted.
"""

import re
from dataclasses import dataclass
from math import log

#: Seconds of scikit-image's SSIM on the machine on which the programs that are not here, the FLIP
#: reference and the paper authors' own, were timed. It is the bridge to their times.
SKIMAGE_SECONDS = 0.226
SKIMAGE = "skimage/ssim"


@dataclass(frozen=True)
class RatioGoal:
    """How many times as fast a line is to be as a peer, whose one thread is timed by the processor.
    So where a busy machine slows down lines that are timed by the clock, that counts against us."""

    work: str
    ours: str
    peer: str
    goal: float
    #: Seconds of the true peer where scikit-image took SKIMAGE_SECONDS; `peer` is SKIMAGE then.
    bridged: float | None = None

    def value(self, lines):
        """The ratio; None where one of the lines is missing."""
        ours, peer = lines.get(self.ours, {}), lines.get(self.peer, {})
        if "seconds" not in ours or "seconds" not in peer:
            return None
        ratio = peer["seconds"] / ours["seconds"]
        return ratio if self.bridged is None else ratio * self.bridged / SKIMAGE_SECONDS

    def reached(self, value):
        return value >= self.goal

    def text(self, value):
        return f"{value:.3g}x"

    def goal_text(self):
        return f"at least {self.text(self.goal)}"


@dataclass(frozen=True)
class LimitGoal:
    """What a figure of a line may be at most."""

    work: str
    line: str
    key: str
    goal: float
    unit: str = ""

    def value(self, lines):
        return lines.get(self.line, {}).get(self.key)

    def reached(self, value):
        return value <= self.goal

    def text(self, value):
        return f"{value:.3g}{self.unit}"

    def goal_text(self):
        return f"at most {self.text(self.goal)}"


def metric_goals(how, ending):
    """The peers prepare both images every time; an edit is measured against an image that is known."""
    flip = "FLIP 700x700, {}, " + how + ", against its reference program"
    return [
        RatioGoal(flip.format("one thread"), "flip/1-thread" + ending, SKIMAGE, 6, bridged=0.203),
        RatioGoal(flip.format("two threads"), "flip/2-threads" + ending, SKIMAGE, 6, bridged=0.134),
        RatioGoal(
            f"SSIM 700x700, one thread, {how}, against scikit-image",
            "ssim/1-thread" + ending,
            SKIMAGE,
            30,
        ),
    ]


GOALS = [
    RatioGoal(
        "painting Duck, 230 patches, one thread, against cairo",
        "paint/duck/corner-colors",
        "cairo/paint/duck",
        10,
    ),
    *metric_goals("from scratch", "/from-scratch"),
    *metric_goals("the reference image known", ""),
    RatioGoal(
        "a candidate of 2x2 patches on Duck, SSIM, against the whole frame",
        "candidate/ssim",
        "whole-frame/ssim",
        30,
    ),
    RatioGoal(
        "a candidate of 2x2 patches on Duck, FLIP, against the whole frame",
        "candidate/flip",
        "whole-frame/flip",
        30,
    ),
    RatioGoal(
        "equations of one patch, against sample by sample from their definition",
        "assembly/patch",
        "assembly/sample-by-sample",
        4,
    ),
    RatioGoal(
        "gqe on Banana, SSIM 0.005, against the authors' program",
        "method/gqe/banana/ssim",
        SKIMAGE,
        300,
        bridged=285,
    ),
    RatioGoal(
        "gqe on Perfect6, FLIP 0.02, against the authors' program",
        "method/gqe/perfect6/flip",
        SKIMAGE,
        100,
        bridged=320,
    ),
    RatioGoal(
        "a trace of 289 points of a photograph, against scikit-image's SSIM", "trace/whole/289", SKIMAGE, 1 / 25
    ),
    RatioGoal(
        "a trace of 625 points of a photograph, against scikit-image's SSIM", "trace/whole/625", SKIMAGE, 1 / 70
    ),
    LimitGoal("growth of gqe's time with patches, exponent", "growth/gqe/patches", "exponent", 1.3),
    LimitGoal("100 patches, from the command line", "cli/100-patches", "seconds", 0.5, " s"),
    LimitGoal("Duck, from the command line", "cli/duck", "seconds", 5, " s"),
    LimitGoal("1,520 patches, 1000 pixels, from the command line", "cli/1520-patches", "seconds", 30, " s"),
    LimitGoal("its peak of memory", "cli/1520-patches", "megabytes", 300, " MB"),
]


def fitted_exponent(points):
    """The e for which y grows as x ** e, by least squares of the logarithms; at least two x."""
    logs = [(log(x), log(y)) for x, y in points]
    mean_x = sum(x for x, _ in logs) / len(logs)
    mean_y = sum(y for _, y in logs) / len(logs)
    across = sum((x - mean_x) * (y - mean_y) for x, y in logs)
    return across / sum((x - mean_x) ** 2 for x, _ in logs)


def exponents(lines):
    """Of every family `growth/WORK/patches/N` or `growth/WORK/resolution/N` with at least two N:
    {"growth/WORK/patches": {"exponent": ..., "points": [(N, seconds)]}}. Cost is held against
    patches or against pixels, the square of the resolution."""
    families = {}
    for name, line in lines.items():
        match = re.fullmatch(r"(growth/.+/(patches|resolution))/(\d+)", name)
        if match and "seconds" in line:
            families.setdefault(match[1], []).append((int(match[3]), line["seconds"]))
    result = {}
    for family, points in families.items():
        power = 2 if family.endswith("resolution") else 1
        if len(points) > 1:
            exponent = fitted_exponent([(n**power, seconds) for n, seconds in points])
            result[family] = {"exponent": exponent, "points": sorted(points)}
    return result


def judged(lines, growth):
    """Each goal with its value, None where something is missing."""
    known = {**lines, **growth}
    return [(goal, goal.value(known)) for goal in GOALS]
