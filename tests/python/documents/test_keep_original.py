"""The original kept hidden beside the result."""

import io
import xml.etree.ElementTree as ET

import pytest

np = pytest.importorskip("numpy")

from built import SAMPLES
from in_inkscape import inkscape  # noqa: F401
from pictures import difference, export
from program import printed
from svg_meshes import GRADMESH, Document

import gradmesh

FRUIT = SAMPLES / "fruit.svg"


def kept(document, ids=(), **options):
    options = {"method": "grid", "keep_original": True, **options}
    return gradmesh.simplify(document, ids, **options)


def elements(document):
    """All elements by id, and each one's neighbours."""
    root = ET.fromstring(document.to_bytes())
    by_id = {e.get("id"): e for e in root.iter() if e.get("id")}
    assert len(by_id) == len([e for e in root.iter() if e.get("id")])
    below = {b: a for e in root.iter() for a, b in zip(list(e), list(e)[1:])}
    return by_id, below


def copies(document):
    return [name for name in elements(document)[0] if "-original" in name]


def test_a_hidden_copy_lies_below_the_result():
    before = Document(FRUIT)
    document = gradmesh.load(FRUIT)
    kept(document)
    by_id, below = elements(document)
    copy = by_id["pear-original"]
    assert below[by_id["pear"]] is copy
    assert copy.get(GRADMESH + "kept-for") == "pear"
    assert copy.get("d") == before.by_id["pear"].get("d")
    assert "display:none" in copy.get("style")
    after = Document(io.BytesIO(document.to_bytes()))
    there = after.by_id["pear-original"]
    assert (after.net(there) == before.net(before.by_id["pear"])).all()


def test_only_its_own_id_chooses_it():
    document = gradmesh.load(FRUIT)
    (result,) = kept(document)
    assert document.ids == ["pear"] and [mesh.id for mesh in document.meshes] == ["pear"]
    assert gradmesh.load(FRUIT).meshes[0].patches == 132
    # The root is around both.
    (again,) = gradmesh.simplify(document, "svg1", method="random", epsilon=0.02)
    assert (again.id, again.patches_before) == ("pear", result.patches_after)
    (named,) = gradmesh.simplify(document, "pear-original", method="grid")
    assert (named.id, named.patches_before) == ("pear-original", 132)
    assert gradmesh.render(document, "pear-original").shape == gradmesh.render(document).shape


def test_one_copy_is_enough():
    document = gradmesh.load(FRUIT)
    kept(document, epsilon=0.005)
    (result,) = kept(document, method="random", epsilon=0.02)
    assert result.patches_after < result.patches_before
    assert copies(document) == ["pear-original"]


def test_the_id_is_a_new_one():
    text = FRUIT.read_text().replace("</svg>", '<g id="pear-original"/></svg>')
    document = gradmesh.loads(text)
    kept(document)
    by_id, below = elements(document)
    assert not list(by_id["pear-original"])
    assert below[by_id["pear"]].get("id").startswith("pear-original")


@pytest.mark.parametrize("sample", ["opacity", "stroke", "fruit"])
@pytest.mark.full(all_but=1)
def test_of_a_simplified_mesh_too(sample):
    document = gradmesh.load(SAMPLES / f"{sample}.svg")
    (first,) = gradmesh.simplify(document, method="grid", epsilon=0.005)
    picture = gradmesh.render(document)
    (second,) = kept(document, method="random", epsilon=0.02)
    assert second.patches_after < second.patches_before == first.patches_after
    elements(document)
    hidden = f"{first.id}-original"
    assert np.array_equal(gradmesh.render(document, hidden), picture)
    (result,) = gradmesh.simplify(document, hidden, method="grid", epsilon=1e-5)
    assert result.patches_before == first.patches_after


def test_fill_and_stroke_have_one_copy():
    text = FRUIT.read_text()
    fill = Document(FRUIT).by_id["pear"].get("style")
    gradient = fill[fill.index("url(") : fill.index(")") + 1]
    document = gradmesh.loads(text.replace(fill, f"{fill};stroke:{gradient};stroke-width:9"))
    assert len(document.meshes) == 2
    assert gradmesh.render(document, "pear", 64).any()  # the fill is meant
    with pytest.raises(gradmesh.InputError, match="2 meshes"):
        gradmesh.render(document)
    kept(document)
    assert copies(document) == ["pear-original"]
    assert len(document.meshes) == 2


def test_a_hemesh_file_has_no_room():
    silk = gradmesh.convert(gradmesh.load(SAMPLES / "tensor.svg"), "hemesh").document
    with pytest.raises(gradmesh.InputError, match="holds one mesh"):
        kept(silk)


def test_on_the_command_line(tmp_path):
    out = tmp_path / "out.svg"
    printed("simplify", FRUIT, "-o", out, "--method", "grid", "--keep-original")
    assert 'id="pear-original"' in out.read_text()


def test_inkscape_paints_nothing_of_it(inkscape, tmp_path):
    files = []
    for name, keep in (("with", True), ("without", False)):
        document = gradmesh.load(FRUIT)
        kept(document, keep_original=keep)
        files.append(tmp_path / f"{name}.svg")
        gradmesh.save(document, files[-1])
    assert difference(*export(inkscape, files)).max() == 0
