"""What is protected is in the written document as it was in the one that was read, to the last digit."""

import pytest

np = pytest.importorskip("numpy")

import svg_meshes
from built import SAMPLES
from program import error, meshes, simplified
from svg_meshes import SVG

import gradmesh

FACE = (SAMPLES / "face.svg").read_text()
#: Over an eye of the sample.
EYE = '<rect id="eye" x="170" y="280" width="80" height="30" fill="none"/>'
#: A side of a patch under it, and handles that are all but at its thirds.
STRAIGHT = 'path="L 260,304"'
ALL_BUT_STRAIGHT = 'path="C 260,292.667 260,298.333 260,304"'


def colors(gradient):
    """The colours of the corners of each patch, row by row."""
    rows = [list(row.iter(SVG + "meshpatch")) for row in gradient.iter(SVG + "meshrow")]
    found = {}
    for i, row in enumerate(rows):
        for j, patch in enumerate(row):
            corners = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)]
            given = [side for side in range(4) if (side or i == 0) and (side < 3 or j == 0)]
            for side, stop in zip(given, patch.iter(SVG + "stop")):
                said = {**svg_meshes.declared(stop), **stop.attrib}
                if "stop-color" in said:
                    found.setdefault(corners[side], (said["stop-color"], float(said.get("stop-opacity", 1))))
    return [
        [_hex(found[corner]) for corner in ((i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j))]
        for i in range(len(rows))
        for j in range(len(rows[0]))
    ]


def _hex(color):
    name, opacity = color
    return (name if len(name) == 7 else "#" + "".join(2 * digit for digit in name[1:])), opacity


def patches(gradient):
    """Each patch as its points and the colours of its corners, row by row."""
    net = svg_meshes.read_net(gradient, complex(float(gradient.get("x")), float(gradient.get("y"))))
    nets = [net[i : i + 4, j : j + 4] for i in range(0, len(net) - 1, 3) for j in range(0, len(net[0]) - 1, 3)]
    return list(zip(nets, colors(gradient), strict=True))


def turned(patch):
    """The patch from each of its sides on, as blocks may begin with any."""
    net, corners = patch
    for k in range(4):
        yield np.rot90(net, k), corners[k:] + corners[:k]


def gradients(file):
    return list(svg_meshes.Document(file).root.iter(SVG + "meshgradient"))


def protected_of(file):
    """The patches of the one mesh of a document that the shape protects, and how many there are."""
    session = gradmesh.Session(gradmesh.load(file), protect=["eye"], resolution=64)
    numbers = session.status["protected"]
    (gradient,) = gradients(file)
    all_patches = patches(gradient)
    assert 0 < len(numbers) < len(all_patches) / 2
    return [all_patches[number] for number in numbers], len(all_patches)


def kept(patch, others):
    """Whether others have a patch to the last bit."""
    return any(
        corners == patch[1] and np.array_equal(net, patch[0])
        for other in others
        for net, corners in turned(other)
    )


def changed(text, *replacements):
    for old, new in replacements:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    return text.replace("</svg>", EYE + "</svg>")


UNITS = 'gradientUnits="userSpaceOnUse"'
DOCUMENTS = {
    "as it is": changed(FACE),
    "a side that is all but a line": changed(FACE, (STRAIGHT, ALL_BUT_STRAIGHT)),
    "turned": changed(FACE, (f"{UNITS}>", f'{UNITS} gradientTransform="rotate(4)">')),
    "numbers of many digits": changed(FACE.replace("148.76,272.029", "148.76123456789,272.029")),
}


@pytest.mark.full
def test_a_polygon_protects_as_a_shape_does():
    document = gradmesh.loads(DOCUMENTS["as it is"].encode(), "face.svg")
    eye = [(170, 280), (250, 280), (250, 310), (170, 310)]
    by_shape = gradmesh.Session(document, protect=["eye"], resolution=64).status["protected"]
    by_polygon = gradmesh.Session(document, protect=[eye], resolution=64).status["protected"]
    assert by_polygon == by_shape != []
    (result,) = gradmesh.simplify(document, protect=[eye], resolution=64, preview=True)
    assert result.protected_patches == len(by_shape)
    with pytest.raises(ValueError, match="three points or more"):
        gradmesh.Session(document, protect=[eye[:2]])


@pytest.mark.parametrize("name", DOCUMENTS)
@pytest.mark.parametrize("method", ["simplest", "plain", "lines"])
@pytest.mark.full(all_but=1)
def test_protected_patches_are_written_to_the_last_digit(tmp_path, name, method):
    svg, out = tmp_path / "face.svg", tmp_path / "out.svg"
    svg.write_text(DOCUMENTS[name])
    protected, count = protected_of(svg)
    (mesh,) = simplified(svg, out, "--protect", "eye", "--method", method, "--resolution", 200)
    (gradient,) = gradients(out)
    written = patches(gradient)
    assert mesh["protected_patches"] == len(protected) and mesh["patches_after"] == len(written) <= count
    assert mesh["handles_after"] < mesh["handles_before"]
    assert [kept(patch, written) for patch in protected] == [True] * len(protected)
    assert meshes(out)[0]["remembers"]


def test_the_error_is_that_of_what_is_written(tmp_path):
    svg, out = tmp_path / "face.svg", tmp_path / "out.svg"
    svg.write_text(DOCUMENTS["as it is"])
    options = {"resolution": 200, "visible_only": False}
    document = gradmesh.load(svg)
    (result,) = gradmesh.simplify(document, protect=["eye"], **options)
    out.write_bytes(document.to_bytes())
    assert error(svg, out, "--resolution", 200) == pytest.approx(result.error, abs=2e-5)


@pytest.mark.parametrize("name", ["as it is", "a side that is all but a line", "numbers of many digits"])
@pytest.mark.full(all_but=1)
def test_protected_patches_are_in_blocks_to_the_last_digit(tmp_path, name):
    svg, out = tmp_path / "face.svg", tmp_path / "out.svg"
    svg.write_text(DOCUMENTS[name])
    protected, count = protected_of(svg)
    (mesh,) = simplified(svg, out, "--protect", "eye", "--method", "best", "--resolution", 200)
    written = [patch for gradient in gradients(out) for patch in patches(gradient)]
    assert mesh["objects"] > 1 and mesh["patches_after"] == len(written) < count
    assert [kept(patch, written) for patch in protected] == [True] * len(protected)
