"""Meshes of pictures. Python checks and calls; the core computes."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Callable, List, Mapping, Optional, Sequence, Tuple

from .api import Document, Path, TellProgress, _answers
from .core import core


#: Is shown a picture: its width, its height and its bytes.
Show = Callable[[int, int, bytes], Any]


@dataclass(frozen=True)
class PictureErrors:
    """How a painted mesh differs from a picture, both over white."""

    rmse: float  #: the root of the mean square of the differences, in levels, 0 to 255
    mean: float  #: their mean, in levels
    flip: float  #: 0 to 1


@dataclass(frozen=True)
class Tracing:
    """A mesh gradient in a document that looks like a picture, or like what of it is in a shape."""

    document: Document
    id: str  #: of the object that has the mesh
    image: Optional[str]  #: the id of the image of the document that it was traced from; None for another picture
    handles: int
    patches: int
    rows: int  #: of patches
    columns: int
    errors: PictureErrors
    errors_without_detail: PictureErrors  #: against the picture without what is smaller than `detail`
    unused_guides: int  #: how many of the lines to follow no line of the mesh follows
    stopped: bool  #: whether time, or what `progress` returned, ended it early
    seconds: float
    #: what would help, where the mesh does not look like the picture: a sentence in the document's language
    advice: Optional[str]


def trace(
    picture: Optional[Path] = None,
    *,
    outline: Optional[Tuple[Path, str]] = None,
    handles: Optional[int] = None,
    amount: Optional[str] = None,
    epsilon: Optional[float] = None,
    detail: Optional[float] = None,
    guides: Optional[Sequence[str]] = None,
    weights: Optional[Mapping[str, float]] = None,
    resolution: Optional[int] = None,
    threads: Optional[int] = None,
    time_budget: Optional[float] = None,
    progress: Optional[TellProgress] = None,
) -> Tracing:
    """Makes an SVG document of the size of a picture, with one mesh gradient that looks like it.

    picture: a file, PNG or JPEG, or what else OpenImageIO reads where the program has it. Raises InputError, whose
    text is one sentence for the person, where it cannot be read. With `outline` it may be None: the one picture that
    the document there shows.
    outline: an SVG file and the id of a shape in it, which becomes the mesh: the document is that one. It lies on the
    picture where the file shows one, or else on the page, which the picture fills. Raises InputError where there is no
    such shape, or where it does not lie on the picture. None: the whole picture.
    handles: at most that many, 4 to 100,000; None: 1,000. epsilon: no more handles than this error by FLIP needs,
    0 to 1; None: 0.03. amount: instead, "gentle", "balanced" or "strong", an epsilon that is as visible as what
    simplify() does with each. detail: nothing smaller is followed, in pixels of the picture, 1 or more; None: 1.
    guides: with `outline`, ids of open paths in that file, such as along the rim of a highlight, that lines of the mesh
    follow as far as they can.
    weights: with `outline`, how many times what shapes in that file cover counts when lines are put in and fitted, by
    their ids, 0.25 to 4, as in {"eyes": 4}. The errors that are told, and epsilon, know no weights.
    resolution: the pixels along the longer side at which mesh and picture are compared, 16 or more; None: 700.
    threads: None or 0 for all cores. time_budget: the seconds after which the best mesh so far is taken; None or 0
    for no limit. progress: is called with a Progress, and ends the run with the best mesh so far by returning False.
    Raises ValueError where an option is out of range.
    """
    here = core()
    options = {
        "handles": handles,
        "amount": amount,
        "epsilon": epsilon,
        "detail": detail,
        "guides": guides and list(guides),
        "weights": weights and list(weights.items()),
        "resolution": resolution,
        "threads": threads,
        "time_budget": time_budget,
    }
    if outline is not None:
        file, options["id"] = outline
        options["outline"] = os.fspath(file)
    if picture is not None:
        options["path"] = os.fspath(picture)
    elif outline is None:
        raise TypeError("a picture or an outline is needed")
    made = here.call("trace", _answers(progress), **_given(options))
    return _tracing(made, Document(here.document(made.pop("document"))))


def trace_in(
    document: Document,
    ids: Sequence[str],
    *,
    image: Optional[str] = None,
    progress: Optional[TellProgress] = None,
    show: Optional[Show] = None,
    **options: Any,
) -> List[Tracing]:
    """Makes meshes of pictures that an SVG document shows, in place, and returns what became of each.

    ids: of shapes, each of which becomes a mesh of what of the picture it surrounds; of images, each of which gets a
    mesh of all that is seen of it, in a rectangle directly above. image: the id of the image that the shapes lie on;
    None: the uppermost below each. Linked pictures are looked for in the folders of the document (loads()).
    The options are handles, amount, epsilon, detail, guides, weights, resolution, threads and time_budget, as of
    trace(), for each mesh.
    show: is called some times a second with the width and the height of a picture, and its bytes, three for each
    pixel, row by row: the mesh so far on the picture it is made of.
    Where `progress` returns False the mesh that is at work is taken as it is, and none after it is begun.
    Raises InputError where there is no such object or no picture, where the picture cannot be read, or where a shape
    does not lie on it, and ValueError where an option is out of range; the document is then unchanged.
    """
    options.update(ids=list(ids), image=image)
    answers = dict(_answers(progress))
    if show is not None:
        options["show"] = True
        answers["show"] = lambda told: show(told["width"], told["height"], told["bytes"])
    made = document._core.call("trace_in", answers, **_given(options))
    return [_tracing(each, document) for each in made]


def _given(options: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in options.items() if value is not None}


def _tracing(made: dict[str, Any], document: Document) -> Tracing:
    for name in ("errors", "errors_without_detail"):
        made[name] = PictureErrors(**made[name])
    return Tracing(**made, document=document)
