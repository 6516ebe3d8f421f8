"""Documents and the meshes in them. Python checks and calls; the core computes."""

from __future__ import annotations

import json
import os
import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING, Callable, Iterable, Optional, Union

from .core import Answers, CoreDocument, core, refusal
from .errors import InputError

if TYPE_CHECKING:
    import numpy

Path = Union[str, os.PathLike]

#: Called with (steps done, steps in all, patches left, error so far, handles left); False cancels
#: the run. Handles are 0 where patches are what is made fewer.
Progress = Callable[[int, int, int, float, int], Optional[bool]]
#: Called with the reason where a device fails.
DeviceLost = Callable[[str], None]


@dataclass(frozen=True)
class MeshInfo:
    """A mesh in a document: an object that it paints, or the mesh of a .hemesh file."""

    id: str  #: of the object; "mesh" in a .hemesh file
    role: Optional[str]  #: "fill" or "stroke": what of the object it paints; None in a .hemesh file
    simplified: bool  #: whether it is a group of blocks that gradmesh wrote
    handles: int  #: what the mesh tool shows of it: corners, and handles of curved sides
    patches: int
    objects: int  #: that paint it: 1, or the blocks of a group
    smooth: bool  #: whether its type is "bicubic": then only whole lines can be taken out
    #: why it cannot be read, which named by its id it raises; then all its counts are 0
    refused: Optional[InputError] = None


@dataclass(frozen=True)
class Result:
    """What became of one mesh."""

    id: str
    handles_before: int  #: as of MeshInfo
    handles_after: int
    patches_before: int
    patches_after: int
    objects: int  #: that it becomes: 1, or the blocks of a group
    changed: bool  #: whether it became simpler
    error: float  #: of what is written, against the mesh as it was, 0 to 1
    local_error: float  #: the largest mean of the same in any window of 32 x 32 pixels
    evaluations: int  #: merges that were painted and measured
    stopped: str  #: "done", "budget", "cancelled", "nothing to merge" or "refused"
    seconds: float
    method: str  #: the one asked for, "lines" where the mesh is smooth, or what was simplest
    renderer: str  #: where merges were priced: the device's name, or "software"
    refused: Optional[InputError] = None  #: why it was left alone: it cannot be read


@dataclass(frozen=True)
class Conversion:
    """A document of one mesh, made of another document."""

    document: Document
    patches: int
    error: float  #: of the new document's mesh against the old one, 0 to 1
    lost_opacity: bool  #: whether the mesh had opacities, which a .hemesh file cannot hold


class Document:
    """An SVG document or a .hemesh file. Made by load() or loads()."""

    def __init__(self, core: CoreDocument):
        self._core = core

    @property
    def ids(self) -> list[str]:
        """Ids of all meshes but hidden originals; they need not be readable; may be empty."""
        return list(dict.fromkeys(self._core.call("ids")))

    @property
    def meshes(self) -> list[MeshInfo]:
        """All meshes; InputError where there is none."""
        found = self._core.call("meshes")
        return [MeshInfo(**{**mesh, "refused": refusal(mesh["refused"])}) for mesh in found]

    def to_bytes(self) -> bytes:
        """The document; the bytes that were read where nothing was changed."""
        return self._core.call("bytes")


def load(path: Path) -> Document:
    """Reads an SVG document or a .hemesh file. Raises InputError, whose text is one sentence for the person."""
    here = core()
    return Document(here.document(here.call("read", path=os.fspath(path))))


def loads(
    data: Union[bytes, str],
    name: str = "document",
    translate: Optional[Callable[[str], str]] = None,
) -> Document:
    """Reads a document of either kind from memory; `name` stands for the file in messages.

    translate: from a text in English, with places such as {0}, to that in which labels and drawings
    are written.
    """
    if isinstance(data, str):
        data = data.encode("utf-8")
    here = core()
    number = here.call("parse", bytes=data, name=name, translated=translate is not None)
    return Document(here.document(number, translate))


def info(document: Document) -> dict:
    """All meshes with their points, handles, faces and half-edges, as `gradmesh info --json`."""
    return json.loads(document._core.call("info"))


