# SPDX-License-Identifier: GPL-2.0-or-later
"""All that is used of what comes with Inkscape, its package inkex and lxml; no other file imports
either.

These names are there and do the same in every Inkscape from 1.0 to 1.4, and nothing here asks
which one runs. What differs is left alone: a selection in 1.0 is a dictionary, later a list of
elements, and `inkex.base.stdout` is gone since 1.3. So elements are used as lxml's own.
"""

from inkex import (
    AbortExtension,
    Boolean,
    EffectExtension,
    InputExtension,
    OutputExtension,
    errormsg,
)
from inkex.elements import load_svg
from lxml import etree

__all__ = (
    "AbortExtension",
    "Boolean",
    "EffectExtension",
    "InputExtension",
    "OutputExtension",
    "errormsg",
    "etree",
    "load_svg",
)
