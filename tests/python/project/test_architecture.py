"""The folders of native/ include themselves and lower ranks only (docs/development/architecture.md)."""

import re
from pathlib import Path

import pytest

from built import ROOT

NATIVE = ROOT / "native"

RANK = {
    "base": 0,
    "files": 1,
    "geom": 1,
    "metric": 1,
    "mesh": 2,
    "form": 3,
    "ops": 3,
    "formats": 4,
    "raster": 4,
    "device": 5,
    "reference": 5,
    "fit": 6,
    "trace": 7,
    "trial": 7,
    "pricing": 8,
    "problem": 9,
    "methods": 10,
    "draw": 11,
    "simplify": 11,
    "report": 12,
    "session": 12,
    "app": 13,
    "service": 14,
    "bindings": 15,
    "helper": 15,
    "window": 15,
    "cli": 16,
}

#: Folders inside of others; "." is for the files of the outer one, which else come before all of these.
INNER = {
    "app": {"document": 0, "pages": 1, "pictures": 2, "runs": 3, "editing": 4, "export": 5},
    "formats": {
        "code": 0, "text": 0, "json": 1, "hemesh": 1, "packed": 1,
        "pdf/bits": 0, "pdf/color": 1, "pdf/shading": 1, "pdf/grid": 2, "pdf/records": 3,
        "pdf/objects": 1, "pdf/text": 2, "pdf/page": 3,
        "svg/xml": 1, "svg/values": 2, "svg/tree": 3, "svg/gradient": 4, "svg/group": 5, "svg/picture": 6,
    },
    "methods": {"merging": 0, "plain": 1, "best": 2, ".": 3},
    "ops": {"merge": 1, "split": 2},
    "window": {"toolkit": 0, "eye": 1, "tools": 2, "view": 3},
}

#: Libraries that only some folders may know.
OWNERS = {
    r"libxml/": {"formats"},
    r"zlib\.h": {"files"},
    r"OpenImageIO/": {"files"},
    r"png\.h": {"files"},
    r"jpeglib\.h|jerror\.h": {"files"},
    r"lcms2\.h": {"files"},
    r"qpdf/": {"formats"},
    r"ft2build\.h": {"formats"},
    r"zstd\.h": {"formats"},
    r"(EGL|GL|GLES\d?|epoxy)/": {"device"},
    r"pybind11/": {"bindings"},
    r"CLI/": {"cli"},
    r"imgui|SDL": {"window"},
    r"nlohmann/": {"formats", "app", "report", "service", "cli"},
    r"tbb/": {"base"},
    r"Eigen/": {"fit"},
    r"glpk\.h": {"methods"},
    r"hwy/": {"metric", "raster", "trace"},
}

SOURCES = sorted(p for p in NATIVE.rglob("*") if p.suffix in {".h", ".cpp"})


def includes(path):
    return re.findall(r'^\s*#\s*include\s*["<]([^">]+)[">]', path.read_text(), re.MULTILINE)


def inner_rank(path):
    """Of a path below native/: the rank among the folders inside its own; -1 where none is named."""
    outer, *inner = Path(path).parent.parts
    return INNER.get(outer, {}).get("/".join(inner) or ".", -1)


def test_every_folder_has_a_rank():
    assert {p.name for p in NATIVE.iterdir() if p.is_dir()} == set(RANK)
    for folder, ranks in INNER.items():
        inside = [p.parent.relative_to(NATIVE / folder) for p in SOURCES if p.is_relative_to(NATIVE / folder)]
        assert {path.as_posix() for path in inside} - {"."} == set(ranks) - {"."}
    assert len(SOURCES) > 50


def test_the_table_of_rooms_is_that_of_the_code():
    page = (ROOT / "docs" / "development" / "architecture.md").read_text()
    rows = re.findall(r"^\| (\d+) \| `(\w+)/` \|", page, re.MULTILINE)
    assert {name: int(rank) for rank, name in rows} == RANK
    rooms = re.search(r"\| room of `app/` \| holds \|\n(.+?)\n\n", page, re.DOTALL)[1]
    assert re.findall(r"^\| `(\w+)/`", rooms, re.MULTILINE) == sorted(INNER["app"], key=INNER["app"].get)
    named = re.findall(r"`((?:app|methods|simplify)/[\w/]+(?:\.cpp|/))`", page)
    assert named and all((NATIVE / path).exists() for path in named)