def simplify(
    document: Document,
    ids: Union[str, Iterable[str]] = (),
    *,
    method: str = "simplest",
    metric: str = "flip",
    epsilon: float = 0.01,
    max_local_error: Optional[float] = None,
    handles: Optional[int] = None,
    patches: Optional[int] = None,
    ratio: Optional[float] = None,
    count: Optional[str] = None,
    resolution: int = 700,
    color_model: Optional[str] = None,
    visible_only: bool = True,
    seed: int = 0,
    omega: float = 0.75,
    kappa: float = 0.05,
    edges: Iterable[int] = (),
    time_budget: float = 0.0,
    threads: int = 0,
    renderer: str = "auto",
    device_lost: Optional[DeviceLost] = None,
    remember_original: bool = True,
    keep_original: bool = False,
    original: Optional[Document] = None,
    kind: Optional[str] = None,
    preview: bool = False,
    load_analysis: Optional[Path] = None,
    save_analysis: Optional[Path] = None,
    analysis_cache: Optional[Path] = None,
    progress: Optional[Progress] = None,
) -> list[Result]:
    """Simplifies meshes of the document in place and says what became of each.

    ids: objects, or groups that hold them; none: all meshes of the document.
    epsilon: largest error allowed, 0 to 1, by `metric` ("flip" or "ssim", as 1 - SSIM), at
    `resolution` pixels along the mesh's longer side.
    max_local_error: the largest error allowed, beside that, in any window of 32 x 32 pixels, 0 to 1,
    so that a small detail is not given up for calm areas elsewhere. A window that is above it before
    anything is merged stays as it is. With a target there may then be more left than asked for.
    handles, patches, ratio: a target instead of epsilon: at most so many handles, or so many patches, or
    this share (above 0 and at most 1) of what is counted, with as small an error as the method finds.
    count: "handles" or "patches", what is made few. None: what the target is a number of; else handles of
    an SVG document, unless a method other than "plain" is named, and patches of a .hemesh file.
    color_model: "bicubic" (.hemesh only, the default there) or "bilinear"; a .hemesh file's colours
    are then made bilinear first, which counts towards the error.
    visible_only: what the object's outline, clip paths and masks hide of the mesh, its own and those
    of groups around it, does not count towards the error.
    method: "simplest", what leaves less to handle: of a mesh gradient of SVG "plain", or "best" where that
    takes nothing out; "best" where patches are counted, for groups and for .hemesh files. "plain" leaves one
    mesh gradient with few handles: straight sides, fewer lines, points fitted to the picture; only of a
    mesh that is one rectangle, with bilinear colours. Others choose edges that are merged: "random",
    "grid", "dual-grid" and "motorcycle" follow `seed`;
    "motorcycle" keeps edges that cost more than `kappa` times epsilon for the end; "gqe" and
    "gqe1" weigh patches saved against error by `omega`; "best" goes on from "gqe" and fits what it
    merges to the picture; "lines" takes whole rows and columns out of
    a mesh that is one rectangle of patches, which stays one mesh gradient on the same object, and is
    used for smooth meshes whatever else is asked for; "manual" merges the half-edges `edges`, in
    this order, and raises InputError where one of them cannot be merged within epsilon
    and max_local_error.
    time_budget: seconds for each mesh, after which the best so far is kept; 0: no limit.
    threads: 0 for all cores; the result is the same.
    renderer: where merges are priced: "software"; "egl", on the first device that EGL offers; or
    "auto", on a graphics processor where that is expected to be faster. Where a device fails, or there
    is none for "egl", `device_lost` is called with the reason, by default a RuntimeWarning, and it
    goes on in software.
    remember_original: an SVG document keeps the mesh as it was before it was first simplified,
    in a tenth of its bytes, and later runs measure against it until a person edits the mesh. Without,
    files are smaller. One mesh gradient does not begin to remember where the document would be
    larger by that than before.
    keep_original: an SVG document also keeps each object as it was, hidden, directly below the
    result, with an id that ends in "-original". It is left out unless its own id is given.
    original: a document whose meshes those here are measured against, whatever they remember: the only
    mesh in each, or those with the same ids. Two SVG documents share their coordinates, as do two
    .hemesh files; of two kinds, one mesh is laid on the other. It is remembered instead.
    kind: "svg" or "hemesh", the kind of document that this one becomes. If that is not its kind, it holds
    one mesh afterwards, which `ids` names where there are several: that is converted first, towards SVG
    with a part of epsilon where there is no target, and what the conversion costs counts towards the
    error. InputError where epsilon cannot be kept so, or where a .hemesh file would lose opacities. Its
    colours are then bilinear unless color_model says otherwise.
    preview: only say what would become of each; the document stays as it is. With "manual" the
    error is told even where it is too large.
    load_analysis, save_analysis: files, as of analyze(), from which "motorcycle", "gqe", "gqe1" and "best"
    take what is known already, and to which they save what they have used.
    analysis_cache: a folder where each mesh has such a file of its own, found by its content; what is
    damaged there, or cannot be written, is done without.

    Raises InputError (bad input) and ValueError (bad options); the document is then unchanged.
    """
    if not 0 <= seed < 2**64:
        raise ValueError("the seed must be between 0 and 2^64 - 1.")
    edges = list(edges)
    if any(abs(edge) >= 2**31 for edge in edges):
        raise ValueError("the numbers of half-edges are below 2^31.")
    outcome = document._core.call(
        "simplify",
        _answers(progress, device_lost),
        ids=_list(ids),
        metric=metric,
        epsilon=epsilon,
        max_local_error=max_local_error,
        handles=handles,
        patches=patches,
        ratio=ratio,
        count=count,
        resolution=resolution,
        color_model=color_model,
        visible_only=visible_only,
        method=method,
        seed=seed,
        omega=omega,
        kappa=kappa,
        edges=edges,
        time_budget=time_budget,
        threads=threads,
        renderer=renderer,
        remember_original=remember_original,
        keep_original=keep_original,
        preview=preview,
        original=original and original._core,
        kind=kind,
        load_analysis=_path(load_analysis),
        save_analysis=_path(save_analysis),
        analysis_cache=_path(analysis_cache),
    )
    if outcome["document"] is not None:
        made = document._core.core.document(outcome["document"], document._core.translate)
        if not preview:
            document._core = made
    return [Result(**{**mesh, "refused": refusal(mesh["refused"])}) for mesh in outcome["meshes"]]


