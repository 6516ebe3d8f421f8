"""Colour spaces of shadings."""

from typing import NamedTuple

from .matrices import numbers

SHARE = 0, 1
WHITE, EQUAL_WHITE = "/WhitePoint [0.9505 1 1.089]", "/WhitePoint [1 1 1]"


class Space(NamedTuple):
    text: str  #: the value of /ColorSpace
    ranges: list  #: of each component


def device_rgb(draft):
    return Space("/DeviceRGB", [SHARE] * 3)


def device_gray(draft):
    return Space("/DeviceGray", [SHARE])


def device_cmyk(draft):
    return Space("/DeviceCMYK", [SHARE] * 4)


def cal_gray(draft):
    """With a white that is no colour: poppler tints greys by it."""
    return Space(f"[/CalGray << {EQUAL_WHITE} /Gamma {draft.any({1: 1, 2.2: 2})} >>]", [SHARE])


def cal_rgb(draft):
    matrix = "/Matrix [0.4124 0.2126 0.0193 0.3576 0.7152 0.1192 0.1805 0.0722 0.9505]"
    return Space(f"[/CalRGB << {WHITE} /Gamma [2.2 2.2 2.2] {matrix} >>]", [SHARE] * 3)


def lab(draft):
    return Space(f"[/Lab << {WHITE} /Range [-60 60 -60 60] >>]", [(20, 95), (-40, 40), (-40, 40)])


def icc_based(draft):
    """With a profile that no reader can use, so that the alternate space counts."""
    name, count = draft.any({("/DeviceRGB", 3): 3, ("/DeviceGray", 1): 1, ("/DeviceCMYK", 4): 1})
    ref = draft.objects.stream(draft, f"/N {count} /Alternate {name}", b"no profile")
    return Space(f"[/ICCBased {ref}]", [SHARE] * count)


def separation(draft):
    return tinted(draft, draft.any({"Spot": 2, "Gold#20Ink": 1, "Cyan": 1}))


def separation_all(draft):
    return tinted(draft, "All")


def separation_none(draft):
    return tinted(draft, "None")


def tinted(draft, name):
    alternate, count = draft.any({("/DeviceRGB", 3): 3, ("/DeviceCMYK", 4): 1})
    ends = [[draft.between(0, 1) for _ in range(count)] for _ in range(2)]
    rule = f"/N 1 /C0 [{numbers(*ends[0])}] /C1 [{numbers(*ends[1])}]"
    return Space(f"[/Separation /{name} {alternate} << /FunctionType 2 /Domain [0 1] {rule} >>]", [SHARE])


def device_n(draft):
    rule = draft.any({b"{ 2 copy add 2 div }": 2, b"{ 2 copy mul 1 exch sub }": 1, b"{ 1 exch sub 0.5 }": 1})
    values = "/FunctionType 4 /Domain [0 1 0 1] /Range [0 1 0 1 0 1]"
    ref = draft.objects.stream(draft, values, rule)
    return Space(f"[/DeviceN [/One /Two] /DeviceRGB {ref}]", [SHARE] * 2)


SPACES = {
    device_rgb: 10, device_gray: 1, device_cmyk: 2, cal_gray: 1, cal_rgb: 1.5, lab: 1.5, icc_based: 2,
    separation: 2, separation_all: 1, separation_none: 0.4, device_n: 1.5,
}  # fmt: skip


def space(draft):
    """A colour space, at times by its name in the resources of the content."""
    made = draft.pick(SPACES)(draft)
    if made.text.startswith("[") and draft.maybe("space by name", 0.3):
        return made._replace(text=draft.use("ColorSpace", draft.objects.add(made.text)))
    return made


def add_default_spaces(draft):
    """Adds spaces that stand for the device's to all resources: for what a form paints, poppler takes those of the
    page where the form has none."""
    if draft.maybe("default gray", 0.1):
        draft.default_spaces["DefaultGray"] = f"[/CalGray << {EQUAL_WHITE} /Gamma 2.2 >>]"
    if draft.maybe("default rgb", 0.1):
        draft.default_spaces["DefaultRGB"] = f"[/CalRGB << {WHITE} /Gamma [1 1 1] >>]"
    if draft.maybe("default cmyk", 0.1):
        ref = draft.objects.stream(draft, "/N 4 /Alternate /DeviceCMYK", b"no profile")
        draft.default_spaces["DefaultCMYK"] = f"[/ICCBased {ref}]"
