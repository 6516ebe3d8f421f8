#!/usr/bin/env python3
"""Writes the inputs of the fuzz target pdf: small documents that have what the reader knows of.

    tests/fuzz/make_pdf_inputs.py
"""

import hashlib
import random
import struct
import zlib
from pathlib import Path

FOLDER = Path(__file__).resolve().parent / "corpus" / "pdf"


def stream(entries, data):
    return b"<< %s /Length %d >>\nstream\n%s\nendstream" % (entries.encode(), len(data), data)


def document(content, resources, objects, page=""):
    """A document of one page; `objects` have the numbers from 5 on."""
    page += f" /Contents 4 0 R /Resources << {resources} >> >>"
    bodies = [
        b"<< /Type /Catalog /Pages 2 0 R >>",
        b"<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
        f"<< /Type /Page /Parent 2 0 R /MediaBox [0 0 99 99] {page}".encode(),
        stream("", content.encode()),
        *objects,
    ]
    text, offsets = b"%PDF-1.7\n", []
    for number, body in enumerate(bodies, 1):
        offsets.append(len(text))
        text += b"%d 0 obj\n%s\nendobj\n" % (number, body)
    table = b"".join(b"%010d 00000 n \n" % offset for offset in offsets)
    size = len(bodies) + 1
    return text + (
        b"xref\n0 %d\n0000000000 65535 f \n%strailer\n<< /Size %d /Root 1 0 R >>\nstartxref\n%d\n%%%%EOF\n"
        % (size, table, size, len(text))
    )


def shading(kind, space, components, records, more="", data=None):
    """A shading whose numbers have 8 bits, of records of so many bytes after the flag, if it has one."""
    rng = random.Random(f"{kind} {space} {records}")
    flags = b"" if kind == 5 else b"\0"
    body = b"".join(flags + rng.randbytes(records) for _ in range(4)) if data is None else data
    decode = "0 90 0 90" + " 0 1" * components
    entries = (
        f"/ShadingType {kind} /ColorSpace {space} /BitsPerCoordinate 8 /BitsPerComponent 8 /BitsPerFlag 8 "
        f"/Decode [{decode}] {more}"
    )
    return stream(entries, body)


def zstandard(data):
    """A frame of one block that is not packed (RFC 8878, 3.1.1), of 256 bytes or more."""
    return struct.pack("<IBH", 0xFD2FB528, 0x60, len(data) - 256) + (len(data) << 3 | 1).to_bytes(3, "little") + data


def documents():
    use = "/Shading << /a 5 0 R >> /Pattern << /p << /PatternType 2 /Shading 5 0 R /Matrix [1 0 0 1 3 4] >> >>"
    paint = "q 1 0 0 1 5 5 cm 0 0 80 80 re W n /a sh Q /Pattern cs /p scn 1 1 m 9 9 8 8 70 70 c h f*"
    yield document(paint, use, [shading(4, "/DeviceGray", 1, 3)])
    yield document(paint, use, [shading(5, "/DeviceRGB", 3, 5, "/VerticesPerRow 2")])
    yield document(paint, use, [shading(6, "/DeviceRGB", 3, 24 + 12)])
    yield document(paint, use, [shading(7, "/DeviceCMYK", 4, 32 + 16)])
    yield document(paint, use, [shading(7, "[/ICCBased 6 0 R]", 3, 32 + 12), stream("/N 3", b"")])
    lab = "[/Lab << /WhitePoint [0.96 1 0.82] /Range [-99 99 -99 99] >>]"
    yield document(paint, use, [shading(6, lab, 3, 24 + 12)])
    cal = "[/CalRGB << /WhitePoint [0.95 1 1.09] /Gamma [2.2 2.2 2.2] /Matrix [0.4 0.2 0 0.3 0.7 0.1 0.2 0.1 0.9] >>]"
    yield document(paint, use, [shading(6, cal, 3, 24 + 12)])
    tint = "<< /FunctionType 2 /Domain [0 1] /C0 [0 0 0 0] /C1 [0 0.5 1 0] /N 1.5 >>"
    yield document(paint, use, [shading(6, f"[/Separation /Orange /DeviceCMYK {tint}]", 1, 24 + 4)])
    code = b"{ 2 copy add 2 div dup 0.5 gt {1 sub neg} if }"
    program = stream("/FunctionType 4 /Domain [0 1 0 1] /Range [0 1 0 1 0 1]", code)
    yield document(paint, use, [shading(7, "[/DeviceN [/A /B] /DeviceRGB 6 0 R]", 2, 32 + 8), program])
    sizes = "/Range [0 1 0 1 0 1] /Size [3] /BitsPerSample 8"
    sampled = stream(f"/FunctionType 0 /Domain [0 1] {sizes}", b"\0\x7f\xff\xff\0\x10abc")
    yield document(paint, use, [shading(6, "/DeviceRGB", 1, 24 + 4, "/Function 6 0 R"), sampled])
    stitched = f"<< /FunctionType 3 /Domain [0 1] /Functions [{tint} {tint}] /Bounds [0.4] /Encode [0 1 1 0] >>"
    yield document(paint, use, [shading(6, "/DeviceCMYK", 1, 24 + 4, f"/Function {stitched}")])
    entries = "/Subtype /Form /BBox [0 0 50 50] /Matrix [1 0 0 1 5 0] /Group << /S /Transparency >>"
    form = stream(entries, b"/a sh /x Do")
    nested = use + " /XObject << /x 6 0 R >> /ExtGState << /m << /ca 0.5 /SMask << /S /Luminosity /G 6 0 R >> >> >>"
    yield document("/m gs /x Do /a sh", nested, [shading(7, "/DeviceRGB", 3, 32 + 12), form], "/Rotate 270 /UserUnit 2")
    record = (FOLDER.parent / "records" / "two_patches").read_bytes()
    coons = shading(6, "/DeviceRGB", 3, 24 + 12)
    beside = "/PieceInfo << /Illustrator << /Private << /AIPrivateData1 6 0 R >> >> >>"
    yield document(paint, use, [coons, stream("", b"%AI24_ZStandard_Data" + zstandard(record))], beside)
    packed = zlib.compress(b"\0" + random.Random(1).randbytes(36) * 3)
    yield document(paint, use, [shading(6, "/DeviceRGB", 3, 0, "/Filter /FlateDecode", packed)])


def main():
    FOLDER.mkdir(exist_ok=True)
    for file in FOLDER.iterdir():
        file.unlink()
    for data in documents():
        (FOLDER / hashlib.sha256(data).hexdigest()[:12]).write_bytes(data)


if __name__ == "__main__":
    main()
