"""Drawings: what is in them, that they are ordinary SVG, and that Inkscape shows them."""

import base64
import re
import subprocess
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from PIL import Image

import svg_meshes
from built import SAMPLES
from hemesh_files import grid
from program import meshes, printed, refused
from svg_meshes import HREF, LABEL, SVG

import gradmesh

FRUIT = SAMPLES / "fruit.svg"
COARSE = ("--resolution", 150)
LAYERS = {
    "edges": ["Picture", "Curves", "Handles", "Points", "Numbers of half-edges", "Legend"],
    "faces": ["Patches"],
    "errors": ["Picture", "Boundary", "Single-edge errors", "Unmergeable edges", "Legend"],
    "motorcycle": ["Picture", "Parts", "Boundary", "Motorcycle graph", "Legend"],
    "regions": ["Picture", "Curves", "Regions", "Legend"],
}


class Drawn:
    """A drawing of the fruit, or of another document, read back."""

    def __init__(self, folder, show, *options, document=FRUIT):
        self.path = folder / f"{show}.svg"
        assert printed("draw", document, "-o", self.path, "--show", show, *COARSE, *options) == ""
        self.root = ET.parse(self.path).getroot()
        self.layers = {g.get(LABEL): g for g in self.root.iter(SVG + "g")}

    def paths(self, layer):
        return list(self.layers[layer].iter(SVG + "path"))

    def texts(self, layer="Legend"):
        return [text.text for text in self.layers[layer].iter(SVG + "text")]

    def titles(self, layer):
        return [title.text for title in self.layers[layer].iter(SVG + "title")]


@pytest.mark.parametrize("show", LAYERS)
def test_layers_are_ordinary_paths(tmp_path, show):
    drawn = Drawn(tmp_path, show)
    assert list(drawn.layers) == LAYERS[show]
    tags = {element.tag.removeprefix(SVG) for element in drawn.root.iter()}
    assert tags <= {"svg", "title", "rect", "g", "image", "path", "text"}
    for path in drawn.root.iter(SVG + "path"):
        assert re.fullmatch(r"M[-\d.,e MCLAZ]+", path.get("d"))
    # The picture behind may hold any letters.
    text = re.sub(r'base64,[^"]*', "", drawn.path.read_text())
    assert not re.search(r"nan|inf", text.replace("inkscape", ""))
    low_x, low_y, width, height = map(float, drawn.root.get("viewBox").split())
    for text in drawn.root.iter(SVG + "text"):
        assert low_x <= float(text.get("x")) <= low_x + width
        assert low_y <= float(text.get("y")) <= low_y + height


def test_edges_carry_the_numbers_that_manual_takes(tmp_path):
    drawn = Drawn(tmp_path, "edges")
    numbers = drawn.texts("Numbers of half-edges")
    assert len(set(numbers)) == len(numbers) == 11 * 11 + 12 * 10
    manual = ("--preview", "--method", "manual", "--edges", numbers[-1])
    assert "131 of 132 patches" in printed("simplify", FRUIT, *manual, *COARSE)


def test_it_lies_where_the_mesh_is_seen(tmp_path):
    """Also inside transformed groups; the picture behind has the paper's margin."""
    path = SAMPLES / "transformed.svg"
    (mesh,) = meshes(path)
    document = svg_meshes.Document(path)
    seen = [
        svg_meshes.apply(document.to_document(document.by_id[mesh["id"]]), complex(*p["position"]))
        for p in mesh["elements"]["points"]
    ]
    drawn = Drawn(tmp_path, "edges", document=path)
    centers = []
    for mark in drawn.paths("Points"):
        box = np.reshape(svg_meshes.numbers(re.sub("A[^A]* 0 1 1 ", "", mark.get("d"))), (-1, 2))
        centers.append(complex(*(box.min(axis=0) + box.max(axis=0)) / 2))
    assert np.allclose(sorted(centers, key=repr), sorted(seen, key=repr), atol=1e-4)

    image = drawn.layers["Picture"].find(SVG + "image")
    low = complex(float(image.get("x")), float(image.get("y")))
    size = complex(float(image.get("width")), float(image.get("height")))
    margin = 0.015 / 1.03 * max(size.real, size.imag)
    inside = np.array(seen) - low
    # A point of the curves may lie beyond all corners, by a little here.
    assert margin * 0.5 < inside.real.min() < 3 * margin
    assert margin * 0.5 < inside.imag.min() < 3 * margin


def test_the_picture_can_be_left_out(tmp_path):
    drawn = Drawn(tmp_path, "errors")
    data = drawn.layers["Picture"].find(SVG + "image").get(HREF)
    assert base64.b64decode(data.removeprefix("data:image/png;base64,")).startswith(b"\x89PNG")
    assert "Picture" not in Drawn(tmp_path, "errors", "--no-picture").layers


