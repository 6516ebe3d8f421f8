"""Ctrl+C while another program is being talked to."""

from __future__ import annotations

import signal
import threading
from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional


class Interrupts:
    """Holds Ctrl+C back, which otherwise raises between any two steps, such as that by which a message
    is taken from a queue and that by which it is kept. A second Ctrl+C is not held back.

    Only the main thread ever gets Ctrl+C, so in others this does nothing.
    """

    def __init__(self) -> None:
        self._presses = 0
        self._held = False
        self._lets_pass = False
        self._handler: Optional[Callable[[int, Any], Any]] = None

    def __enter__(self) -> Interrupts:
        if threading.current_thread() is threading.main_thread():
            handler = signal.getsignal(signal.SIGINT)
            if callable(handler):
                self._handler = handler
                signal.signal(signal.SIGINT, self._press)
        return self

    def __exit__(self, *_: Any) -> None:
        if self._handler:
            signal.signal(signal.SIGINT, self._handler)
            self.let_go()

    def let_go(self) -> None:
        """Does what Ctrl+C would have done, if it is held: raises KeyboardInterrupt, or what else the
        program has for it."""
        if self._held:
            self._held = False
            self._handler(signal.SIGINT, None)

    @contextmanager
    def allowed(self) -> Iterator[None]:
        """Within this Ctrl+C is not held back, nor is one that has been."""
        try:
            self._lets_pass = True
            self.let_go()
            yield
        finally:
            self._lets_pass = False

    def _press(self, number: int, frame: Any) -> None:
        self._presses += 1
        if self._lets_pass or self._presses > 1:
            self._held = False
            self._handler(number, frame)
        else:
            self._held = True
