"""PDF documents that are small enough to be written by hand."""


def square():
    """A shading of type 7: one patch over the square from (0, 0) to (9, 9)."""
    around = [(0, 0), (0, 3), (0, 6), (0, 9), (3, 9), (6, 9), (9, 9), (9, 6), (9, 3), (9, 0), (6, 0), (3, 0)]
    inner = [(3, 3), (3, 6), (6, 6), (6, 3)]
    colors = [(255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 255)]
    return bytes([0]) + b"".join(bytes(each) for each in (*around, *inner, *colors))


def pdf(*contents, private=None):
    """A PDF document with pages of 150 x 75 points; /sh is the square. `private` is what Illustrator would keep beside
    each of them."""
    count = len(contents)
    first = 3 + 2 * count
    kept = f"/PieceInfo << /Illustrator << /Private << /AIPrivateData1 {first + 1} 0 R >> >> >>"
    beside = "" if private is None else kept
    kids = " ".join(f"{3 + 2 * n} 0 R" for n in range(count))
    objects = [b"<< /Type /Catalog /Pages 2 0 R >>", f"<< /Type /Pages /Kids [{kids}] /Count {count} >>".encode()]
    for n, content in enumerate(contents):
        objects.append(
            f"<< /Type /Page /Parent 2 0 R /Contents {4 + 2 * n} 0 R /MediaBox [0 0 150 75]"
            f" /Resources << /Shading << /sh {first} 0 R >> >> {beside} >>".encode()
        )
        objects.append(stream("", content.encode()))
    objects.append(
        stream(
            "/ShadingType 7 /ColorSpace /DeviceRGB /BitsPerCoordinate 8 /BitsPerComponent 8 /BitsPerFlag 8"
            " /Decode [0 255 0 255 0 1 0 1 0 1]",
            square(),
        )
    )
    if private is not None:
        objects.append(stream("", private))
    return file_of(objects)


def document(entries, content, streams=()):
    """A PDF document of one page: what stands in its dictionary, its content, and further streams, each its entries
    and its data, whose objects have the numbers from 5 on."""
    objects = [
        b"<< /Type /Catalog /Pages 2 0 R >>",
        b"<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
        f"<< /Type /Page /Parent 2 0 R /Contents 4 0 R {entries} >>".encode(),
        stream("", content.encode()),
    ]
    return file_of([*objects, *(stream(*each) for each in streams)])


def file_of(objects, root="1 0 R"):
    """The bytes of a file that ends with a table of its objects."""
    file, places = bytearray(b"%PDF-1.7\n"), []
    for number, body in enumerate(objects, 1):
        places.append(len(file))
        file += b"%d 0 obj\n%s\nendobj\n" % (number, body)
    table = len(file)
    file += b"xref\n0 %d\n0000000000 65535 f \n" % (len(objects) + 1)
    file += b"".join(b"%010d 00000 n \n" % place for place in places)
    file += f"trailer\n<< /Size {len(objects) + 1} /Root {root} >>\nstartxref\n{table}\n%%EOF\n".encode()
    return bytes(file)


def stream(entries, data):
    return f"<< {entries} /Length {len(data)} >>\nstream\n".encode() + data + b"\nendstream"
