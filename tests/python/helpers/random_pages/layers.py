"""Layers of a page: what may be seen or not, as the catalog says."""

from .draft import Layer


def optional_content(draft):
    """The object of a layer, or of what is seen as layers are."""
    if draft.maybe("policy", 0.3):
        policy = draft.any({"/P /AllOn": 1, "/P /AnyOn": 1, "/P /AnyOff": 1, "/P /AllOff": 1, "": 1})
        of = " ".join(new_layer(draft) for _ in range(draft.any({1: 1, 2: 2})))
        return draft.objects.add(f"<< /Type /OCMD {policy} /OCGs [{of}] >>")
    if draft.maybe("expression", 0.25):
        return draft.objects.add(f"<< /Type /OCMD /VE {expression(draft, 2)} >>")
    return new_layer(draft)


def expression(draft, depth):
    kind = draft.any({"/And": 1, "/Or": 1, "/Not": 1})
    count = 1 if kind == "/Not" else 2
    inner = []
    for _ in range(count):
        goes_on = depth > 0 and draft.chance.random() < 0.4
        inner.append(expression(draft, depth - 1) if goes_on else new_layer(draft))
    return f"[{kind} {' '.join(inner)}]"


def new_layer(draft):
    """Poppler does not ask what a usage says: where the page asks, it is what the lists of layers say."""
    if draft.layers and draft.chance.random() < 0.3:
        return draft.chance.choice(draft.layers).ref
    state, shown, is_told = draft.any({"ON": 1, "OFF": 1, "": 2}), "", False
    if draft.maybe("layer usage", 0.25):
        is_told = state != "" and draft.chance.random() < 0.5
        usage = state if is_told else draft.any({"ON": 1, "OFF": 1})
        shown = f"/Usage << /View << /ViewState /{usage} >> >>"
    ref = draft.objects.add(f"<< /Type /OCG /Name (Layer {1 + len(draft.layers)}) {shown} >>")
    draft.layers.append(Layer(ref, state, is_told))
    return ref


def layer(draft, box, write):
    """What is marked as of a layer, among marks of other kinds."""
    opening = f"/OC {draft.use('Properties', optional_content(draft))} BDC"
    body = write()
    if draft.maybe("other tags", 0.4):
        body = draft.any({
            f"/Span BMC\n{body}\nEMC": 1,
            f"/Artifact << /Type /Layout >> BDC\n{body}\nEMC": 1,
            f"/Span BMC EMC /Mark MP\n{body}": 1,
        })  # fmt: skip
    return f"{opening}\n{body}\nEMC"


def catalog_entry(draft):
    """What the catalog says of the layers."""
    if not draft.layers:
        return ""
    lists = {state: " ".join(each.ref for each in draft.layers if each.state == state) for state in ("ON", "OFF")}
    base = "/BaseState /OFF" if draft.maybe("base state off", 0.3) else draft.any({"": 2, "/BaseState /ON": 1})
    everything = " ".join(each.ref for each in draft.layers)
    told = " ".join(each.ref for each in draft.layers if each.is_told)
    events = f"/AS [<< /Event /View /Category [/View] /OCGs [{told}] >>]" if told else ""
    return (
        f"/OCProperties << /OCGs [{everything}] /D << {base} /ON [{lists['ON']}] /OFF [{lists['OFF']}]"
        f" /Order [{everything}] {events} >> >>"
    )
