"""What SVG is written with: elements, ids and what refers to them, transforms."""

from urllib.parse import quote
from xml.sax.saxutils import quoteattr


def attributes(values):
    return " ".join(f"{name}={quoteattr(str(value))}" for name, value in values.items())


def element(tag, values, content=""):
    opening = f"{tag} {attributes(values)}".strip()
    return f"<{opening}>{content}</{tag}>" if content else f"<{opening}/>"


#: How a document spells its ids.
NAMES = {
    str: 12,
    lambda name: f"grün-{name}": 2,
    lambda name: f"ein {name}": 2,
    lambda name: f"a.b.{name}": 2,
    lambda name: f"-{name}_-x": 1,
    lambda name: f"a\u00a0{name}": 1,
    lambda name: f"{name}:1": 1,
    lambda name: f"{name}(2)": 0.5,
}


def url(draft, id):
    """A reference to an id that is a value of a property: escaped where it must be, else at times."""
    text = quote(id) if " " in id or "(" in id or draft.maybe(0.2) else id
    return draft.pick({"url(#{})": 12, "url('#{}')": 1, 'url("#{}")': 1, "url( #{} )": 0.5}).format(text)


def in_selector(id):
    """An id as style sheets write it."""
    return "".join(letter if letter.isalnum() or letter in "_-" else "\\" + letter for letter in id)


def reference(draft, id):
    name = draft.pick({"xlink:href": 8, "href": 1})
    return {name: "#" + (quote(id) if " " in id or "(" in id else id)}


def moved(draft, x, y):
    """A transform around a point."""
    turned = f"rotate({draft.chance.uniform(-40, 40):.4g} {x} {y})"
    there, back = f"translate({x} {y})", f"translate(-{x} -{y})"
    return draft.pick({
        turned: 2,
        f"{there} scale(0.8 1.1) {back}": 1,
        f"{there} skewX(20) {back}": 1,
        f"{there} matrix(1 0.2 -0.3 0.9 0 0) {back}": 1,
        f"{there} scale(-1 1) {back}": 1,
        f"translate({x}) rotate(10) translate(-{x})": 1,
    })  # fmt: skip
