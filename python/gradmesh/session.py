"""A mesh that a person simplifies by eye: along curves, by hand, and back. The core computes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterable, Optional, Sequence, Tuple

from .api import Document, Result, _result, protecting
from .core import refusal
from .errors import InputError, Message, said


@dataclass(frozen=True)
class View:
    """A part of what a person sees: which place is in the middle of how many pixels, and how large."""

    width: int  #: in pixels
    height: int
    x: float  #: in the units of Session.box
    y: float
    scale: float  #: pixels for each unit


@dataclass(frozen=True)
class Pointed:
    """What a click would do at a place."""

    face: Optional[int] = None  #: the patch there, by its number; None for what is moved
    why_not: Optional[InputError] = None  #: why nothing can be done there
    handles: Optional[int] = None  #: after the click; None where nothing would be done
    patches: Optional[int] = None
    objects: Optional[int] = None
    error: Optional[float] = None
    local_error: Optional[float] = None


class Session:
    """One mesh of a document, which stays as it is until write() is called.

    All that is shown is measured as it will be written. Its curves are found in the background.
    """

    def __init__(self, document: Document, id: Optional[str] = None, **options: Any):
        """id: the object, needed where there are several; options: `metric`, `resolution`, `visible_only`,
        `protect` and `weights`, as of simplify(). Raises InputError and ValueError."""
        self._core = document._core
        self.status = self._core.call("open_session", id=id, **{**options, **protecting(options)})
        self.id: str = self.status["id"]
        #: what the mesh takes up, as (left, top, right, bottom) in the units of the page
        self.box: Tuple[float, float, float, float] = tuple(self.status["box"])

    def _call(self, function: str, **arguments: Any) -> Any:
        return self._core.call(function, id=self.id, **arguments)

    def _change(self, function: str, **arguments: Any) -> dict:
        self.status = {**self.status, **self._call(function, **arguments)}
        return self.status

    def close(self) -> None:
        """Ends the search for curves; the session can be used no more."""
        self._call("close_session")

    def refresh(self, wait: bool = False) -> dict:
        """Returns the status, with what has been found of the curves. wait: until those that are wanted
        are complete."""
        return self._change("session_status", wait=wait)

    def want_curve(self, kind: str) -> dict:
        """Sees to it that a curve is searched for; kind: "one gradient" or "blocks"."""
        return self._change("show_state", kind=kind)

    def show(self, kind: str, state: int, moving: bool = False) -> dict:
        """Shows a state of a curve. moving: whether others follow at once, so that undo() leaves it out."""
        return self._change("show_state", kind=kind, state=state, moving=moving)

    def set_form(self, form: str) -> dict:
        """Makes edits those of "one gradient", whose lines go as a whole, or of "blocks". Raises
        InputError where the mesh is no grid, and where it is smooth and is to be blocks."""
        return self._change("set_session_form", form=form)

    def point(
        self,
        view: View,
        x: float,
        y: float,
        edit: str = "merge",
        fits: bool = True,
        reach: float = 8,
        **how: Any,
    ) -> Optional[Pointed]:
        """Returns what an edit at a pixel would do, which make() then does; None beside the mesh.

        edit: "merge", or "rows", "columns" or "both" to split; "straight" or "curve" for a side of a
        patch; "color" for a point, or "join" to give it one colour again; "move" for a point or a handle.
        fits: whether what is around is fitted to the picture, for which lines and merged patches are;
        a side that becomes a curve always is, and what else is set by hand stays as it is.
        reach: within how many pixels a line or a point is meant.
        how: for "color" the `color`, as SVG writes it, and `sharp`, whether it is that of the patch there
        alone; for "move" `to`, the pixel where it goes.
        """
        if "to" in how:
            how["to_x"], how["to_y"] = how.pop("to")
        arguments = {"pixel_x": x, "pixel_y": y, "edit": edit, "fits": fits, "reach": reach, **how}
        return _pointed(self._call("point_at", **arguments, **vars(view)))

    def propose_merge(self, patches: Iterable[int], fits: bool = True) -> Pointed:
        """Returns what merging patches, by their numbers, to one would do, which make() then does. The error
        is that before the fit. Raises InputError where there is no such patch."""
        return _pointed(self._call("propose_merge", patches=list(patches), fits=fits))

    def make(self) -> dict:
        """Does what was pointed at."""
        return self._change("make_edit")

    def merge(self, patches: Iterable[int], fits: bool = True) -> dict:
        """Merges patches, by their numbers, to one. Raises InputError where that cannot be, as in a smooth
        mesh, and where there is no such patch."""
        return self._change("merge_marked", patches=list(patches), fits=fits)

    def protect(self, patches: Iterable[int], protect: bool = True) -> dict:
        """Lets patches, by their numbers, stay as they are whatever is done, or no longer. The curves are
        then looked for anew. Raises InputError where there is no such patch."""
        return self._change("protect_marked", patches=list(patches), protect=protect)

    def protect_others(self, patches: Iterable[int]) -> dict:
        """Lets only these patches change: protects all others, and releases these."""
        return self._change("protect_marked", patches=list(patches), others=True)

    def weigh(self, patches: Iterable[int], factor: float) -> dict:
        """Lets errors in what patches, by their numbers, cover count so many times, 0.25 to 4, whatever
        patches lie there later; 1: as elsewhere. The curves are then looked for anew. Raises InputError
        where the factor is another, and where there is no such patch."""
        return self._change("weigh_marked", patches=list(patches), factor=factor)

    def fit(self) -> dict:
        """Fits all points and handles to the picture."""
        return self._change("fit_session")

    def undo(self) -> dict:
        return self._change("undo_edit")

    def redo(self) -> dict:
        return self._change("redo_edit")

    @property
    def undo_name(self) -> Optional[str]:
        """What undo() takes back, such as "Merge 2 patches"; None if there is nothing."""
        return _name(self.status["undo"])

    @property
    def redo_name(self) -> Optional[str]:
        """What redo() does again; None if there is nothing."""
        return _name(self.status["redo"])

    def patches_in(
        self, view: View, lasso: Sequence[Tuple[float, float]], touched: bool = False
    ) -> list[int]:
        """Returns the numbers of the patches of which a closed line of pixels surrounds at least a third;
        where there is none, of the one of which it surrounds most. touched: of those that the line touches."""
        return self._call("find_patches", lasso=_flat(lasso), touched=touched, **vars(view))

    def find_out(
        self, kind: str, patch: Optional[int] = None, region: int = 0, fits: bool = True, wait: bool = False
    ) -> dict:
        """Returns what is known of the mesh that is shown, which is found out in the background and forgotten
        as soon as another is shown.

        kind: "prices" (what a click on each line costs, followed by a fit where `fits` is true), "regions"
        (those of a patch that can be merged within the error of Balanced, the largest being 0) or "parts"
        (those of the motorcycle graph). wait: until it is found out.
        The dictionary has `complete`, `failure` (an InputError, or None) and, once it is complete, for prices
        the `scale` and `prices`, a list of {"x", "y", "error"}: the middle of each side inside the mesh, in
        the units of the page, and by how much the error rises, None where nothing can be done; for parts
        `parts` and `limit`, for regions how many `regions` there are and the `region`.
        """
        found = self._call("find_out", kind=kind, patch=patch, region=region, fits=fits, wait=wait)
        return {**found, "failure": refusal(found["failure"])}

    def worst_places(self, most: int = 8) -> list[dict]:
        """Returns where the error is largest, as {"x", "y", "error"} in the units of the page."""
        return self._call("worst_places", most=most)

    def paint(
        self, view: View, lasso: Sequence[Tuple[float, float]] = (), **what: Any
    ) -> Tuple[int, int, bytes]:
        """Returns width, height and the samples red, green, blue of each pixel, row by row.

        lasso: a line of pixels that is drawn over all else.
        what: `ground` ("result", "original", "halves" or "error"), `split` (where the halves meet, 0
        to 1), `lines`, `handles`, `proposal` (whether each is shown), `marked` patches, `known` (what of
        find_out() is shown, with its `patch` and `region`), and `density` (how many pixels lines have for
        each on an ordinary screen).
        """
        picture = self._call("paint_session", lasso=_flat(lasso), **vars(view), **what)
        return picture["width"], picture["height"], picture["bytes"]

    def write(self, remember_original: bool = True, keep_original: bool = False) -> Result:
        """Puts what is shown into the document, exactly as `gradmesh simplify --state` does, and ends the
        session."""
        written = self._call("write_session", remember_original=remember_original, keep_original=keep_original)
        return _result(written)


def _pointed(found: Optional[dict]) -> Optional[Pointed]:
    return None if found is None else Pointed(**{**found, "why_not": refusal(found.get("why_not"))})


def _name(message: Optional[Message]) -> Optional[str]:
    return None if message is None else said(message)


def _flat(places: Sequence[Tuple[float, float]]) -> list[float]:
    return [coordinate for place in places for coordinate in place]
