"""What pages may have, by name: a function of a table has its name, with blanks."""

#: What lies in a page by itself.
MESHES = (
    "free triangles", "lattice of triangles", "coons patches", "tensor patches", "flags", "fold", "mirrored",
    "collapsed side", "inner points", "shading box", "exponential function", "stitched function", "sampled function",
)  # fmt: skip
SPACES = (
    "device rgb", "device gray", "device cmyk", "cal gray", "cal rgb", "lab", "icc based", "separation",
    "separation all", "device n", "default gray", "default rgb", "default cmyk",
)  # fmt: skip
PAINTS = (
    "sh", "fill", "fill even odd", "stroke", "fill and stroke", "dashes", "sh with opacities", "box of a mask",
    "tiles", "tiles of a fill", "text", "glyphs of meshes", "font of two bytes", "standard font",
)  # fmt: skip
AROUND = (
    "moved", "stretched", "translucent", "blended", "blended group", "clip to rectangle", "clip to polygon",
    "clip to curve", "clip to text", "clip even odd", "form", "form box", "form matrix", "group",
    "resources of the page", "two in a form", "two in a translucent group", "luminosity of fills", "alpha of fills",
    "alpha of translucent fills", "mask reset", "invisible marks",
)  # fmt: skip
LAYERS = (
    "layer", "layer of a form", "policy", "expression", "other tags", "base state off", "layer usage",
)  # fmt: skip
ANNOTATIONS = (
    "annotation", "annotation states", "hidden annotation", "unseen annotation", "printed annotation",
    "annotation matrix", "layer of an annotation",
)  # fmt: skip
PAGE = ("rotated page", "crop box", "user unit", "corner of the page", "several streams", "inherited by the page")

#: What poppler shows in another way than ISO 32000 says, so that its pictures cannot be compared: it strokes text in
#: black, finds no colour space of a shading by a name of the resources, and paints what a separation of None has.
BEYOND_POPPLER = ("stroked text", "space by name", "separation none")

FEATURES = (*MESHES, *SPACES, *PAINTS, *AROUND, *LAYERS, *ANNOTATIONS, *PAGE)
NAMES = frozenset((*FEATURES, *BEYOND_POPPLER))
