"""Pictures of meshes: painted, compared, drawn, and on a page. Python checks and calls; the core computes."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Iterable, Mapping, Optional, Union

from .api import DeviceLost, Document, Path, Result, TellProgress, _answers, _call
from .core import core

if TYPE_CHECKING:
    import numpy


def render(
    document: Document,
    id: Optional[str] = None,
    resolution: Optional[int] = None,
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

    painted = _call(
        document,
        "render",
        id=id,
        resolution=resolution,
        like_inkscape=like_inkscape,
        framed_as=framed_as,
    )
    shape = painted["height"], painted["width"], 3
    return numpy.frombuffer(painted["bytes"], numpy.uint8).reshape(shape).copy()


def compare(reference: "numpy.ndarray", test: "numpy.ndarray", metric: Optional[str] = None) -> float:
    """The error between two pictures as render() returns them, of one size: 0 where they are equal.

    metric: "flip", the default, or "ssim", which is 1 - SSIM. Raises TypeError where an array is not of bytes and
    ValueError where its shape is not (height, width, 3).
    """
    return core().call("compare", metric=metric, **_pair(reference, test))


def differences(
    reference: "numpy.ndarray", test: "numpy.ndarray", metric: Optional[str] = None
) -> "numpy.ndarray":
    """Where two pictures differ: the error of each pixel, of which compare() returns the mean, as a
    float32 array of shape (height, width).

    metric and errors: as of compare().
    """
    import numpy

    pair = _pair(reference, test)
    errors = core().call("differences", metric=metric, **pair)
    return numpy.frombuffer(errors, "<f4").reshape(pair["height"], pair["width"]).copy()


def _pair(reference: "numpy.ndarray", test: "numpy.ndarray") -> dict[str, Any]:
    pictures = [memoryview(picture) for picture in (reference, test)]
    if any(picture.format != "B" for picture in pictures):
        raise TypeError("a picture is an array of height x width x 3 bytes.")
    if any(picture.ndim != 3 or picture.shape[2] != 3 for picture in pictures):
        raise ValueError("a picture is an array of height x width x 3 bytes.")
    if pictures[0].shape != pictures[1].shape:
        raise ValueError("the pictures are not of one size.")
    height, width, _channels = pictures[0].shape
    return {
        "width": width,
        "height": height,
        "reference": pictures[0].tobytes(),
        "test": pictures[1].tobytes(),
    }


def draw(
    document: Document,
    show: str = "edges",
    id: Optional[str] = None,
    *,
    picture: bool = True,
    metric: Optional[str] = None,
    epsilon: Optional[float] = None,
    kappa: Optional[float] = None,
    resolution: Optional[int] = None,
    threads: Optional[int] = None,
    analysis_cache: Optional[Path] = None,
    progress: Optional[TellProgress] = None,
) -> str:
    """Draws one mesh as an SVG document of its own, in the coordinates of the document it is in.

    show: "edges" with their numbers, "faces" with theirs, "errors" of merging single edges, the
    graph "motorcycle", or "regions": the largest that can be merged within epsilon.
    picture: whether the mesh as it is painted lies behind the lines.
    Other options and errors as of simplify().
    """
    return _call(
        document,
        "draw",
        _answers(progress),
        id=id,
        show=show,
        picture=picture,
        metric=metric,
        epsilon=epsilon,
        kappa=kappa,
        resolution=resolution,
        threads=threads,
        analysis_cache=analysis_cache,
    )


def report(
    before: Document,
    after: Document,
    path: Path,
    id: Optional[str] = None,
    *,
    run: Iterable[Union[Result, Mapping[str, Any]]] = (),
    metric: Optional[str] = None,
    epsilon: Optional[float] = None,
    resolution: Optional[int] = None,
    color_model: Optional[str] = None,
    visible_only: Optional[bool] = None,
    threads: Optional[int] = None,
    renderer: Optional[str] = None,
    device_lost: Optional[DeviceLost] = None,
    original: Optional[Document] = None,
    load_analysis: Optional[Path] = None,
    save_analysis: Optional[Path] = None,
    progress: Optional[TellProgress] = None,
) -> None:
    """Writes a page of HTML that shows one mesh before and after its simplification.

    The page needs no other files: it has both pictures, the map of the error, the patches, what merging
    single edges costs, and the regions that can be merged within epsilon.
    id: of the mesh, in both documents; it may be left out where each has one mesh only.
    run: what simplify() has returned, or the "meshes" of what `gradmesh simplify --report` has written; the
    page shows the run's options.
    metric, epsilon, resolution, color_model: None for those of the run or, without it, the defaults of
    simplify() and the colour model of the mesh.
    progress: as of simplify(); where it returns False the page shows what was priced until then.
    Other options and errors as of simplify(); where this raises no page is written.
    """
    told = [dict(getattr(result, "run", result)) for result in run]
    _call(
        before,
        "report",
        _answers(progress, device_lost),
        after=after,
        path=path,
        id=id,
        run=json.dumps({"meshes": told}) if told else None,
        metric=metric,
        epsilon=epsilon,
        resolution=resolution,
        color_model=color_model,
        visible_only=visible_only,
        threads=threads,
        renderer=renderer,
        original=original,
        load_analysis=load_analysis,
        save_analysis=save_analysis,
    )
