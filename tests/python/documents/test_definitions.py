"""Meshes in masks, patterns, symbols, markers and what <use> shows are meshes like others."""

import json

import pytest

import inkscape_harness
from built import gradmesh

SIZE, EPSILON = 4, 0.02


def stop(path, i, j, opacity):
    """With colours and opacities that are linear, so that all patches can become one."""
    r, g = 255 * i // SIZE, 255 * j // SIZE
    alpha = (1 + i + j) / (1 + 2 * SIZE) if opacity else 1
    return f'<stop path="{path}" style="stop-color:rgb({r},{g},99);stop-opacity:{alpha}"/>'


def mesh(opacity):
    rows = ""
    for i in range(SIZE):
        rows += "<meshrow>"
        for j in range(SIZE):
            sides = [("l 10,0", i, j), ("l 0,10", i, j + 1), ("l -10,0", i + 1, j + 1)]
            sides += [("l 0,-10", i + 1, j)]
            wanted = sides[i > 0 : 4 if j == 0 else 3]
            rows += f"<meshpatch>{''.join(stop(*side, opacity) for side in wanted)}</meshpatch>"
        rows += "</meshrow>"
    return f'<meshgradient id="m" gradientUnits="userSpaceOnUse" x="0" y="0">{rows}</meshgradient>'


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


def info(path):
    return json.loads(gradmesh("info", "--json", path).stdout)


@pytest.fixture(scope="module")
def simplified(tmp_path_factory):
    """Of each definition, opaque and not, the document before and after, and Inkscape's pictures."""
    pictures = pytest.importorskip("pictures")
    if reason := inkscape_harness.missing():
        pytest.skip(reason)
    folder = tmp_path_factory.mktemp("definitions")
    paths = {}
    for number, name in enumerate(DEFINITIONS):
        for opacity in (False, True):
            before, after = (folder / f"{number}{opacity:d}{when}.svg" for when in ("a", "b"))
            before.write_text(document(DEFINITIONS[name], opacity))
            done = gradmesh("simplify", before, "-o", after, "--epsilon", str(EPSILON))
            assert (done.returncode, done.stderr) == (0, "")
            paths[name, opacity] = before, after
    with inkscape_harness.Inkscape() as inkscape:
        files = [path for pair in paths.values() for path in pair]
        pngs = dict(zip(files, pictures.export(inkscape, files, dpi=192)))
    return {key: (*pair, *(pngs[path] for path in pair)) for key, pair in paths.items()}


@pytest.mark.parametrize("opacity", [False, True], ids=["opaque", "translucent"])
@pytest.mark.parametrize("name", DEFINITIONS)
def test_what_is_defined_is_simplified_where_it_is(simplified, name, opacity):
    import pictures

    before, after, *pngs = simplified[name, opacity]
    assert [(m["id"], m["patches"]) for m in info(before)["meshes"]] == [("o", SIZE * SIZE)]
    assert [(m["id"], m["patches"]) for m in info(after)["meshes"]] == [("o", 1)]
    assert pictures.flip(*pngs) <= EPSILON


@pytest.mark.parametrize("name", DEFINITIONS)
def test_what_nothing_names_is_not_painted(tmp_path, name):
    path = tmp_path / "in.svg"
    text = document(DEFINITIONS[name])
    text = text.replace('url("#k")', "red")
    for use in ('mask="url(#k)"', "fill:url(#k)", 'xlink:href="#k"', 'xlink:href="#o"'):
        text = text.replace(use, "")
    path.write_text(text.replace("marker-start:url(#k);marker-end:url(#k)", ""))
    assert info(path)["meshes"] == []
    assert [mesh["id"] for mesh in info(path)["unused"]] == ["m"]


def test_nothing_of_a_clip_is_painted(tmp_path):
    path = tmp_path / "in.svg"
    path.write_text(document('<clipPath id="k">{}</clipPath><g clip-path="url(#k)"/>'))
    assert info(path)["meshes"] == []
    said = gradmesh("simplify", path, "-o", tmp_path / "out.svg", "--id", "o")
    assert said.returncode == 1
    assert said.stderr.endswith('ellipse "o": it is in a clipPath, of which nothing is painted.\n')
