"""What a person does by hand with single patches and blocks. Python checks and calls; the core computes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Iterable, Optional, Union

from .api import Document, _call, _list


@dataclass(frozen=True)
class Update:
    """What update() has found of one simplified mesh, and how it is now."""

    id: str
    handles: int  #: as of MeshInfo
    patches: int
    objects: int  #: its blocks
    changed: bool  #: whether a person had edited it


@dataclass(frozen=True)
class Edit:
    """What became of a mesh some of whose patches were edited."""

    id: str
    handles_before: int  #: as of MeshInfo
    handles_after: int
    patches_before: int
    patches_after: int
    objects: int  #: that paint it now: 1, or the blocks of a group
    error: float  #: against the original that it remembers, or else the mesh before, 0 to 1


def update(document: Document, ids: Union[str, Iterable[str]] = ()) -> list[Update]:
    """Makes simplified meshes fit together again after a person has edited their blocks.

    What was moved or recoloured stays as it was put, also where other blocks share it; T-junctions
    lie on their curves again, and the blocks' paths grow with the mesh. The mesh as edited is then
    what later runs of simplify() measure against. ids: as of simplify(); objects that are not
    simplified are left alone. Raises InputError where none is, and for .hemesh files.
    """
    return [Update(**found) for found in document._core.call("update", ids=_list(ids))]


def merge(
    document: Document,
    blocks: Iterable[str],
    *,
    metric: Optional[str] = None,
    resolution: Optional[int] = None,
) -> Edit:
    """Makes one patch of all patches of these blocks of a simplified mesh, in place.

    blocks: ids of their paths. Raises InputError, with the reason, where the patches cannot become
    one; the document is then unchanged.
    """
    return Edit(**_call(document, "merge", ids=list(blocks), metric=metric, resolution=resolution))


def refine(
    document: Document,
    id: str,
    *,
    direction: str = "both",
    place: float = 0.5,
    row: Optional[int] = None,
    column: Optional[int] = None,
    whole: bool = False,
    metric: Optional[str] = None,
    resolution: Optional[int] = None,
) -> Edit:
    """Splits patches exactly, in place: of a block of a simplified mesh, or of a rectangular mesh.

    id: of the block's path, or of the object that the mesh paints.
    direction: "rows", "columns" or "both".
    place: where patches are split, from the top and from the left, above 0 and below 1.
    row, column: which patches of the block, from 1; None: all.
    whole: whether the lines go on across the whole mesh; otherwise they end in T-junctions.

    Raises InputError and ValueError; the document is then unchanged.
    """
    if direction not in ("rows", "columns", "both"):
        raise ValueError(f"patches are split into rows, columns or both, not '{direction}'")
    edit = _call(
        document,
        "refine",
        id=id,
        rows=direction != "columns",
        columns=direction != "rows",
        place=place,
        row=row,
        column=column,
        whole=whole,
        metric=metric,
        resolution=resolution,
    )
    return Edit(**edit)


def to_one_mesh(
    document: Document,
    ids: Union[str, Iterable[str]] = (),
    *,
    metric: Optional[str] = None,
    resolution: Optional[int] = None,
) -> list[Edit]:
    """Makes objects with one ordinary mesh gradient of simplified meshes again, in place.

    Every T-junction's line goes on across the mesh, so nothing changes but colours at new points by
    rounding; the errors are against the simplified meshes. Raises InputError, also where none of
    the meshes is simplified; the document is then unchanged.
    """
    edits = _call(document, "to_one_mesh", ids=_list(ids), metric=metric, resolution=resolution)
    return [Edit(**edit) for edit in edits]
