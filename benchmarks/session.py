#!/usr/bin/env python3
"""How long a person waits in Simplify by Eye: drives a session without its window.

    session.py [DOCUMENT ID]       (after scripts/setup; PYTHONPATH=build/python)

Prints processor time of opening, of the first state but one, of the curve past Strong and of all of it, and of
what is known of the mesh, in milliseconds and in units of scikit-image's SSIM at 700 x 700, then the clock's time of
what follows the pointer, at 1000 x 1000 pixels: the median and the longest.
"""

import statistics
import sys
import time
from pathlib import Path

import numpy

import gradmesh
from skimage_ssim import ssim

SAMPLES = Path(__file__).resolve().parents[1] / "samples"
PIXELS = 1000
#: The error of that amount.
STRONG = 0.02


def unit():
    """Milliseconds of processor time of the peer on noise."""
    pictures = numpy.random.default_rng(1).integers(0, 256, (2, 700, 700, 3), dtype=numpy.uint8)
    return min(timed(lambda: ssim(*pictures), time.process_time) for _ in range(3))


def timed(action, clock=time.perf_counter):
    start = clock()
    action()
    return 1000 * (clock() - start)


def curve_of(document, name):
    """The session, and processor time until it was open, until its curve had two states, until it was
    past Strong, and until all."""
    start, times = time.process_time(), []

    def reached():
        times.append(1000 * (time.process_time() - start))

    def wait_for(is_there):
        while not is_there(session.refresh()["curves"]["one gradient"].get("states", [])):
            time.sleep(0.002)
        reached()

    session = gradmesh.Session(document, name)
    reached()
    wait_for(lambda states: len(states) > 1)
    wait_for(lambda states: states[-1]["error"] > STRONG)
    session.refresh(wait=True)
    reached()
    return session, times


def view_of(session):
    left, top, right, bottom = session.box
    scale = PIXELS / max(right - left, bottom - top)
    return gradmesh.View(PIXELS, PIXELS, (left + right) / 2, (top + bottom) / 2, scale)


def pointer(session):
    """Lists of times by what follows the pointer."""
    view, states = view_of(session), session.status["curves"]["one gradient"]["states"]
    times = {name: [] for name in ("slide", "paint", "point at a line", "point at a patch", "click", "undo")}
    for state in range(len(states)):
        times["slide"].append(timed(lambda: session.show("one gradient", state, True)))
        times["paint"].append(timed(lambda: session.paint(view, lines=True)))
    session.show("one gradient", 0)
    found = []
    for x in range(100, PIXELS, 40):
        took = timed(lambda: found.append(session.point(view, x, PIXELS / 2)))
        if found[-1] is None:
            continue
        is_line = found[-1].handles is not None
        times["point at a line" if is_line else "point at a patch"].append(took)
        if is_line:
            times["click"].append(timed(session.make))
            times["undo"].append(timed(session.undo))
    return times


def by_hand(session):
    """What a side, a point and a colour cost before they are set, over all of the picture."""
    view = view_of(session)
    session.show("one gradient", 0)
    edits = {
        "make a side straight": {"edit": "straight"},
        "make a side a curve": {"edit": "curve"},
        "move a point": {"edit": "move", "reach": 60},
        "set a colour": {"edit": "color", "color": "#806040", "reach": 60},
    }
    times = {name: [] for name in edits}
    for place in range(100, PIXELS, 30):
        x, y = place, PIXELS - place
        for name, how in edits.items():
            more = {"to": (x + 5, y + 5)} if how["edit"] == "move" else {}
            found = []
            took = timed(lambda: found.append(session.point(view, x, y, **how, **more)))
            if found[0] is not None and (found[0].handles is not None or found[0].why_not is not None):
                times[name].append(took)
    return times


def main(document=SAMPLES / "fruit.svg", name="pear"):
    one = unit()
    session, times = curve_of(gradmesh.load(document), name)
    print(f"unit {one:.0f} ms; {session.status['before']['patches']} patches")
    for what, took in zip(("open", "first state", "past Strong", "whole curve"), times):
        print(f"{what}: {took:.0f} ms, {took / one:.2f} units")
    session.show("one gradient", 0)
    for what in ("prices", "parts", "regions"):
        took = timed(lambda what=what: session.find_out(what, wait=True), time.process_time)
        print(f"{what}: {took:.0f} ms, {took / one:.2f} units")
    for what, each in {**pointer(session), **by_hand(session)}.items():
        if each:
            print(f"{what}: {statistics.median(each):.0f} ms, at most {max(each):.0f} ms ({len(each)})")


if __name__ == "__main__":
    main(*sys.argv[1:])
