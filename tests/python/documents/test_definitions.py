"""Meshes in masks, patterns, symbols, markers and what <use> shows are meshes like others."""

import pytest

from in_inkscape import inkscape  # noqa: F401
from lattices import gradient, lattice
from program import listed, meshes, printed, refused

SIZE, EPSILON = 4, 0.02


def mesh(opacity):
    """With colours and opacities that are linear, so that all patches can become one."""
    sides = range(SIZE + 1)
    colours = [
        [
            (f"#{255 * i // SIZE:02x}{255 * j // SIZE:02x}63", (1 + i + j) / (1 + 2 * SIZE) if opacity else 1)
            for j in sides
        ]
        for i in sides
    ]
    return gradient(lattice(colours, (0, 0, 40, 40)))


OBJECT = '<ellipse id="o" cx="20" cy="20" rx="20" ry="16" fill="url(#m)"/>'
DOCUMENT = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
width="120" height="120"><rect width="120" height="120" fill="#ddd"/>
<defs>{}</defs>{}</svg>"""
DEFINITIONS = {
    "mask": '<mask id="k" maskUnits="userSpaceOnUse" x="0" y="0" width="120" height="120">{}</mask>'
    '<rect transform="scale(2.5)" width="40" height="40" fill="blue" mask="url(#k)"/>',
    "pattern": '<defs><pattern id="k" patternUnits="userSpaceOnUse" width="44" height="40" '
    'patternTransform="rotate(10)">{}</pattern></defs>'
    '<rect width="120" height="120" style="fill:url(#k)"/>',
    "pattern of a rule": '<style>#p {{ fill: url("#k") }}</style><pattern id="k" width="44" height="40" '
    'patternUnits="userSpaceOnUse">{}</pattern><rect id="p" width="120" height="120"/>',
    "symbol": '<symbol id="k" viewBox="0 0 40 40">{}</symbol>'
    '<use xlink:href="#k" x="5" y="5" width="80" height="80"/>',
    "marker": '<marker id="k" overflow="visible" markerUnits="userSpaceOnUse" orient="auto">{}'
    '</marker><path d="M 20,20 L 60,60 70,30" stroke="black" fill="none" '
    'style="marker-start:url(#k);marker-end:url(#k)"/>',
    "use": '<defs>{}</defs><use xlink:href="#o" transform="translate(10,10) scale(2)"/>',
    "use of a group": '<defs><g id="k">{}</g></defs><use xlink:href="#k" transform="scale(2)"/>',
}


def document(definition, opacity=False):
    return DOCUMENT.format(mesh(opacity), definition.format(OBJECT))


@pytest.fixture(scope="module")
def simplified(inkscape, tmp_path_factory):
    """Of each definition, opaque and not, the document before and after, and Inkscape's pictures."""
    pictures = pytest.importorskip("pictures")
    folder = tmp_path_factory.mktemp("definitions")
    paths = {}
    for number, name in enumerate(DEFINITIONS):
        for opacity in (False, True):
            before, after = (folder / f"{number}{opacity:d}{when}.svg" for when in ("a", "b"))
            before.write_text(document(DEFINITIONS[name], opacity))
            printed("simplify", before, "-o", after, "--epsilon", EPSILON)
            paths[name, opacity] = before, after
    files = [path for pair in paths.values() for path in pair]
    pngs = dict(zip(files, pictures.export(inkscape, files, dpi=192)))
    return {key: (*pair, *(pngs[path] for path in pair)) for key, pair in paths.items()}


@pytest.mark.parametrize("opacity", [False, True], ids=["opaque", "translucent"])
@pytest.mark.parametrize("name", DEFINITIONS)
@pytest.mark.full(all_but=1)
def test_what_is_defined_is_simplified_where_it_is(simplified, name, opacity):
    import pictures

    before, after, *pngs = simplified[name, opacity]
    assert [(m["id"], m["patches"]) for m in meshes(before)] == [("o", SIZE * SIZE)]
    assert [(m["id"], m["patches"]) for m in meshes(after)] == [("o", 1)]
    assert pictures.flip(*pngs) <= EPSILON


@pytest.mark.parametrize("name", DEFINITIONS)
def test_what_nothing_names_is_not_painted(tmp_path, name):
    path = tmp_path / "in.svg"
    text = document(DEFINITIONS[name])
    text = text.replace('url("#k")', "red")
    for use in ('mask="url(#k)"', "fill:url(#k)", 'xlink:href="#k"', 'xlink:href="#o"'):
        text = text.replace(use, "")
    path.write_text(text.replace("marker-start:url(#k);marker-end:url(#k)", ""))
    assert meshes(path) == []
    assert [mesh["id"] for mesh in listed(path)["unused"]] == ["m"]


def test_nothing_of_a_clip_is_painted(tmp_path):
    path = tmp_path / "in.svg"
    path.write_text(document('<clipPath id="k">{}</clipPath><g clip-path="url(#k)"/>'))
    assert meshes(path) == []
    said = refused("simplify", path, "-o", tmp_path / "out.svg", "--id", "o")
    assert said.endswith('ellipse "o": it is in a clipPath, which paints nothing.')


def test_what_limited_a_cloned_object_stays(tmp_path):
    """Inkscape 1.2 ends where an extension takes away what clips or masks a cloned object; alone it goes."""
    for clone in ("", '<use xlink:href="#o" x="40"/>'):
        file, blocks, one = (tmp_path / f"{name}{len(clone)}.svg" for name in ("mesh", "blocks", "one"))
        file.write_text(document("{}" + clone))
        printed("simplify", file, "-o", blocks, "--method", "gqe", "--epsilon", EPSILON)
        printed("one-mesh", blocks, "-o", one)
        assert ("<clipPath" in one.read_text()) == bool(clone)
