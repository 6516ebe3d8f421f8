"""What tests in Inkscape share: the mark that skips them where it is absent, and one that runs."""

import pytest

import inkscape_harness


def needs(*programs):
    """Skips where Inkscape, or one of the further programs, is absent."""
    reason = inkscape_harness.missing(*programs)
    return pytest.mark.skipif(bool(reason), reason=reason or "nothing is missing")


@pytest.fixture(scope="module")
def inkscape():
    """One for all tests of a file."""
    if reason := inkscape_harness.missing():
        pytest.skip(reason)
    with inkscape_harness.Inkscape() as running:
        yield running
