"""Documents and the meshes in them. Python checks and calls; the core computes."""

from __future__ import annotations

import json
import os
import warnings
from dataclasses import dataclass, field
from typing import Any, Callable, Iterable, Mapping, NamedTuple, Optional, Sequence, Union

from .core import Answers, CoreDocument, core, record, refusal
from .errors import InputError

Path = Union[str, os.PathLike]


class Progress(NamedTuple):
    """How far a run is."""

    done: int  #: steps
    total: int  #: steps
    patches: int  #: left
    error: float  #: so far
    handles: int  #: left; 0 where patches are what is made fewer
    mesh: int = 0  #: which of several meshes is at work, from 0
    meshes: int = 1  #: how many they are


#: Called with how far a run is; False cancels the run.
TellProgress = Callable[[Progress], Optional[bool]]
#: Called with the reason where a device fails.
DeviceLost = Callable[[str], None]


@dataclass(frozen=True)
class MeshInfo:
    """A mesh in a document: an object that it paints, or the mesh of a .hemesh file."""

    id: str  #: of the object; "mesh" in a .hemesh file
    role: Optional[str]  #: "fill" or "stroke": what of the object it paints; None in a .hemesh file
    simplified: bool  #: whether it is a group of blocks that gradmesh wrote
    handles: int = 0  #: what the mesh tool shows of it: corners, and handles of curved sides
    patches: int = 0
    objects: int = 0  #: that paint it: 1, or the blocks of a group
    smooth: bool = False  #: whether its type is "bicubic": then only whole lines can be taken out
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
    protected_patches: int  #: of those after, how many are as they were because they were protected
    changed: bool  #: whether it became simpler
    error: float  #: of what is written, against the mesh as it was, 0 to 1, up to 4 with weights
    #: of the mesh as it was, where it is measured against the picture that it was traced from; else 0
    error_before: float
    local_error: float  #: the largest mean of the same in any window of 32 x 32 pixels
    evaluations: int  #: merges that were painted and measured
    stopped: str  #: "done", "budget", "cancelled", "nothing to merge" or "refused"
    seconds: float
    method: str  #: the one asked for, "lines" where the mesh is smooth, or what was simplest
    renderer: str  #: where merges were priced: the device's name, or "software"
    refused: Optional[InputError] = None  #: why it was left alone: it cannot be read
    #: what `gradmesh simplify --report` writes of it, with the options of the run, for report()
    run: Mapping[str, Any] = field(default_factory=dict, repr=False, compare=False)


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
        return [record(MeshInfo, mesh) for mesh in self._core.call("meshes")]

    @property
    def left_out(self) -> list[InputError]:
        """A sentence for all that was not read, or not all of it, where the document is the meshes of a PDF."""
        return [refusal(message) for message in self._core.call("left_out")]

    def to_bytes(self, over: Optional[bytes] = None) -> bytes:
        """The document; the bytes that were read where nothing was changed.

        over: the SVG document that a program shows, such as Inkscape, which takes over what differs from it: meshes
        that Inkscape would lose from its canvas by that are in user units then.
        """
        return self._core.call("bytes", over=over)

    def save(self, path: Path) -> None:
        """Writes the document; the file is whole or as it was before. In another folder than that of load(),
        links to files are such that they lead to the same ones."""
        self._core.call("write", path=os.fspath(path))


def load(path: Path, page: Optional[int] = None, password: str = "", all_layers: bool = False) -> Document:
    """Reads an SVG document, a .hemesh file, or the meshes of a PDF as an SVG document.

    page: the number of the one page of a PDF that is read, from 1; None for all. password: what the PDF is
    encrypted by. all_layers: whether its layers that are off are read, too. What was found on its pages is in info(),
    as "found" and "left_out". Raises InputError, whose text is one sentence for the person.
    """
    here = core()
    number = here.call("read", path=os.fspath(path), page=page, password=password, all_layers=bool(all_layers))
    return Document(here.document(number))


def loads(
    data: Union[bytes, str],
    name: str = "document",
    translate: Optional[Callable[[str], str]] = None,
    folders: Sequence[Path] = (),
    page: Optional[int] = None,
    password: str = "",
    all_layers: bool = False,
) -> Document:
    """Reads a document of any kind from memory; `name` stands for the file in messages.

    translate: from a text in English, with places such as {0}, to that in which labels and drawings
    are written. folders: where files that the document names are looked for, such as linked
    pictures, one after the other; of load() it is the folder of the file. page, password,
    all_layers: as of load().
    """
    if isinstance(data, str):
        data = data.encode("utf-8")
    here = core()
    number = here.call(
        "parse",
        bytes=data,
        name=name,
        translated=translate is not None,
        folders=[os.fspath(folder) for folder in folders],
        page=page,
        password=password,
        all_layers=bool(all_layers),
    )
    return Document(here.document(number, translate))


