"""The folders of native/ include themselves and lower ranks only (docs/architecture.md)."""

import re
from pathlib import Path

import pytest

NATIVE = Path(__file__).resolve().parents[2] / "native"

RANK = {
    "base": 0,
    "geom": 1,
    "metric": 1,
    "mesh": 2,
    "ops": 3,
    "io": 3,
    "raster": 3,
    "fit": 4,
    "error": 5,
    "select": 6,
    "draw": 7,
    "simplify": 7,
    "document": 8,
    "report": 8,
    "bindings": 9,
    "cli": 9,
}

#: Libraries that only some folders may know.
OWNERS = {
    r"libxml/": {"io"},
    r"zlib\.h": {"io"},
    r"OpenImageIO/": {"io"},
    r"(EGL|GL|GLES\d?|epoxy)/": {"raster"},
    r"pybind11/": {"bindings"},
    r"CLI/": {"cli"},
    r"nlohmann/": {"io", "document", "report", "cli"},
    r"tbb/": {"base"},
    r"Eigen/": {"fit"},
    r"glpk\.h": {"select"},
}

SOURCES = sorted(p for p in NATIVE.rglob("*") if p.suffix in {".h", ".cpp"})


def includes(path):
    return re.findall(r'^\s*#\s*include\s*["<]([^">]+)[">]', path.read_text(), re.MULTILINE)


def test_every_folder_has_a_rank():
    assert {p.name for p in NATIVE.iterdir() if p.is_dir()} == set(RANK)
    assert len(SOURCES) > 50


@pytest.mark.parametrize("path", SOURCES, ids=lambda p: str(p.relative_to(NATIVE)))
def test_includes_go_downwards(path):
    folder = path.relative_to(NATIVE).parts[0]
    for include in includes(path):
        target = include.split("/")[0]
        if target in RANK and (NATIVE / include).exists():
            assert target == folder or RANK[target] < RANK[folder], f"{path.name} includes {include}"
        for pattern, owners in OWNERS.items():
            if re.match(pattern, include):
                assert folder in owners, f"{path.name} includes {include}"


def test_metrics_know_no_meshes():
    for path in (NATIVE / "metric").iterdir():
        assert not any(i.startswith(("mesh/", "geom/")) for i in includes(path) if path.suffix != ".txt")


def test_targets_link_downwards():
    for name, rank in RANK.items():
        text = (NATIVE / name / "CMakeLists.txt").read_text()
        for linked in re.findall(r"gradmesh_(\w+)", text):
            if linked in RANK and linked != name:
                assert RANK[linked] < rank, f"{name} links {linked}"
