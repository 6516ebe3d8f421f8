"""Takes needless handles and patches out of gradient meshes, locally, without visible change.

    import gradmesh
    document = gradmesh.load("drawing.svg")
    for result in gradmesh.simplify(document, amount="balanced"):
        print(result.id, result.handles_before, result.handles_after, result.error)
    document.save("simplified.svg")
"""

from .api import (
    Conversion,
    Document,
    MeshInfo,
    Progress,
    Result,
    analyze,
    convert,
    info,
    load,
    loads,
    options,
    save,
    simplify,
)
from .core import core as _core_in_use
from .edits import Edit, Update, join_colors, merge, recolor, refine, to_one_mesh, update
from .errors import HelperError, InputError
from .pages import InsertedPages, PageMesh, insert_pages
from .pictures import compare, differences, draw, render, report
from .publishing import Published, PublishedCode, PublishedSources, publish, publish_code
from .session import Pointed, Session, View
from .tracing import PictureErrors, Tracing, trace, trace_in

# Fails at once where nothing here can compute.
_core_in_use()


def __getattr__(name):
    if name == "__version__":
        return _core_in_use().call("hello")["version"]
    raise AttributeError(f"module 'gradmesh' has no attribute '{name}'")


__all__ = [
    "Conversion",
    "Document",
    "Edit",
    "HelperError",
    "InputError",
    "InsertedPages",
    "MeshInfo",
    "PageMesh",
    "PictureErrors",
    "Pointed",
    "Progress",
    "Published",
    "PublishedCode",
    "PublishedSources",
    "Result",
    "Session",
    "Tracing",
    "Update",
    "View",
    "__version__",
    "analyze",
    "compare",
    "convert",
    "differences",
    "draw",
    "info",
    "insert_pages",
    "join_colors",
    "load",
    "loads",
    "merge",
    "options",
    "publish",
    "publish_code",
    "recolor",
    "refine",
    "render",
    "report",
    "save",
    "simplify",
    "to_one_mesh",
    "trace",
    "trace_in",
    "update",
]