def analyze(
    document: Document,
    path: Path,
    ids: Union[str, Iterable[str]] = (),
    *,
    metric: str = "flip",
    epsilon: float = 0.01,
    resolution: int = 700,
    color_model: Optional[str] = None,
    threads: int = 0,
    renderer: str = "auto",
    device_lost: Optional[DeviceLost] = None,
    original: Optional[Document] = None,
    load_analysis: Optional[Path] = None,
    progress: Optional[Progress] = None,
) -> int:
    """Prices the edges and regions of meshes for simplify(load_analysis=...); how many there are.

    Changing epsilon, up to that of the analysis, omega or kappa then costs no new pricing. The file
    serves the same meshes with the same metric and resolution. Options and errors as of simplify().
    """
    return document._core.call(
        "analyze",
        _answers(progress, device_lost),
        ids=_list(ids),
        metric=metric,
        epsilon=epsilon,
        resolution=resolution,
        color_model=color_model,
        threads=threads,
        renderer=renderer,
        original=original and original._core,
        load_analysis=_path(load_analysis),
        save_analysis=_path(path),
        analysis_cache=None,
    )


def render(
    document: Document,
    id: Optional[str] = None,
    resolution: int = 700,
    *,
    like_inkscape: bool = False,
    framed_as: Optional[Document] = None,
) -> "numpy.ndarray":
    """Paints one mesh, on white: uint8 array of shape (height, width, 3), sRGB.

    id: of the object that the mesh paints; it may be left out where the document has one mesh only,
    and elsewhere InputError says so.
    like_inkscape: takes Inkscape's point of each pixel instead of the centre; InputError for a
    .hemesh file, whose colours Inkscape cannot paint.
    framed_as: paints the mesh where the other document's, of the same id or the only one, would be
    painted, so that the two pictures can be laid on each other.
    """
    import numpy

    painted = document._core.call(
        "render",
        id=id,
        resolution=resolution,
        like_inkscape=like_inkscape,
        framed_as=framed_as and framed_as._core,
    )
    shape = painted["height"], painted["width"], 3
    return numpy.frombuffer(painted["bytes"], numpy.uint8).reshape(shape).copy()


def compare(reference: "numpy.ndarray", test: "numpy.ndarray", metric: str = "flip") -> float:
    """The error between two pictures as render() returns them, of one size: 0 where they are equal.

    metric: "flip", or "ssim", which is 1 - SSIM. Raises TypeError where an array is not of bytes and
    ValueError where its shape is not (height, width, 3).
    """
    pictures = [memoryview(picture) for picture in (reference, test)]
    if any(picture.format != "B" for picture in pictures):
        raise TypeError("a picture is an array of height x width x 3 bytes.")
    if any(picture.ndim != 3 or picture.shape[2] != 3 for picture in pictures):
        raise ValueError("a picture is an array of height x width x 3 bytes.")
    if pictures[0].shape != pictures[1].shape:
        raise ValueError("the pictures are not of one size.")
    height, width, _channels = pictures[0].shape
    reference, test = (picture.tobytes() for picture in pictures)
    return core().call(
        "compare", width=width, height=height, reference=reference, test=test, metric=metric
    )


