"""The documents of the sample photographs: a picture, and above it the outline of an object."""

import base64
import io


def closed_path(nodes, tangents):
    """Returns the path data of a smooth closed path: each node, and its tangent, a third of which is each handle."""
    steps = []
    for i, node in enumerate(nodes):
        before = i - 1
        steps.append((nodes[before] + tangents[before] / 3, node - tangents[i] / 3, node))
    curves = " ".join(" ".join(f"{p.real:.1f},{p.imag:.1f}" for p in step) for step in steps[1:] + steps[:1])
    return f"M {nodes[0].real:.1f},{nodes[0].imag:.1f} C {curves} Z"


def outlined_photograph(image, title, name, path, stroke):
    """Returns the document in which `path`, whose id is `name`, lies on the picture."""
    width, height = image.size
    buffer = io.BytesIO()
    image.save(buffer, "JPEG", quality=86, optimize=True)
    data = base64.b64encode(buffer.getvalue()).decode()
    return f"""<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
   width="{width}px" height="{height}px" viewBox="0 0 {width} {height}">
<title>{title}</title>
<image id="photograph" width="{width}" height="{height}" xlink:href="data:image/jpeg;base64,{data}"/>
<path id="{name}" style="fill:none;stroke:{stroke};stroke-width:1.5"
   d="{path}"/>
</svg>
"""
