"""The extension uses of inkex what every Inkscape from 1.0 to 1.4 has (docs/reference/limits.md)."""

import ast
import importlib
import inspect
import sys

import pytest
from lxml import etree

from built import ROOT
from extension_runs import INKEX

LAYER = "gradmesh_inkex"
FILES = sorted((ROOT / "extension").glob("*.py"))

#: Found in inkex of Inkscape 1.0.2, 1.2.2, 1.3 and 1.4, and in what it was between 1.1 and 1.2; of
#: 1.1 itself there was no copy. A name is added only where it is in all of them and does the same.
NAMES = {
    "inkex": {
        "AbortExtension",
        "Boolean",
        "EffectExtension",
        "InputExtension",
        "OutputExtension",
        "errormsg",
    },
    "inkex.elements": {"load_svg"},
    "lxml": {"etree"},
}
#: Members of inkex's classes that ours use, and those that they override or set.
INHERITED = {"options", "svg"}
OVERRIDDEN = {"add_arguments", "document", "effect", "load", "run", "save"}


def trees():
    return {file: ast.parse(file.read_text(), file.name) for file in FILES}


def imports(tree):
    """The modules a file imports, each with the names that it takes from there."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from ((alias.name, None) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from ((node.module, alias.name) for alias in node.names)


def test_one_file_imports_what_inkscape_brings():
    users = {
        file.stem
        for file, tree in trees().items()
        for module, _ in imports(tree)
        if module.split(".")[0] in ("inkex", "lxml")
    }
    assert users == {LAYER}


def test_it_uses_only_what_every_version_has():
    used = {}
    for module, name in imports(trees()[ROOT / "extension" / f"{LAYER}.py"]):
        used.setdefault(module, set()).add(name)
    assert used == NAMES


def attributes_of_self(tree):
    """The names in `self.NAME` and `super().NAME`."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute):
            owner = node.value.func if isinstance(node.value, ast.Call) else node.value
            if isinstance(owner, ast.Name) and owner.id in ("self", "super"):
                yield node.attr


def own_names(tree):
    """The names of methods, and of attributes that a method sets."""
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef):
            yield node.name
        elif isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store):
            yield node.attr


def test_it_uses_only_members_that_every_version_has():
    used = {name for tree in trees().values() for name in attributes_of_self(tree)}
    own = {name for tree in trees().values() for name in own_names(tree)}
    assert used - own == INHERITED


def test_of_the_document_only_what_lxml_has_is_used():
    """An element of inkex has much beside that; it differs from version to version."""
    used = {
        node.attr
        for tree in trees().values()
        for node in ast.walk(tree)
        if isinstance(node, ast.Attribute)
        and isinstance(node.value, ast.Attribute)
        and node.value.attr == "svg"
    }
    assert used and all(hasattr(etree._Element, name) for name in used), used


@pytest.mark.skipif(not INKEX.is_dir(), reason="Inkscape is not installed")
def test_the_installed_inkex_has_it(monkeypatch):
    monkeypatch.syspath_prepend(str(INKEX))
    modules = {module: importlib.import_module(module) for module in NAMES}
    for module, names in NAMES.items():
        assert all(hasattr(modules[module], name) for name in names), module
    source = inspect.getsource(sys.modules["inkex.base"])
    for name in INHERITED | OVERRIDDEN:
        assert f"def {name}(" in source or f"self.{name}" in source, name