def draw(
    document: Document,
    show: str = "edges",
    id: Optional[str] = None,
    *,
    picture: bool = True,
    metric: str = "flip",
    epsilon: float = 0.01,
    kappa: float = 0.05,
    resolution: int = 700,
    threads: int = 0,
    analysis_cache: Optional[Path] = None,
    progress: Optional[Progress] = None,
) -> str:
    """Draws one mesh as an SVG document of its own, in the coordinates of the document it is in.

    show: "edges" with their numbers, "faces" with theirs, "errors" of merging single edges, the
    graph "motorcycle", or "regions": the largest that can be merged within epsilon.
    picture: whether the mesh as it is painted lies behind the lines.
    Other options and errors as of simplify().
    """
    return document._core.call(
        "draw",
        _answers(progress),
        id=id,
        show=show,
        picture=picture,
        metric=metric,
        epsilon=epsilon,
        kappa=kappa,
        resolution=resolution,
        color_model=None,
        threads=threads,
        load_analysis=None,
        save_analysis=None,
        analysis_cache=_path(analysis_cache),
    )


def report(
    before: Document,
    after: Document,
    path: Path,
    id: Optional[str] = None,
    *,
    run: Optional[Path] = None,
    metric: Optional[str] = None,
    epsilon: Optional[float] = None,
    resolution: Optional[int] = None,
    color_model: Optional[str] = None,
    visible_only: bool = True,
    threads: int = 0,
    renderer: str = "auto",
    device_lost: Optional[DeviceLost] = None,
    original: Optional[Document] = None,
    load_analysis: Optional[Path] = None,
    save_analysis: Optional[Path] = None,
    progress: Optional[Progress] = None,
) -> None:
    """Writes a page of HTML that shows one mesh before and after its simplification.

    The page needs no other files: it has both pictures, the map of the error, the patches, what merging
    single edges costs, and the regions that can be merged within epsilon.
    id: of the mesh, in both documents; it may be left out where each has one mesh only.
    run: the file that `gradmesh simplify --report` has written; the page shows the run's options.
    metric, epsilon, resolution, color_model: None for those of the run or, without it, "flip", 0.01, 700
    and the colour model of the mesh.
    progress: as of simplify(); where it returns False the page shows what was priced until then.
    Other options and errors as of simplify(); where this raises no page is written.
    """
    before._core.call(
        "report",
        _answers(progress, device_lost),
        after=after._core,
        path=os.fspath(path),
        id=id,
        run=_path(run),
        metric=metric,
        epsilon=epsilon,
        resolution=resolution,
        color_model=color_model,
        visible_only=visible_only,
        threads=threads,
        renderer=renderer,
        original=original and original._core,
        load_analysis=_path(load_analysis),
        save_analysis=_path(save_analysis),
        analysis_cache=None,
    )


def convert(
    document: Document,
    kind: str,
    id: Optional[str] = None,
    *,
    subdivide: Optional[int] = None,
    epsilon: Optional[float] = None,
    metric: str = "flip",
    resolution: int = 700,
) -> Conversion:
    """Makes a document of the kind "svg" or "hemesh" that holds one mesh of `document`.

    epsilon: towards SVG, which knows no colours but the bilinear mixtures of four, patches are split
    where that is needed for this error, by `metric` at `resolution` pixels along the longer side.
    InputError where it cannot be kept; None: 0.02, or what comes nearest.
    subdivide: instead, every patch is split into this many each way, 1 to 32. `id` may be left out where the
    document has one mesh only.
    """
    made = document._core.call(
        "convert",
        kind=kind,
        id=id,
        subdivide=subdivide,
        epsilon=epsilon,
        metric=metric,
        resolution=resolution,
    )
    held = document._core.core.document(made["document"], document._core.translate)
    return Conversion(**{**made, "document": Document(held)})


def save(document: Document, path: Path) -> None:
    """Writes the document; the file is whole or as it was before."""
    document._core.call("write", path=os.fspath(path))


def _list(ids: Union[str, Iterable[str]]) -> list[str]:
    return [ids] if isinstance(ids, str) else list(ids)


def _path(path: Optional[Path]) -> Optional[str]:
    return None if path is None else os.fspath(path)


def _answers(progress: Optional[Progress], device_lost: Optional[DeviceLost] = None) -> Answers:
    """What answers the questions of a run."""
    counts = ("done", "total", "patches", "error", "handles")

    def tell_progress(question: dict) -> bool:
        answer = progress(*(question[name] for name in counts)) if progress else None
        return answer is None or bool(answer)

    def tell_loss(question: dict) -> None:
        (device_lost or _warn_without_device)(question["reason"])

    return {"progress": tell_progress, "device_lost": tell_loss}


def _warn_without_device(reason: str) -> None:
    warnings.warn(f"{reason}; it goes on in software", RuntimeWarning, stacklevel=2)