def test_edges_and_faces_are_complete(tmp_path):
    edges, faces = Drawn(tmp_path, "edges"), Drawn(tmp_path, "faces")
    # 11 x 12 patches: 241 curves between two of them, and 46 on the boundary.
    assert len(edges.paths("Curves")) == 241 + 46
    assert len(edges.paths("Points")) == 12 * 13
    assert {"patches: 132", "curves: 287", "control points: 156"} <= set(edges.texts())
    assert sorted(map(int, faces.texts("Patches"))) == list(range(132))
    assert sorted(faces.titles("Patches")) == sorted(f"Patch {i}" for i in range(132))


def test_junctions_are_marked(tmp_path):
    merged = tmp_path / "merged.svg"
    printed("simplify", FRUIT, "-o", merged, *COARSE, "--method", "best", "--epsilon", 0.02)
    drawn = Drawn(tmp_path, "edges", document=merged)
    marked = sum(title.startswith("T-junction") for title in drawn.titles("Points"))
    assert marked > 5
    assert f"T-junctions: {marked}" in drawn.texts()


def test_errors_are_those_of_the_analysis(tmp_path):
    prices = tmp_path / "prices.json"
    drawn = Drawn(tmp_path, "errors", "--metric", "ssim", "--save-analysis", prices)
    assert len(drawn.paths("Single-edge errors")) == 241
    assert "1 - SSIM at 150 pixels" in drawn.texts()
    known = [float(title.split(": ")[1]) for title in drawn.titles("Single-edge errors")]
    assert known == sorted(known)
    saved = re.findall(r"\[\d+,\d,\d+,\d+,([^]]+),true\]", prices.read_text())
    assert known == pytest.approx(sorted(map(float, saved)), rel=0.06)
    again = Drawn(tmp_path, "errors", "--metric", "ssim", "--load-analysis", prices)
    assert again.titles("Single-edge errors") == drawn.titles("Single-edge errors")


def test_a_mesh_that_is_one_patch_can_be_merged_wholly(tmp_path):
    """The patches are exact parts of one, so that one region holds them all."""
    leaf = tmp_path / "leaf.hemesh"
    leaf.write_text(grid(2, 3))
    drawn = Drawn(tmp_path, "regions", document=leaf)
    assert {"2 × 3", "3 × 2"} & set(drawn.texts())
    (patch,) = [title for title in drawn.titles("Regions") if title.startswith("Patch")]
    assert f"Regions of {patch.lower()}" in drawn.texts()
    motorcycle = Drawn(tmp_path, "motorcycle", "--epsilon", 0.5, document=leaf)
    assert {"0 cannot be merged", "7 left to merge", "parts: 1"} <= set(motorcycle.texts())


def test_regions_of_a_patch(tmp_path):
    patch = ("--patch", 60)
    largest = Drawn(tmp_path, "regions", *patch)
    assert "Regions of patch 60" in largest.texts()
    shown = [text.text for text in largest.layers["Legend"] if text.get("font-weight")]
    number = int(shown[1])  # below the heading
    one = Drawn(tmp_path, "regions", *patch, "--region", 1)
    shown = [text.text for text in one.layers["Legend"] if text.get("font-weight")]
    assert shown[1] == "1" and shown[2] in ("1 × 2", "2 × 1")
    assert len(Drawn(tmp_path, "regions", *patch, "--region", "all").paths("Regions")) > number
    for wrong, sentence in (
        ((*patch, "--region", number + 1), f"{FRUIT}: patch 60 has {number} regions only."),
        (("--patch", 132), f"{FRUIT}: there is no patch 132; the last is 131."),
    ):
        out = tmp_path / "out.svg"
        assert refused("draw", FRUIT, "-o", out, "--show", "regions", *COARSE, *wrong) == sentence
        assert not out.exists()


@pytest.mark.parametrize("show", LAYERS)
@pytest.mark.full(all_but=1)
def test_inkscape_shows_it(tmp_path, show):
    drawn, picture = Drawn(tmp_path, show), tmp_path / "picture.png"
    subprocess.run(
        ["inkscape", f"--export-filename={picture}", drawn.path], check=True, capture_output=True
    )
    image = np.asarray(Image.open(picture).convert("RGB"))
    assert image.shape[1] == pytest.approx(float(drawn.root.get("width")), abs=1)
    # Something is drawn where the mesh is, and at the legend; the margins are white.
    assert len(np.unique(image.reshape(-1, 3), axis=0)) > 50
    for edge in (image[:3], image[-3:], image[:, :3], image[:, -3:]):
        assert (edge == 255).all()


def test_python_draws_the_same(tmp_path):
    out = tmp_path / "errors.svg"
    printed("draw", FRUIT, "-o", out, "--show", "errors", "--resolution", 100)
    document = gradmesh.load(FRUIT)
    assert gradmesh.draw(document, "errors", resolution=100) == out.read_text()
    plain = gradmesh.draw(document, "edges", "pear", picture=False)
    assert "<image" not in plain and "<path" in plain
    with pytest.raises(ValueError, match="there are: edges"):
        gradmesh.draw(document, "taste")
