# SPDX-License-Identifier: GPL-2.0-or-later
"""One line of JSON about this run, for scripts, added to the file that GRADMESH_REPORT names.

It is written when the program ends, however it ends, unless it is killed.
"""

import atexit
import dataclasses
import json
import os
import sys
from pathlib import Path

from gradmesh_log import log


class Report:
    """What became of the document, as far as the run has come."""

    def __init__(self):
        self.ids = []  #: of the selected objects
        self.outcome = None  #: "done", "unchanged", "refused"; None is a fault
        self.messages = []  #: what a person was told, or would have been
        self.meshes = []  #: the results of gradmesh.simplify() and others
        self.refused = []  #: the meshes that were left alone as they cannot be read

    def write(self):
        """Adds the line."""
        file = os.environ.get("GRADMESH_REPORT")
        if not file:
            return
        try:
            with open(file, "a", encoding="utf-8") as stream:
                stream.write(json.dumps(self.line()) + "\n")
        except OSError as error:
            log(f"GRADMESH_REPORT: {error}")

    def line(self):
        """Returns what the line says."""
        fault = getattr(sys, "last_value", None)  # it ended the program, and nobody was told
        return {
            "document": os.environ.get("DOCUMENT_PATH", ""),
            "action": action(),
            "ids": self.ids,
            "outcome": self.outcome or "fault",
            "message": "\n".join(self.messages) or (f"{type(fault).__name__}: {fault}" if fault else ""),
            "meshes": [
                *({**members(result), "refused": None} for result in self.meshes),
                *({"id": mesh.id, "refused": str(mesh.refused)} for mesh in self.refused),
            ],
        }


def members(result):
    """Returns the record as a dictionary, without the options of the run."""
    if isinstance(result, dict):
        return result
    return {name: value for name, value in dataclasses.asdict(result).items() if name != "run"}


def action():
    """The name of the item as Inkscape's --actions have it."""
    return Path(sys.argv[0]).stem.replace("gradmesh_", "org.gradmesh.").replace("_", "-")


report = Report()
atexit.register(report.write)
