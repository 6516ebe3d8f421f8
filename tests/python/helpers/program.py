"""Runs of the command line that succeed, or end in one sentence."""

import json

from built import gradmesh


def printed(*arguments, **how):
    """What a run prints that has nothing to complain of."""
    done = gradmesh(*arguments, **how)
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


def refused(*arguments, code=1, **how):
    """The sentence of a run that fails, without the program's name."""
    done = gradmesh(*arguments, **how)
    assert (done.returncode, done.stdout) == (code, "")
    assert done.stderr.startswith("gradmesh: ") and done.stderr.endswith(".\n"), done.stderr
    assert done.stderr.count("\n") == 1, done.stderr
    return done.stderr[len("gradmesh: ") : -1]


def listed(path):
    """What `info` says of a document."""
    return json.loads(printed("info", "--json", path))


def meshes(path):
    """What `info` lists of the meshes of a document."""
    return listed(path)["meshes"]


def simplified(path, out, *options):
    """What the report says of the meshes of a document that is simplified."""
    report = out.with_suffix(".report.json")
    printed("simplify", path, "-o", out, "--report", report, *options)
    return json.loads(report.read_text())["meshes"]


def error(a, b, *options):
    """How far `compare` finds two files apart."""
    return float(printed("compare", a, b, *options))
