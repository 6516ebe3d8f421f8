"""The real Inkscape shows what gradmesh paints, before and after a mesh is simplified."""

import pytest


pytest.importorskip("PIL")
pytest.importorskip("numpy")

import pictures
import svg_meshes
from built import SAMPLES
from in_inkscape import inkscape, needs  # noqa: F401
from pictures import difference, export, flip, gradmesh, info
from sample_meshes import OBJECTS, PAINTED

pytestmark = needs()

# FLIP charges 0.03 for a single level everywhere: at most one pixel in a thousand may be a level
# off, where transforms are multiplied in another order.
SAME = 3e-5
EPSILON = 0.01
# Enough merges for several blocks and nested T-junctions in every sample.
COARSE = 0.03
RESOLUTIONS = (350, 700, pytest.param(1400, marks=pytest.mark.long))


def simplified(folder, epsilon, method="grid"):
    files = {}
    for sample in PAINTED:
        files[sample] = folder / f"{sample}.svg"
        source = SAMPLES / f"{sample}.svg"
        options = ["--epsilon", epsilon, "--method", method]
        gradmesh("simplify", source, "-o", files[sample], *options)
    return files


@pytest.fixture(scope="module")
def coarse(tmp_path_factory):
    """The samples, simplified so much that all have T-junctions or lost whole lines. Of those whose
    type is "bicubic" only lines can go."""
    return simplified(tmp_path_factory.mktemp("coarse"), COARSE)


def bare_pictures(inkscape, folder, sources, resolution=700):
    """Pictures of the bare meshes by Inkscape and by gradmesh, by object."""
    bare, ours = {}, {}
    for sample, painted in OBJECTS:
        document = svg_meshes.Document(sources[sample])
        bare[painted], ours[painted] = folder / f"{painted}-bare.svg", folder / f"{painted}-gradmesh.png"
        pictures.write_bare_mesh(document, document.by_id[painted], bare[painted], resolution)
        options = ["--like-inkscape", "--id", painted, "--resolution", resolution]
        gradmesh("render", sources[sample], *options, "-o", ours[painted])
    theirs = export(inkscape, bare.values())
    return {painted: (png, ours[painted]) for painted, png in zip(bare, theirs)}


@pytest.fixture(scope="module")
def meshes(inkscape, tmp_path_factory):
    sources = {sample: SAMPLES / f"{sample}.svg" for sample in PAINTED}
    return bare_pictures(inkscape, tmp_path_factory.mktemp("meshes"), sources)


@pytest.fixture(scope="module", params=RESOLUTIONS)
def blocks(request, inkscape, coarse, tmp_path_factory):
    return bare_pictures(inkscape, tmp_path_factory.mktemp("blocks"), coarse, request.param)


@pytest.fixture(scope="module")
def gradients(inkscape, tmp_path_factory):
    """Of the samples with whole lines taken out, still one gradient each."""
    folder = tmp_path_factory.mktemp("gradients")
    return bare_pictures(inkscape, folder, simplified(folder, COARSE, "lines"))


@pytest.mark.parametrize("sample, painted", OBJECTS)
@pytest.mark.parametrize("which", ["meshes", "gradients"])
@pytest.mark.full(all_but=1)
def test_gradmesh_paints_a_mesh_as_inkscape_does(request, which, sample, painted):
    theirs, ours = request.getfixturevalue(which)[painted]
    assert flip(theirs, ours) <= SAME
    # Nor does it differ at the mesh's own outline, which Inkscape does not smooth.
    assert (difference(theirs, ours) > 16).sum() <= 20