def info(document: Document) -> dict:
    """All meshes with their points, handles, faces and half-edges, as `gradmesh info --json`."""
    return json.loads(document._core.call("info"))


def options() -> dict[str, dict]:
    """The options of a run by name, each with its default, None where it depends on the mesh, and what it means.

    Where there are such, "least" and "most" are its bounds, "names" its values, and "methods" those
    that heed it.
    """
    return core().call("options")


def simplify(
    document: Document,
    ids: Union[str, Iterable[str]] = (),
    *,
    amount: Optional[str] = None,
    epsilon: Optional[float] = None,
    max_local_error: Optional[float] = None,
    handles: Optional[int] = None,
    patches: Optional[int] = None,
    ratio: Optional[float] = None,
    method: Optional[str] = None,
    metric: Optional[str] = None,
    resolution: Optional[int] = None,
    time_budget: Optional[float] = None,
    preview: bool = False,
    original: Optional[Document] = None,
    progress: Optional[TellProgress] = None,
    **options: Any,
) -> list[Result]:
    """Simplifies meshes of the document in place and says what became of each.

    ids: objects, or groups that hold them; none: all meshes of the document.
    amount: "gentle", not visible, "balanced", hardly visible, or "strong", visible where one looks closely:
    an epsilon and a max_local_error for the metric.
    epsilon: instead, the largest error allowed, 0 to 1, by `metric` ("flip" or "ssim", as 1 - SSIM), at
    `resolution` pixels along the mesh's longer side.
    max_local_error: the largest error allowed, beside that, in any window of 32 x 32 pixels, 0 to 1,
    so that a small detail is not given up for calm areas elsewhere. A window that is above it before
    anything is merged stays as it is. With a target there may then be more left than asked for.
    handles, patches, ratio: a target instead of epsilon: at most so many handles, or so many patches, or
    this share (above 0 and at most 1) of what is counted, with as small an error as the method finds.
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
    preview: only say what would become of each; the document stays as it is. With "manual" the
    error is told even where it is too large.
    original: a document whose meshes those here are measured against, whatever they remember: the only
    mesh in each, or those with the same ids. Two SVG documents share their coordinates, as do two
    .hemesh files; of two kinds, one mesh is laid on the other, so that a conversion can count towards
    the error. It is remembered instead.
    progress: is called with a Progress, and cancels the run by returning False.

    Other options, by their names; options() lists those of the core with their defaults:

    count: "handles" or "patches", what is made few. None: what the target is a number of; else handles of
    an SVG document, unless a method other than "plain" is named, and patches of a .hemesh file.
    color_model: "bicubic" (.hemesh only, the default there) or "bilinear"; a .hemesh file's colours
    are then made bilinear first, which counts towards the error.
    visible_only: whether what the object's outline, clip paths and masks hide of the mesh, its own and those
    of groups around it, does not count towards the error, as by default.
    seed, omega, kappa, edges: as `method` says.
    threads: 0 for all cores; the result is the same.
    protect: ids of shapes of an SVG document, or polygons, as lists of (x, y) in the units of the page;
    patches of which they cover something stay as they are.
    weights: how many times errors count in what shapes of an SVG document cover, by their ids, 0.25 to 4, as in
    {"eyes": 4}; 1 elsewhere, and where shapes overlap as the last of them says. All errors that are
    bounded and told are then weighted, and merges are priced in software.
    renderer: where merges are priced: "software"; "egl", on the first device that EGL offers; or
    "auto", on a graphics processor where that is expected to be faster. Where a device fails, or there
    is none for "egl", `device_lost` is called with the reason, by default a RuntimeWarning, and it
    goes on in software.
    remember_original: whether an SVG document keeps the mesh as it was before it was first simplified,
    in a tenth of its bytes, as by default, and later runs measure against it until a person edits the mesh.
    Without, files are smaller. One mesh gradient does not begin to remember where the document would be
    larger by that than before.
    keep_original: whether an SVG document also keeps each object as it was, hidden, directly below the
    result, with an id that ends in "-original". It is left out unless its own id is given.
    load_analysis, save_analysis: files, as of analyze(), from which "motorcycle", "gqe", "gqe1" and "best"
    take what is known already, and to which they save what they have used.
    analysis_cache: a folder where each mesh has such a file of its own, found by its content; what is
    damaged there, or cannot be written, is done without.

    Raises InputError (bad input) and ValueError (bad options); the document is then unchanged.
    """
    results = _call(
        document,
        "simplify",
        _answers(progress, options.pop("device_lost", None)),
        ids=_list(ids),
        amount=amount,
        epsilon=epsilon,
        max_local_error=max_local_error,
        handles=handles,
        patches=patches,
        ratio=ratio,
        method=method,
        metric=metric,
        resolution=resolution,
        time_budget=time_budget,
        preview=preview,
        original=original,
        **{**_known(options), **protecting(options)},
    )
    return [_result(told) for told in results]


