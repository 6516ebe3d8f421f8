"""The objects of a file and its bytes, in the forms that files have."""

import zlib

from pdf_pages import file_of, stream


class Objects:
    """The objects of a file, in the order of their numbers."""

    def __init__(self):
        self.bodies = []

    def reserve(self):
        self.bodies.append(None)
        return f"{len(self.bodies)} 0 R"

    def set(self, ref, body):
        self.bodies[int(ref.split()[0]) - 1] = body if isinstance(body, bytes) else body.encode("latin-1")

    def add(self, body):
        ref = self.reserve()
        self.set(ref, body)
        return ref

    def stream(self, draft, values, data):
        filter, data = draft.any(FILTERS)(data)
        return self.add(stream(f"{values} {filter}", data))


def plain(data):
    return "", data


def packed(data):
    return "/Filter /FlateDecode", zlib.compress(data)


def hexadecimal(data):
    return "/Filter /ASCIIHexDecode", data.hex().encode() + b">"


FILTERS = {plain: 3, packed: 3, hexadecimal: 1}


def with_stream_of_objects(bodies, root):
    """The bytes of a file whose objects but for streams are packed in one, as PDF 1.5 and later allow."""
    file, rows = bytearray(b"%PDF-1.7\n"), {0: (0, 0, 65535)}
    kept = [number for number, body in enumerate(bodies, 1) if not body.endswith(b"endstream")]
    index, packed_bodies, holder = "", b"", len(bodies) + 1
    for at, number in enumerate(kept):
        index += f"{number} {len(packed_bodies)} "
        packed_bodies += bodies[number - 1] + b"\n"
        rows[number] = 2, holder, at
    values = f"/Type /ObjStm /N {len(kept)} /First {len(index)} /Filter /FlateDecode"
    written = {number: body for number, body in enumerate(bodies, 1) if number not in rows}
    written[holder] = stream(values, zlib.compress(index.encode() + packed_bodies))
    for number, body in written.items():
        rows[number] = 1, len(file), 0
        file += b"%d 0 obj\n%s\nendobj\n" % (number, body)
    table = len(file)
    rows[holder + 1] = 1, table, 0
    data = b"".join(
        kind.to_bytes(1, "big") + place.to_bytes(4, "big") + more.to_bytes(2, "big")
        for _, (kind, place, more) in sorted(rows.items())
    )
    values = f"/Type /XRef /Size {holder + 2} /W [1 4 2] /Root {root} /Filter /FlateDecode"
    file += b"%d 0 obj\n%s\nendobj\n" % (holder + 1, stream(values, zlib.compress(data)))
    return bytes(file) + f"startxref\n{table}\n%%EOF\n".encode()


FILES = {file_of: 3, with_stream_of_objects: 1}
