"""Documents for programs without mesh gradients. Python checks and calls; the core computes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional

from .api import Document
from .core import record, refusal
from .errors import InputError


@dataclass(frozen=True)
class Published:
    """What publish() shows in the place of one mesh."""

    id: str
    shown_as: str  #: "picture", "linear gradient", "colour", or "nothing" where it cannot be read
    width: int  #: of the picture, in pixels; 0 where there is none
    height: int
    bytes: int  #: of the picture's file
    refused: Optional[InputError] = None  #: why it was left alone: it cannot be read


def publish(document: Document, *, scale: float = 2) -> list[Published]:
    """Makes an SVG document one that programs without mesh gradients show as Inkscape does, in place.

    Instead of each mesh its object shows a picture of it, cut by the object's own shape; one colour
    or a linear gradient where that is exact. Blocks become one picture. Everything else stays, but
    for mesh gradients, hidden originals, what gradmesh remembers, and the script by which Inkscape
    has browsers paint meshes.

    scale: most pixels of the pictures for each pixel of the document in its own size, above 0 to
    16; they have fewer where these show the same, and are never longer than the limit on
    resolution. Raises InputError for .hemesh files and
    where no mesh can be read, ValueError for another scale; the document is then unchanged.
    """
    return [record(Published, made) for made in document._core.call("publish", scale=float(scale))]


@dataclass(frozen=True)
class PublishedCode:
    """One mesh as code for apps."""

    id: str
    name: str  #: of the view or the composable; empty where the mesh cannot be read
    source: str  #: a whole file of code
    lost: list[InputError]  #: a sentence for all of the object's look that the code does not hold
    refused: Optional[InputError] = None  #: why there is no code: it cannot be read


@dataclass(frozen=True)
class PublishedSources:
    """The meshes of a document as code for apps."""

    meshes: list[PublishedCode]
    source: str  #: one file of code with all of them


def publish_code(document: Document, language: str) -> PublishedSources:
    """Returns the meshes of an SVG document as code for apps, which paints them by mesh gradients.

    language: "swift" for views of SwiftUI, "compose" for composables of Jetpack Compose, in Kotlin.
    A mesh is as it is seen on the page, cut by its object's shape where that hides some of it. The
    document stays as it is. Raises InputError for .hemesh files and where no mesh can be read,
    ValueError for another language.
    """
    made = document._core.call("publish_code", language=str(language))
    meshes = [
        record(PublishedCode, {**mesh, "lost": list(map(refusal, mesh["lost"]))}) for mesh in made["meshes"]
    ]
    return PublishedSources(meshes, made["source"])
