"""What the sample documents share: the page, plain gradients, grids and path data."""


def document(width, height, title, defs, body):
    """A page of width x height pixels whose drawing is one Inkscape layer."""
    return f"""<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<svg width="{width}" height="{height}" viewBox="0 0 {width} {height}" version="1.1" id="svg1"
   xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
   xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape">
<title id="title1">{title}</title>
<defs id="defs1">
{defs}
</defs>
<g inkscape:label="Layer 1" inkscape:groupmode="layer" id="layer1">
{body}
</g>
</svg>
"""


def _gradient(element, stops):
    text = "".join(
        f'<stop offset="{offset}" style="stop-color:{paint};stop-opacity:{opacity}"/>'
        for offset, paint, opacity in stops
    )
    return f"<{element}>{text}</{element.split()[0]}>"


def radial(name, ellipse, *stops):
    """A radial gradient over an ellipse (its centre and radii); `stops` are (offset, colour, opacity).

    In user space: those in an object's box Inkscape 1.4 paints flat as soon as an extension has run.
    """
    x, y, width, height = ellipse
    matrix = f"matrix({width} 0 0 {height} {x} {y})"
    place = f'cx="0" cy="0" r="1" gradientUnits="userSpaceOnUse" gradientTransform="{matrix}"'
    return _gradient(f'radialGradient id="{name}" {place}', stops)


def linear(name, *stops):
    """A linear gradient from the top to the bottom of its object's box."""
    return _gradient(f'linearGradient id="{name}" x2="0" y2="1"', stops)


def grid(rows, columns, point):
    """Points or colours `point(down, right)` at the corners of rows x columns patches, 0..1."""
    return [[point(i / rows, j / columns) for j in range(columns + 1)] for i in range(rows + 1)]


def path_data(points):
    """Closed cubic path data through a smooth line's corners and handles."""
    pairs = [f"{p.real:.2f},{p.imag:.2f}" for p in points]
    return f"M {pairs[0]} C " + " ".join(pairs[1:]) + " Z"
