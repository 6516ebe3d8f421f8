"""What computes: the compiled module or, where that does not load, the program beside it.

Both offer one method, call(request, ask), with the functions of docs/reference/helper.md.
"""

from __future__ import annotations

import os
import threading
import weakref
from collections import deque
from dataclasses import fields
from importlib import import_module
from typing import Any, Callable, Dict, Mapping, Optional

from .errors import InputError, ended
from .helper import Helper, find_program, no_program

#: The version of the functions that this package calls.
PROTOCOL = 5
#: The name of the environment variable that says what computes: "module" or "helper"; without it,
#: the module where it loads.
CHOICE = "GRADMESH_CORE"

#: What is asked during a call, and what answers: a function of the question.
Answers = Mapping[str, Callable[[Dict[str, Any]], Any]]


class Core:
    """The functions of one module or program."""

    def __init__(self, service: Any):
        self._service = service
        self._released: deque = deque()

    def call(self, function: str, answers: Answers = {}, **arguments: Any) -> Any:
        """Returns what the function returns. Raises InputError, ValueError, TypeError, MemoryError,
        HelperError, and what `answers` raise."""
        request = {"call": function, "arguments": arguments, "release": self._no_longer_used()}

        def ask(question: Dict[str, Any]) -> Any:
            answer = answers.get(question["ask"])
            return answer and answer(question)

        outcome = self._service.call(request, ask)
        return outcome["result"] if "result" in outcome else _raise(outcome)

    def document(self, number: int, translate: Optional[Callable[[str], str]] = None) -> CoreDocument:
        return CoreDocument(self, number, translate)

    @property
    def works(self) -> bool:
        return not getattr(self._service, "has_failed", False)

    def release(self, number: int) -> None:
        """Lets the document of that number be forgotten; may come from anywhere at any time."""
        self._released.append(number)

    def _no_longer_used(self) -> list:
        return [self._released.popleft() for _ in range(len(self._released))]


class CoreDocument:
    """A document that a core holds, as long as this is there."""

    def __init__(self, core: Core, number: int, translate: Optional[Callable[[str], str]]):
        self.core = core
        self.number = number
        self.translate = translate
        weakref.finalize(self, core.release, number).atexit = False

    def call(self, function: str, answers: Answers = {}, **arguments: Any) -> Any:
        """Returns what a function of this document returns. Arguments may be documents, too, and mappings,
        which become lists of pairs, as the objects of JSON have no order."""
        for name, value in arguments.items():
            if isinstance(value, CoreDocument):
                arguments[name] = self._number_of(value)
            elif isinstance(value, Mapping):
                arguments[name] = list(value.items())
        if self.translate is not None:
            answers = {**answers, "translate": lambda question: self.translate(question["text"])}
        return self.core.call(function, answers, document=self.number, **arguments)

    def _number_of(self, other: CoreDocument) -> int:
        if other.core is not self.core:
            raise ended()
        return other.number


_lock = threading.Lock()
_core: Optional[Core] = None


def core() -> Core:
    """Returns the core that reads documents from now on."""
    global _core
    with _lock:
        if _core is None or not _core.works:
            _core = Core(_service())
    return _core


def _service() -> Any:
    """Raises ImportError where there is neither a module that loads and fits nor a program; NoCoreError where
    there is no module at all."""
    choice = os.environ.get(CHOICE) or None
    if choice not in (None, "module", "helper"):
        raise ImportError(f"{CHOICE} is module or helper, not '{choice}'")
    failure: ImportError = no_program()
    if choice != "helper":
        try:
            module = import_module("._core", __package__)
            if module.protocol == PROTOCOL:
                return module.Service()
            failure = ImportError("gradmesh._core is of another version than the rest of the package")
        except ModuleNotFoundError as error:
            failure = failure if error.name == f"{__package__}._core" else error
        except ImportError as error:
            failure = error
    program = find_program() if choice != "module" else None
    if program is None:
        raise failure
    return Helper(program, PROTOCOL)


def _raise(outcome: Dict[str, Any]) -> None:
    kind = outcome.get("error")
    if kind == "input":
        raise InputError(_as_tuples(outcome["message"]))
    errors = {"value": ValueError, "type": TypeError, "memory": MemoryError}
    raise errors.get(kind, RuntimeError)(outcome.get("text"))


def refusal(message: Optional[list]) -> Optional[InputError]:
    """Returns the error that a record holds as a message; None for none."""
    return None if message is None else InputError(_as_tuples(message))


def record(kind: type, values: Dict[str, Any]) -> Any:
    """Returns what the core says of one thing as a record, which may have fewer members."""
    known = {field.name for field in fields(kind)}
    given = {name: value for name, value in values.items() if name in known}
    if "refused" in known:
        given["refused"] = refusal(values["refused"])
    return kind(**given)


def _as_tuples(message: Any) -> Any:
    if isinstance(message, str):
        return message
    template, arguments = message
    return template, tuple(map(_as_tuples, arguments))