@pytest.mark.parametrize("path", SOURCES, ids=lambda p: str(p.relative_to(NATIVE)))
@pytest.mark.full(all_but=1)
def test_includes_go_downwards(path):
    folder = path.relative_to(NATIVE).parts[0]
    for include in includes(path):
        target = include.split("/")[0]
        if target in RANK and (NATIVE / include).exists():
            assert target == folder or RANK[target] < RANK[folder], f"{path.name} includes {include}"
            if target == folder and Path(include).parent != path.relative_to(NATIVE).parent:
                assert inner_rank(include) < inner_rank(path.relative_to(NATIVE)), f"{path} includes {include}"
        for pattern, owners in OWNERS.items():
            if re.match(pattern, include):
                assert folder in owners, f"{path.name} includes {include}"


def test_metrics_know_no_meshes():
    for path in (NATIVE / "metric").iterdir():
        assert not any(i.startswith(("mesh/", "geom/")) for i in includes(path) if path.suffix != ".txt")


def test_only_formats_know_the_nodes_of_documents():
    for path in SOURCES:
        if path.relative_to(NATIVE).parts[0] != "formats":
            assert not re.search(r"\bxml[A-Z]\w+|formats/svg/xml/", path.read_text()), path


def test_targets_link_downwards():
    for name, rank in RANK.items():
        text = (NATIVE / name / "CMakeLists.txt").read_text()
        for linked in re.findall(r"gradmesh_(\w+)", text):
            if linked in RANK and linked != name:
                assert RANK[linked] < rank, f"{name} links {linked}"


#: Folders in which coordinates of a stranger's document become places in pictures.
MEASURING = ("draw", "fit", "methods/plain", "raster", "reference", "session", "trace", "trial")

#: What is whole already, in these folders: counts, differences of iterators, constants, and these by their names.
WHOLE = re.compile(
    r"[\w.<>()\[\]-]*size\(\)( / 2)?|sizeof\(.+\)|hn::Lanes\(d\)|.+ - \w+\.begin\(\)|label\.anchor"
    r"|[ikn]|above|along|across|channel|row_padding|(name|label)\.along|first / 2|i % used\.size\(\)"
    r"|2 \* x\.whole|ends|width_|point [/%] width_|.+ >> [18]|quotient \+ \(over % under > 0\)"
)
CONVERSION = re.compile(
    r"(?<![\w:<])int\(|static_cast<(?:int|long|std::(?:int|u?int|s?size|ptrdiff)\w*)>\(|\bstd::int32_t\("
)


def argument(text, start):
    """What stands in the parentheses that open before `start`."""
    depth, end = 1, start
    while depth:
        depth += {"(": 1, ")": -1}.get(text[end], 0)
        end += 1
    return " ".join(text[start : end - 1].split())


def bare_conversions(path):
    """Numbers that may be floating, made whole without bounds: beyond an int's range that is undefined."""
    text = re.sub(r"//.*", "", path.read_text())
    return [a for m in CONVERSION.finditer(text) if not WHOLE.fullmatch(a := argument(text, m.end()))]


def test_coordinates_become_indices_within_bounds():
    """By clamped_int() of base/clamped_int.h: a coordinate may be of any size, or no number at all."""
    for folder in MEASURING:
        for path in SOURCES:
            if path.is_relative_to(NATIVE / folder):
                assert bare_conversions(path) == [], f"{path}: clamped_int() is for numbers that are not whole"


@pytest.mark.parametrize("bad", ["int(first)", "int(std::floor(place.x))", "static_cast<int>(x)", "int(a.y * 4)"])
def test_bare_conversions_are_found(bad, tmp_path):
    (tmp_path / "hidden.cpp").write_text(f"  for (int k = {bad}; k < end; ++k) mark(k);\n")
    assert len(bare_conversions(tmp_path / "hidden.cpp")) == 1


def types_of(path):
    """The types that a file defines, but those in namespaces without a name and in other types."""
    spaces, found = [], set()
    for line in path.read_text().splitlines():
        if space := re.match(r"namespace(?: ([\w:]+))? \{$", line):
            spaces.append(space[1])
        elif line.startswith("}  // namespace"):
            spaces.pop()
        elif None not in spaces:
            kinds = r"(?:class|struct|union|enum class|enum)"
            names = re.findall(rf"^{kinds} (\w+)(?: final)?(?: : .*)?(?: \{{.*)?$", line)
            found.update("::".join([*spaces, name]) for name in names)
    return found


def test_a_name_is_that_of_one_type():
    """C++ forbids two, and a linker takes either (one definition rule)."""
    where = {}
    for path in sorted(NATIVE.rglob("*.h")):
        for name in types_of(path):
            where.setdefault(name, []).append(str(path.relative_to(NATIVE)))
    assert len(where) > 400
    assert {name: paths for name, paths in where.items() if len(paths) > 1} == {}