def _result(told: dict[str, Any]) -> Result:
    return record(Result, {**told, "seconds": told["seconds"]["total"], "run": told})


#: Options of simplify() that are none of the run on a mesh.
_OTHER_OPTIONS = {
    "protect",
    "weights",
    "renderer",
    "remember_original",
    "keep_original",
    "load_analysis",
    "save_analysis",
    "analysis_cache",
}


def _known(given: Mapping[str, Any]) -> dict[str, Any]:
    """The options by name, as the core takes them. Raises TypeError for names that are none, and ValueError
    for numbers beyond those of the core."""
    known = {*options(), *_OTHER_OPTIONS} if given else set()
    for name in given.keys() - known:
        raise TypeError(f"simplify() has no option '{name}'; there are: {', '.join(sorted(known))}")
    if not 0 <= (given.get("seed") or 0) < 2**64:
        raise ValueError("the seed must be between 0 and 2^64 - 1.")
    edges = list(given.get("edges") or ())
    if any(abs(edge) >= 2**31 for edge in edges):
        raise ValueError("the numbers of half-edges are below 2^31.")
    return {**given, "edges": edges}


def protecting(given: Mapping[str, Any]) -> dict[str, Any]:
    """What is protected, as the core takes it: ids, and polygons as lists of x, y, x, y, ..."""
    each = _list(given.get("protect") or ())
    return {
        "protect": [one for one in each if isinstance(one, str)],
        "protect_areas": [[c for point in one for c in point] for one in each if not isinstance(one, str)],
    }


def analyze(
    document: Document,
    path: Path,
    ids: Union[str, Iterable[str]] = (),
    *,
    metric: Optional[str] = None,
    epsilon: Optional[float] = None,
    resolution: Optional[int] = None,
    color_model: Optional[str] = None,
    threads: Optional[int] = None,
    renderer: Optional[str] = None,
    device_lost: Optional[DeviceLost] = None,
    original: Optional[Document] = None,
    load_analysis: Optional[Path] = None,
    progress: Optional[TellProgress] = None,
) -> int:
    """Prices the edges and regions of meshes for simplify(load_analysis=...); how many there are.

    Changing epsilon, up to that of the analysis, omega or kappa then costs no new pricing. The file
    serves the same meshes with the same metric and resolution. Options and errors as of simplify().
    """
    return _call(
        document,
        "analyze",
        _answers(progress, device_lost),
        ids=_list(ids),
        metric=metric,
        epsilon=epsilon,
        resolution=resolution,
        color_model=color_model,
        threads=threads,
        renderer=renderer,
        original=original,
        load_analysis=load_analysis,
        save_analysis=path,
    )


def convert(
    document: Document,
    kind: str,
    id: Optional[str] = None,
    *,
    subdivide: Optional[int] = None,
    epsilon: Optional[float] = None,
    metric: Optional[str] = None,
    resolution: Optional[int] = None,
) -> Conversion:
    """Makes a document of the kind "svg" or "hemesh" that holds one mesh of `document`.

    epsilon: towards SVG, which knows no colours but the bilinear mixtures of four, patches are split
    where that is needed for this error, by `metric` at `resolution` pixels along the longer side.
    InputError where it cannot be kept; None: 0.02, or what comes nearest.
    subdivide: instead, every patch is split into this many each way, 1 to 32. `id` may be left out where the
    document has one mesh only.
    """
    made = _call(
        document,
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
    """Does what Document.save() does."""
    document.save(path)


def _call(document: Document, function: str, answers: Answers = {}, **arguments: Any) -> Any:
    """Returns what a function of the core returns with those arguments that are given; it knows the defaults
    of the others."""
    given = {name: _plain(value) for name, value in arguments.items() if value is not None}
    return document._core.call(function, answers, **given)


def _plain(value: Any) -> Any:
    if isinstance(value, Document):
        return value._core
    return os.fspath(value) if isinstance(value, os.PathLike) else value


def _list(ids: Union[str, Iterable[str]]) -> list[str]:
    return [ids] if isinstance(ids, str) else list(ids)


def _answers(
    progress: Optional[TellProgress], device_lost: Optional[DeviceLost] = None
) -> Answers:
    """What answers the questions of a run."""

    def tell_progress(question: dict) -> bool:
        now = Progress(**{name: question[name] for name in Progress._fields})
        answer = progress(now) if progress else None
        return answer is None or bool(answer)

    def tell_loss(question: dict) -> None:
        (device_lost or _warn_without_device)(question["reason"])

    return {"progress": tell_progress, "device_lost": tell_loss}


def _warn_without_device(reason: str) -> None:
    warnings.warn(f"{reason}; it goes on in software", RuntimeWarning, stacklevel=2)