@pytest.mark.parametrize("sample, painted", OBJECTS)
@pytest.mark.full(all_but=1)
def test_the_centre_of_a_pixel_is_on_the_same_surface(meshes, tmp_path, sample, painted):
    theirs, _ = meshes[painted]
    gradmesh("render", SAMPLES / f"{sample}.svg", "--id", painted, "-o", tmp_path / "centre.png")
    levels = difference(theirs, tmp_path / "centre.png")
    # Cairo rounds down, half a level, and takes a point up to half a pixel away.
    assert levels.mean() <= 1.25
    # It paints the pixels that the outline only touches, and takes the next patch's colour early.
    assert (levels > 8).mean() <= 0.005


@pytest.mark.parametrize("sample, painted", OBJECTS)
@pytest.mark.full
def test_blocks_show_no_seams_in_inkscape(blocks, sample, painted):
    theirs, ours = blocks[painted]
    levels = difference(theirs, ours)
    if sample == "opacity":
        # The mask and the picture under it have 8 bits each: a level up or down, everywhere.
        assert (levels > 2).mean() <= 0.001
    else:
        assert flip(theirs, ours) <= SAME
    # Single pixels at corners; a seam has hundreds.
    assert (levels > 16).sum() <= 20


@pytest.fixture(scope="module")
def pages(inkscape, tmp_path_factory):
    """Inkscape's pictures of the samples' pages before and after, by sample."""
    folder = tmp_path_factory.mktemp("pages")
    after = simplified(folder, EPSILON)
    before = {}
    for sample in PAINTED:
        before[sample] = folder / f"{sample}-before.svg"
        before[sample].write_bytes((SAMPLES / f"{sample}.svg").read_bytes())
    pngs = export(inkscape, [*before.values(), *after.values()])
    return dict(zip(PAINTED, zip(pngs, pngs[len(PAINTED) :])))


@pytest.mark.parametrize("sample", PAINTED)
@pytest.mark.full(all_but=1)
def test_the_page_looks_the_same_in_inkscape(pages, sample):
    assert flip(*pages[sample]) <= EPSILON + 0.003


def counts(svg):
    names = ("role", "simplified", "patches", "points", "t_junctions")
    return {painted: [mesh[name] for name in names] for painted, mesh in info(svg).items()}


def assert_same_meshes(before, after, folder):
    assert before.read_bytes() != after.read_bytes(), "Inkscape has written nothing of its own"
    assert counts(before) == counts(after)
    is_group = any(simplified for _, simplified, *_ in counts(before).values())
    # One mesh gradient stays that, and becomes that where blocks would need a mask for opacities.
    assert is_group != (before.stem in ("smooth", "opacity"))
    for painted in counts(before):
        for source, png in ((before, "before.png"), (after, "after.png")):
            gradmesh("render", source, "--id", painted, "-o", folder / png)
        assert flip(folder / "before.png", folder / "after.png") <= 0.0005


@pytest.fixture(scope="module")
def saved(inkscape, coarse):
    return dict(zip(coarse, export(inkscape, coarse.values(), kind="svg")))


@pytest.mark.parametrize("sample", PAINTED)
@pytest.mark.full
def test_the_mesh_survives_being_saved_by_inkscape(coarse, saved, tmp_path, sample):
    assert_same_meshes(coarse[sample], saved[sample], tmp_path)


# One of each kind of group: clipped, masked, and with a group around it for the filter.
@pytest.mark.parametrize("sample", ["fruit", "stroke", "transformed"])
@pytest.mark.full
def test_the_mesh_survives_being_moved_in_inkscape(inkscape, coarse, tmp_path, sample):
    (painted,) = PAINTED[sample]
    moved = tmp_path / "moved.svg"
    actions = [f"select-by-id:{painted}", "transform-translate:30,20"]
    inkscape.run_actions(coarse[sample], [*actions, f"export-filename:{moved}", "export-do"])
    assert_same_meshes(coarse[sample], moved, tmp_path)
    before, after = (svg_meshes.Document(svg).blocks() for svg in (coarse[sample], moved))
    assert before.keys() == after.keys()
    for name, net in before.items():
        assert abs(after[name] - net - (30 + 20j)).max() < 1e-3
