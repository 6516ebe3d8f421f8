"""Takes needless handles and patches out of gradient meshes, locally, without visible change.

    import gradmesh
    document = gradmesh.load("drawing.svg")
    for result in gradmesh.simplify(document, epsilon=0.01):
        print(result.id, result.handles_before, result.handles_after, result.error)
    gradmesh.save(document, "simplified.svg")
"""

from ._core import InputError
from ._core import version as __version__
from .api import (
    Conversion,
    Document,
    MeshInfo,
    Result,
    analyze,
    compare,
    convert,
    draw,
    info,
    load,
    loads,
    render,
    report,
    save,
    simplify,
)
from .edits import Edit, Update, merge, refine, to_one_mesh, update

__all__ = [
    "Conversion",
    "Document",
    "Edit",
    "InputError",
    "MeshInfo",
    "Result",
    "Update",
    "__version__",
    "analyze",
    "compare",
    "convert",
    "draw",
    "info",
    "load",
    "loads",
    "merge",
    "refine",
    "render",
    "report",
    "save",
    "simplify",
    "to_one_mesh",
    "update",
]
