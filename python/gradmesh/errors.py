"""What gradmesh raises, with sentences that whoever speaks to the person can translate."""

from __future__ import annotations

from typing import Sequence, Tuple, Union

#: A template with places {0}, {1}, ... and what goes there: texts, or such pairs.
Message = Tuple[str, Sequence[Union[str, "Message"]]]


def said(message: Union[str, Message]) -> str:
    """Returns a message in English."""
    if isinstance(message, str):
        return message
    template, arguments = message
    return template.format(*map(said, arguments))


class InputError(ValueError):
    """Bad input, or a file that cannot be read or written. Its text is one sentence for the person."""

    def __init__(self, message: Message):
        super().__init__(said(message))
        self.message = message


class HelperError(RuntimeError):
    """The program that does the work where the compiled module does not load has failed. Its text is
    one sentence for the person. Documents that were read before are lost, files are as they were."""

    def __init__(self, template: str, *arguments: object):
        self.message: Message = (template, tuple(map(str, arguments)))
        super().__init__(said(self.message))


class NoCoreError(ImportError):
    """There is neither a compiled module nor a program that does the work. Its text is one sentence for the
    person."""

    def __init__(self, template: str, *arguments: object):
        self.message: Message = (template, tuple(map(str, arguments)))
        super().__init__(said(self.message))


def ended() -> HelperError:
    """Returns what is raised where a document's program is no longer there."""
    return HelperError(
        "Nothing was done because gradmesh's helper program has ended; read the document again."
    )
