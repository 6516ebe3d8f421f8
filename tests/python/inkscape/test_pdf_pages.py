"""Random pages of PDF look in Inkscape as poppler shows them, or a sentence tells what is left out of them.

The environment variable GRADMESH_RANDOM_PAGES says how many there are, GRADMESH_RANDOM_FIRST with which seed they
begin. `python -m random_pages` prints a table of any pages.
"""

import os

import pytest

import built  # noqa: F401, which says where the package is
import random_pages
from in_inkscape import inkscape, needs  # noqa: F401

pytest.importorskip("numpy")
pytest.importorskip("PIL.Image")
pytest.importorskip("gradmesh", reason="the compiled package is not there")

from pdf_painters import missing, outcomes

pytestmark = [needs(), pytest.mark.skipif(bool(missing()), reason=missing() or "nothing is missing")]

#: The largest FLIP of a page.
LIMIT = 0.02
FIRST = int(os.environ.get("GRADMESH_RANDOM_FIRST", 0))
SEEDS = range(FIRST, FIRST + int(os.environ.get("GRADMESH_RANDOM_PAGES", 40)))


@pytest.fixture(scope="module")
def pages(request, inkscape, tmp_path_factory):
    """Of each seed that a test asks for what became of its page, all painted by one Inkscape."""
    folder = tmp_path_factory.mktemp("pages")
    items = [item for item in request.session.items if item.module is request.module and hasattr(item, "callspec")]
    seeds = sorted({item.callspec.params["page"] for item in items if "page" in item.callspec.params})
    paths = {seed: folder / f"{seed}.pdf" for seed in seeds}
    for seed, path in paths.items():
        path.write_bytes(random_pages.document(seed))
    found = outcomes(inkscape, paths.values(), timeout=60 + 10 * len(paths))
    if without := [told for outcome in found.values() for told in outcome.told if "was built without PDF" in told]:
        pytest.skip(without[0])
    return {seed: found[path] for seed, path in paths.items()}


@pytest.mark.parametrize("page", SEEDS)
@pytest.mark.full
def test_a_page_looks_as_poppler_shows_it(pages, page):
    outcome = pages[page]
    if outcome.passes(LIMIT):
        return
    features = ", ".join(sorted(random_pages.page(page).features))
    pytest.fail(f"{outcome.fault or f'FLIP is {outcome.error:.4f}'} of a page with: {features}")


def test_a_seed_gives_the_same_page():
    pages = [random_pages.document(seed) for seed in range(20)]
    assert pages == [random_pages.document(seed) for seed in range(20)]
    assert len(set(pages)) == 20


@pytest.mark.parametrize("feature", (*random_pages.FEATURES, *random_pages.BEYOND_POPPLER))
@pytest.mark.full(all_but=1)
def test_a_feature_is_left_out_by_its_name(feature):
    others = set(random_pages.FEATURES) - {feature}
    # The first line of a table is taken where no other one may be.
    assert all(feature not in random_pages.page(seed, others).features for seed in range(20))


def test_every_feature_comes():
    seen = set().union(*(random_pages.page(seed).features for seed in range(400)))
    assert seen == set(random_pages.FEATURES)
