/** An element of HTML; attributes named on... are listeners. */
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (name.startsWith("aria-")) element.setAttribute(name, value);
    else if (value !== false) element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

/** An element of SVG. */
function svg(tag, attributes = {}, parent = null) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  parent?.append(element);
  return element;
}

/** A number for people: few digits, no trailing zeros, a true minus. */
function short(number, digits = 4) {
  const small = number !== 0 && Math.abs(number) < 1e-3;
  const text = small
    ? number.toExponential(Math.min(digits, 3) - 1)
    : String(Number(number.toPrecision(digits)));
  return text.replaceAll("-", "\u2212");
}

/** Some numbers for people. */
function list(numbers, digits = 4, between = ", ") {
  return numbers.map((x) => short(x, digits)).join(between);
}

function quiet(text) {
  return make("p", { class: "quiet" }, text);
}

/** CSS colour of values in 0..1. */
function css(color) {
  const bytes = color.slice(0, 3).map((c) => Math.round(255 * Math.min(1, Math.max(0, c))));
  return `rgb(${bytes.join(" ")})`;
}

function swatch(color) {
  return make("span", { class: "swatch", style: `background:${css(color)}`, "aria-hidden": true });
}
