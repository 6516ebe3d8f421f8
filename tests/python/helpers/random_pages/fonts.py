"""Fonts: one of TrueType with three letters that is made here, one of meshes, and one that every reader has."""

import struct

from .matrices import numbers

EM = 1000
#: The letters A, B and O: parts with points, and whether each lies on the curve.
LETTERS = {
    "A": [[(50, 0, 1), (380, 800, 1), (710, 0, 1)], [(250, 150, 1), (500, 150, 1), (380, 500, 1)]],
    "B": [[(80, 0, 1), (80, 800, 1), (450, 800, 1), (700, 600, 0), (450, 400, 1), (750, 200, 0), (450, 0, 1)]],
    "O": [
        [(400, -20, 1), (0, -20, 0), (0, 400, 1), (0, 820, 0), (400, 820, 1), (800, 820, 0), (800, 400, 1)]
        + [(800, -20, 0)],
        [(400, 250, 1), (550, 250, 0), (550, 400, 1), (550, 550, 0), (400, 550, 1), (250, 550, 0), (250, 400, 1)]
        + [(250, 250, 0)],
    ],
}  # fmt: skip
WIDTH = 800


def glyph(parts):
    points = [point for part in parts for point in part]
    xs, ys = [x for x, _, _ in points], [y for _, y, _ in points]
    ends, end = [], -1
    for part in parts:
        end += len(part)
        ends.append(end)
    data = struct.pack(">5h", len(parts), min(xs), min(ys), max(xs), max(ys))
    data += struct.pack(f">{len(ends)}H", *ends) + struct.pack(">H", 0)
    data += bytes(on for _, _, on in points)
    for values in (xs, ys):
        data += struct.pack(f">{len(values)}h", *(b - a for a, b in zip([0, *values], values)))
    return data + b"\0" * (-len(data) % 4)


def character_map():
    """From codes to glyphs, of format 4: the letters one by one."""
    codes = [(ord(letter), 1 + n) for n, letter in enumerate(LETTERS)]
    segments = [*((code, code, index - code) for code, index in codes), (0xFFFF, 0xFFFF, 1)]
    count = len(segments)
    starts, ends, deltas = zip(*segments)
    body = struct.pack(">4H", 2 * count, 8, 2, 2 * count - 8) + struct.pack(f">{count}H", *ends) + b"\0\0"
    body += struct.pack(f">{count}H", *starts) + struct.pack(f">{count}h", *deltas) + b"\0\0" * count
    return struct.pack(">2HHHL", 0, 1, 3, 1, 12) + struct.pack(">3H", 4, len(body) + 6, 0) + body


def true_type():
    """The bytes of a TrueType font with these letters."""
    glyphs = [b"", *map(glyph, LETTERS.values())]
    places = [sum(map(len, glyphs[:n])) for n in range(len(glyphs) + 1)]
    count = len(glyphs)
    tables = {
        b"cmap": character_map(),
        b"glyf": b"".join(glyphs),
        b"head": struct.pack(
            ">LLLLHHqqhhhhHHhhh", 0x10000, 0x10000, 0, 0x5F0F3CF5, 0, EM, 0, 0, 0, -20, 800, 820, 0, 8, 2, 1, 0
        ),
        b"hhea": struct.pack(">LhhhHhhhhhhhhhhhH", 0x10000, 850, -50, 0, WIDTH, 0, 0, 800, 1, *[0] * 7, count),
        b"hmtx": struct.pack(">Hh", WIDTH, 0) * count,
        b"loca": struct.pack(f">{count + 1}L", *places),
        b"maxp": struct.pack(">LHHHHHHHHHHHHHH", 0x10000, count, 16, 2, 0, 0, 1, *[0] * 8),
    }
    head = struct.pack(">LHHHH", 0x10000, len(tables), 64, 2, 16 * len(tables) - 64)
    offset, listed, data = len(head) + 16 * len(tables), b"", b""
    for tag, table in tables.items():
        table += b"\0" * (-len(table) % 4)
        total = sum(struct.unpack(f">{len(table) // 4}L", table)) & 0xFFFFFFFF
        listed += tag + struct.pack(">LLL", total, offset + len(data), len(table))
        data += table
    return head + listed + data


def descriptor(draft):
    data = true_type()
    file = draft.objects.stream(draft, f"/Length1 {len(data)}", data)
    return draft.objects.add(
        "<< /Type /FontDescriptor /FontName /ABCDEF+Letters /Flags 32 /FontBBox [0 -20 800 820] /ItalicAngle 0"
        f" /Ascent 820 /Descent -20 /CapHeight 800 /StemV 100 /FontFile2 {file} >>"
    )


def font(draft):
    """The name of a font, and what writes a text of its letters."""
    if draft.maybe("font of two bytes", 0.25):
        return of_two_bytes(draft)
    if draft.maybe("standard font", 0.15):
        ref = draft.objects.add("<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>")
        return draft.use("Font", ref), lambda text: f"({text})"
    widths = " ".join(str(WIDTH if chr(code) in LETTERS else 0) for code in range(65, 80))
    ref = draft.objects.add(
        "<< /Type /Font /Subtype /TrueType /BaseFont /ABCDEF+Letters /Encoding /WinAnsiEncoding /FirstChar 65"
        f" /LastChar 79 /Widths [{widths}] /FontDescriptor {descriptor(draft)} >>"
    )
    return draft.use("Font", ref), lambda text: f"({text})"


def of_two_bytes(draft):
    """A composite font, in which a glyph is named by its number."""
    inner = draft.objects.add(
        "<< /Type /Font /Subtype /CIDFontType2 /BaseFont /ABCDEF+Letters /CIDToGIDMap /Identity"
        " /CIDSystemInfo << /Registry (Adobe) /Ordering (Identity) /Supplement 0 >>"
        f" /DW {WIDTH} /FontDescriptor {descriptor(draft)} >>"
    )
    ref = draft.objects.add(
        "<< /Type /Font /Subtype /Type0 /BaseFont /ABCDEF+Letters /Encoding /Identity-H"
        f" /DescendantFonts [{inner}] >>"
    )
    order = list(LETTERS)
    return draft.use("Font", ref), lambda text: "<" + "".join(f"{1 + order.index(each):04x}" for each in text) + ">"


def font_of_meshes(draft, write):
    """The name of a font of Type 3 whose one letter, A, is what `write` writes in the square of 100 units."""
    body, resources = draft.content(write)
    glyph = draft.objects.stream(draft, "", f"100 0 d0\n{body}".encode("latin-1"))
    ref = draft.objects.add(
        f"<< /Type /Font /Subtype /Type3 /FontBBox [0 0 100 100] /FontMatrix [{numbers(0.01, 0, 0, 0.01, 0, 0)}]"
        f" /CharProcs << /a {glyph} >> /Encoding << /Type /Encoding /Differences [65 /a] >> /FirstChar 65"
        f" /LastChar 65 /Widths [100] {resources} >>"
    )
    return draft.use("Font", ref)
