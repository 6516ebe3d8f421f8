"""The bytes of a document's text, in the encodings and with the declarations that files have."""


def plain(draft, text):
    return text.encode("utf-8")


def declared(draft, text):
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}'.encode("utf-8")


def with_mark(draft, text):
    return f'\ufeff<?xml version="1.0"?>\n{text}'.encode("utf-8")


def sixteen_bits(draft, text):
    return b"\xff\xfe" + f'<?xml version="1.0" encoding="UTF-16"?>\n{text}'.encode("utf-16-le")


def latin(draft, text):
    return f'<?xml version="1.0" encoding="ISO-8859-1"?>\n{text}'.encode("iso-8859-1", "xmlcharrefreplace")


def with_entities(draft, text):
    """Units, names and namespaces are entities, as some programs write them."""
    entities = {"user": "userSpaceOnUse"}
    if draft.maybe(0.3):
        entities["ns_svg"] = "http://www.w3.org/2000/svg"
    for name, value in entities.items():
        text = text.replace(f'"{value}"', f'"&{name};"')
    lines = "".join(f'<!ENTITY {name} "{value}">\n' for name, value in entities.items())
    return f'<?xml version="1.0"?>\n<!DOCTYPE svg [\n{lines}]>\n{text}'.encode("utf-8")


ENCODINGS = {plain: 8, declared: 4, with_mark: 1, sixteen_bits: 1, latin: 1, with_entities: 1}
