"""A PDF that is small enough to be written by hand."""


def one_patch(private=None):
    """A page that paints a Coons patch of four grays; `private` is what Illustrator would keep beside it."""
    points = (0, 0, 0, 20, 0, 40, 0, 60, 20, 60, 40, 60, 60, 60, 60, 40, 60, 20, 60, 0, 40, 0, 20, 0)
    patch = bytes([0, *points, 0, 90, 180, 250])
    mesh = b"/ShadingType 6 /ColorSpace /DeviceGray /BitsPerFlag 8 /BitsPerCoordinate 8 /BitsPerComponent 8"
    beside = b"" if private is None else b"/PieceInfo << /Illustrator << /Private << /AIPrivateData1 6 0 R >> >> >>"
    bodies = [
        b"<< /Type /Catalog /Pages 2 0 R >>",
        b"<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
        b"<< /Type /Page /Parent 2 0 R /MediaBox [0 0 99 99] /Contents 4 0 R "
        b"/Resources << /Shading << /s 5 0 R >> >> %s >>" % beside,
        stream(b"", b"/s sh"),
        stream(mesh + b" /Decode [0 255 0 255 0 1]", patch),
    ]
    if private is not None:
        bodies.append(stream(b"", private))
    text, table = b"%PDF-1.4\n", b"0000000000 65535 f \n"
    for number, body in enumerate(bodies, 1):
        table += b"%010d 00000 n \n" % len(text)
        text += b"%d 0 obj\n%s\nendobj\n" % (number, body)
    size = len(bodies) + 1
    trailer = b"trailer\n<< /Size %d /Root 1 0 R >>\nstartxref\n%d\n%%%%EOF\n" % (size, len(text))
    return text + b"xref\n0 %d\n" % size + table + trailer


def stream(entries, data):
    return b"<< %s /Length %d >>\nstream\n%s\nendstream" % (entries, len(data), data)
