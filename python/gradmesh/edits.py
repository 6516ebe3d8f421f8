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


#: Rows or columns of a block, from 1: one, or the first and the last.
Lines = Union[int, tuple[int, int]]


def merge(
    document: Document,
    blocks: Union[str, Iterable[str]] = (),
    *,
    patches: Iterable[int] = (),
    rows: Optional[Lines] = None,
    columns: Optional[Lines] = None,
    metric: Optional[str] = None,
    resolution: Optional[int] = None,
) -> Edit:
    """Makes one patch of several of a mesh, in place.

    blocks: ids of the paths of blocks, or of a mesh that is one rectangle of patches, all of whose patches
    are merged.
    rows, columns: only these patches of the one block or mesh, as 2 or (2, 3), counted from 1.
    patches: instead, patches by the numbers that draw(document, "faces") shows; `blocks` then names the
    mesh where there are several.

    Raises InputError, with the reason, where the patches cannot become one, and ValueError; the document is
    then unchanged.
    """
    edit = _call(
        document,
        "merge",
        ids=_list(blocks),
        patches=list(patches),
        rows=_ends(rows),
        columns=_ends(columns),
        metric=metric,
        resolution=resolution,
    )
    return Edit(**edit)


def _ends(lines: Optional[Lines]) -> Optional[list[int]]:
    return [lines, lines] if isinstance(lines, int) else lines and list(lines)


def refine(
    document: Document,
    id: Optional[str] = None,
    *,
    patches: Iterable[int] = (),
    direction: str = "both",
    place: float = 0.5,
    row: Optional[int] = None,
    column: Optional[int] = None,
    whole: bool = False,
    metric: Optional[str] = None,
    resolution: Optional[int] = None,
) -> Edit:
    """Splits patches exactly, in place: of a block of a simplified mesh, or of any mesh.

    id: of the block's path, or of a mesh that is one rectangle of patches; it may be left out where the
    document has one mesh only.
    patches: instead of all of them, patches by the numbers that draw(document, "faces") shows, of any mesh.
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
        patches=list(patches),
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


def recolor(
    document: Document,
    points: Union[int, Iterable[int]],
    color: str,
    id: Optional[str] = None,
    *,
    patches: Iterable[int] = (),
    metric: Optional[str] = None,
    resolution: Optional[int] = None,
) -> Edit:
    """Gives patches a colour at points, in place: all around them, or sharply some of them.

    points: their numbers, as of draw(document, "edges") and info(document).
    color: as SVG writes it, such as "#rrggbb" or a name. Opacities stay.
    id: of the mesh; it may be left out where the document has one only.
    patches: those that get the colour, by the numbers that draw(document, "faces") shows; none: all there.

    Where patches have several colours at one point, an SVG document holds the mesh as blocks. What the mesh
    remembers is forgotten, as it is meant to look otherwise: later runs measure against it as it is. Raises
    InputError and ValueError; the document is then unchanged.
    """
    edit = _call(
        document,
        "recolor",
        id=id,
        points=_numbers(points),
        patches=list(patches),
        color=color,
        metric=metric,
        resolution=resolution,
    )
    return Edit(**edit)


def join_colors(
    document: Document,
    points: Union[int, Iterable[int]],
    id: Optional[str] = None,
    *,
    metric: Optional[str] = None,
    resolution: Optional[int] = None,
) -> Edit:
    """Gives all patches around each of the points one colour there again, in place.

    That is the mean of theirs or, at a T-junction, the colour of the curve on which it lies. Arguments and
    errors as of recolor().
    """
    edit = _call(
        document, "join_colors", id=id, points=_numbers(points), metric=metric, resolution=resolution
    )
    return Edit(**edit)


def _numbers(points: Union[int, Iterable[int]]) -> list[int]:
    return [points] if isinstance(points, int) else list(points)


def to_one_mesh(
    document: Document,
    ids: Union[str, Iterable[str]] = (),
    *,
    metric: Optional[str] = None,
    resolution: Optional[int] = None,
) -> list[Edit]:
    """Makes ordinary meshes of simplified ones, in place: objects with one mesh gradient of blocks again.

    Every T-junction's line goes on across the mesh, so nothing changes but colours at new points by
    rounding; the errors are against the simplified meshes. A .hemesh file holds the mesh without T-junctions.
    Raises InputError, also where none of the meshes is simplified; the document is then unchanged.
    """
    edits = _call(document, "to_one_mesh", ids=_list(ids), metric=metric, resolution=resolution)
    return [Edit(**edit) for edit in edits]
