"""Meshes of PDF and PostScript in documents that are there already. Python checks and calls; the core computes."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Optional

from .api import Document, Path, TellProgress, _answers
from .core import record, refusal
from .errors import InputError


@dataclass(frozen=True)
class PageMesh:
    """A mesh of a page, and what became of it."""

    id: str  #: of its object
    page: int  #: from 1
    number: int  #: among the meshes that the page paints, from 1
    shadings: int  #: how many of the page it is, more than one for the tiles of a surface
    patches: int  #: that the page has of it
    handles: int  #: that these would have, all joined
    rows: int  #: of the one grid that it became; 0 for a mesh with T-junctions
    columns: int
    smooth: bool  #: whether its colours are smooth
    difference: float  #: FLIP against the page's own patches


@dataclass(frozen=True)
class InsertedPages:
    """What insert_pages() has put into a document."""

    meshes: list[PageMesh]
    left_out: list[InputError]  #: a sentence for all that was not read, or not all of it
    replaced: int  #: how many groups of tiles were replaced
    stopped: bool  #: whether `progress` ended it, so that there may be more meshes


def insert_pages(
    document: Document,
    path: Path,
    *,
    page: Optional[int] = None,
    password: str = "",
    all_layers: bool = False,
    into: str = "",
    replace_tiles: bool = True,
    progress: Optional[TellProgress] = None,
) -> InsertedPages:
    """Puts the meshes of a PDF, or of what load() takes as one, into an SVG document, in place.

    They lie where, and are as large as, they are on their page; a page lies on the document's page of its number, or
    else on the first one, further ones beside it. page, password, all_layers: as of load(). into: the id of a group or
    layer; without it each page becomes a new layer above all else. replace_tiles: whether a mesh takes the place of the
    group of flat paths that looks like it, as Inkscape's own import of the same file makes. progress: is told of pages,
    as Progress.mesh, and of the shadings of each; where it returns False the meshes so far are put in. Raises
    InputError for other documents, and where there is no such page, group or mesh; the document is then unchanged.
    """
    made = document._core.call(
        "insert_pages",
        _answers(progress),
        path=os.fspath(path),
        page=page,
        password=password,
        all_layers=bool(all_layers),
        into=into,
        replace_tiles=bool(replace_tiles),
    )
    return InsertedPages(
        [record(PageMesh, mesh) for mesh in made["meshes"]],
        [refusal(message) for message in made["left_out"]],
        made["replaced"],
        made["stopped"],
    )
