"""The meshes of the samples: their objects, sizes and elements."""

from svg_meshes import HREF, SVG

# The objects that a mesh paints, and the number of patches of each mesh.
PAINTED = {
    "fruit": {"pear": 132},
    "face": {"face": 156},
    "ellipse": {"planet": 144},
    "photo": {"photo": 400},
    "opacity": {"bubble": 169},
    "stroke": {"loop": 80},
    "two": {"cap": 280, "stalk": 36},
    "transformed": {"leaf": 112},
    "tensor": {"silk": 36},
    "smooth": {"vase": 88},
}
OBJECTS = [(sample, painted) for sample, objects in PAINTED.items() for painted in objects]


def mesh_of(root, painted):
    """The meshgradient that holds the rows of the mesh on the object with this id."""
    by_id = {element.get("id"): element for element in root.iter() if element.get("id")}
    item = by_id[painted]
    paints = [item.get("fill", ""), item.get("stroke", ""), *item.get("style", "").split(";")]
    names = [text.split("url(#")[1].split(")")[0] for text in paints if "url(#" in text]
    (mesh,) = [by_id[name] for name in names if by_id[name].tag == SVG + "meshgradient"]
    while mesh.get(HREF):
        mesh = by_id[mesh.get(HREF)[1:]]
    return mesh
