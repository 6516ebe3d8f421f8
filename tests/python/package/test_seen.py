"""What nobody sees costs nothing: outlines, clips and masks, opacities, patches over patches."""

import json
import re

import pytest

import inkscape_harness
from built import SAMPLES, gradmesh as run
from fans import Fan

import gradmesh

BALANCED = {"epsilon": 0.01, "max_local_error": 0.1}
BACKGROUND = Fan(turns=1.25, clear=(2, 3, 4))

pytestmark = pytest.mark.module_only


def simplified(text, **options):
    document = gradmesh.loads(text)
    (result,) = gradmesh.simplify(document, **options)
    return document, result


@pytest.mark.parametrize("fan", [Fan(), Fan(clear=(2, 3, 4)), BACKGROUND], ids=["a", "b", "over"])
@pytest.mark.full(all_but=1)
def test_a_fan_keeps_few_patches_and_needs_no_mask(fan):
    document, result = simplified(fan.document(), **BALANCED)
    assert result.patches_after <= 16
    assert result.error <= 0.01
    assert b"<mask" not in document.to_bytes()


@pytest.mark.skipif(inkscape_harness.missing() != "", reason=inkscape_harness.missing())
@pytest.mark.full
def test_inkscape_paints_the_fans_page_as_before(tmp_path):
    """Within the bound, and what it paints otherwise of other patches' points."""
    text = BACKGROUND.document()
    document, _ = simplified(text, **BALANCED)
    pictures = []
    with inkscape_harness.Inkscape() as inkscape:
        for i, data in enumerate([text.encode(), document.to_bytes()]):
            svg = tmp_path / f"{i}.svg"
            svg.write_bytes(data)
            pictures.append(inkscape.export_png(svg, tmp_path / f"{i}.png", width=700))
    done = run("compare", *pictures)
    assert done.returncode == 0 and float(done.stdout) <= BALANCED["epsilon"] + 0.003


def test_opacities_cost_a_mesh_no_patches():
    text = (SAMPLES / "opacity.svg").read_text()
    opaque = re.sub(r'stop-opacity="[\d.]+"', 'stop-opacity="1"', text)
    assert opaque != text
    options = {"resolution": 300, "method": "gqe"}
    saved = [r.patches_before - r.patches_after for _, r in (simplified(t, **options) for t in (text, opaque))]
    assert saved[0] >= 0.9 * saved[1] > 0


WINDOW = {
    "clip path": '<clipPath id="w">{}</clipPath>',
    "mask": '<mask id="w" maskUnits="userSpaceOnUse" width="200" height="200">{}</mask>',
}
HOLDER = {"clip path": "clip-path", "mask": "mask"}


@pytest.mark.parametrize("kind", WINDOW)
@pytest.mark.parametrize("place", ["object", "group"])
@pytest.mark.full(all_but=1)
def test_what_is_clipped_or_masked_around_it_does_not_count(kind, place):
    """Through a small window that is turned with the group, less of the mesh is seen."""
    hole = '<g transform="translate(-5 0)"><path style="fill:#fff" d="M 85,130 h 30 v 30 h -30 z"/></g>'
    window, held = WINDOW[kind].format(hole), f'{HOLDER[kind]}="url(#w)"'
    shape = {
        "object": f'<g transform="rotate(10)"><rect {{}} {held} width="200" height="200"/></g>',
        "group": f'<g transform="rotate(10)" {held}><a>'
        '<rect {} transform="scale(2)" width="100" height="100"/></a></g>',
    }[place]
    text = Fan(rings=6, clear=()).document(shape, window)
    options = {"resolution": 150, "method": "gqe", "epsilon": 0.002}
    _, all_of_it = simplified(text, visible_only=False, **options)
    _, seen = simplified(text, **options)
    assert seen.patches_after < all_of_it.patches_after
    # What cannot be known counts as seen.
    unknown = text.replace("<path", "<text>a</text><path", 1)
    assert unknown != text
    _, free = simplified(text.replace(held, ""), **options)
    assert simplified(unknown, **options)[1].patches_after == free.patches_after > seen.patches_after


def test_the_command_line_counts_what_is_seen(tmp_path):
    text = Fan(clear=()).document('<rect {} x="90" y="150" width="20" height="20"/>')
    source = tmp_path / "fan.svg"
    source.write_text(text)
    left = {}
    for option in ("", "--whole-mesh"):
        out, report = tmp_path / "out.svg", tmp_path / "report.json"
        options = ["--resolution", "200", "--method", "gqe", "--report", report]
        done = run("simplify", source, "-o", out, *options, *filter(None, [option]))
        assert done.returncode == 0, done.stderr
        (mesh,) = json.loads(report.read_text())["meshes"]
        left[option] = mesh["patches_after"]
    assert left[""] < left["--whole-mesh"]
