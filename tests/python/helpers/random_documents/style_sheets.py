"""The rules of a document: what selects an element, and the sheets that hold the rules."""

from xml.sax.saxutils import escape

from .markup import in_selector

# --- selectors: each returns a selector, and what lies around the element that it selects ---


def of_id(draft, tag, values):
    return f"#{in_selector(values['id'])}", "{}"


def of_class(draft, tag, values):
    values["class"] = draft.pick({"k": 3, "other k": 1, "k-2_b": 1})
    return "." + values["class"].split()[-1], "{}"


def of_element(draft, tag, values):
    return tag, "{}"


def of_all(draft, tag, values):
    return "*", "{}"


def of_element_and_class(draft, tag, values):
    selector, around = of_class(draft, tag, values)
    return tag + selector, around


def of_descendant(draft, tag, values):
    return f".outer {tag}", '<g class="outer"><g>{}</g></g>'


def of_child(draft, tag, values):
    return draft.pick({f".outer > {tag}": 1, f"g.outer>{tag}": 1}), '<g class="outer">{}</g>'


def of_neighbour(draft, tag, values):
    return f".before + {tag}", '<g class="before"/>{}'


def of_attribute(draft, tag, values):
    values["title"] = "soft"
    return draft.pick({'[title="soft"]': 1, f"{tag}[title]": 1, "[title=soft]": 1}), "{}"


def of_first_child(draft, tag, values):
    return f"{tag}:first-child", "<g>{}<g/></g>"


def of_second_child(draft, tag, values):
    return f"{tag}:nth-child(2)", "<g><g/>{}</g>"


def of_several(draft, tag, values):
    selector, around = of_class(draft, tag, values)
    return f"#none, {selector}, .gone", around


SELECTORS = {
    of_class: 6, of_id: 3, of_element: 1, of_all: 0.4, of_element_and_class: 1, of_descendant: 1, of_child: 1,
    of_neighbour: 1, of_attribute: 1, of_first_child: 1, of_second_child: 0.5, of_several: 1,
}  # fmt: skip

# --- sheets: each returns the elements that hold all rules ---


def rule_text(rule):
    selector, values = rule
    return selector + "{" + ";".join(f"{name}:{value}" for name, value in values.items()) + "}"


def one_sheet(draft):
    return f"<style>{escape(' '.join(map(rule_text, draft.rules)))}</style>\n"


def several_sheets(draft):
    return "".join(f'<style type="text/css">{escape(rule_text(rule))}</style>\n' for rule in draft.rules)


def in_cdata(draft):
    lines = "\n".join(map(rule_text, draft.rules))
    return f'<style type="text/css"><![CDATA[\n/* colours */ {lines}\n]]></style>\n'


def for_media(draft):
    medium = draft.pick({"screen": 2, "all": 1, "print": 1})
    return f"<style>@media {medium} {{ {escape(' '.join(map(rule_text, draft.rules)))} }}</style>\n"


SHEETS = {one_sheet: 6, several_sheets: 2, in_cdata: 2, for_media: 0.7}
