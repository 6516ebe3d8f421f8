"""publish_code(): meshes as code for apps, from Python."""

import pytest

from bad_documents import RAGGED, REASON
from built import SAMPLES
from hemesh_files import grid
from lattices import DOCUMENT, FILLED, MANY, gradient
from program import printed

import gradmesh

RECT = '<rect id="torn" x="12" y="12" width="36" height="16" fill="url(#n)"/>'


@pytest.mark.parametrize("language, extension", [("swift", ".swift"), ("compose", ".kt")])
def test_it_returns_what_the_command_line_writes(tmp_path, language, extension):
    document = gradmesh.load(SAMPLES / "two.svg")
    before = document.to_bytes()
    made = gradmesh.publish_code(document, language)
    assert document.to_bytes() == before
    assert [(mesh.id, mesh.name, mesh.lost, mesh.refused) for mesh in made.meshes] == [
        ("stalk", "Stalk", [], None),
        ("cap", "Cap", [], None),
    ]
    printed("publish", "--as", language, SAMPLES / "two.svg", "-o", tmp_path, "--quiet")
    for mesh in made.meshes:
        assert (tmp_path / (mesh.name + extension)).read_text() == mesh.source
    printed("publish", "--as", language, SAMPLES / "two.svg", "-o", tmp_path / ("all" + extension), "--quiet")
    assert (tmp_path / ("all" + extension)).read_text() == made.source


def test_it_says_what_is_lost():
    (mesh,) = gradmesh.publish_code(gradmesh.load(SAMPLES / "stroke.svg"), "swift").meshes
    (sentence,) = mesh.lost
    assert str(sentence).endswith("all of the mesh is painted, not only the stroke.")


def test_a_mesh_that_cannot_be_read_has_no_code():
    document = gradmesh.loads(DOCUMENT.format(defs=gradient(MANY) + RAGGED, body=FILLED + RECT))
    (torn,) = [mesh for mesh in gradmesh.publish_code(document, "compose").meshes if mesh.id == "torn"]
    assert (torn.name, torn.source) == ("", "") and REASON in str(torn.refused)


def test_it_refuses_other_documents_and_languages():
    with pytest.raises(gradmesh.InputError, match="only SVG documents are published"):
        gradmesh.publish_code(gradmesh.loads(grid(2, 2)), "swift")
    with pytest.raises(ValueError, match="the language must be swift or compose"):
        gradmesh.publish_code(gradmesh.load(SAMPLES / "two.svg"), "java")
