"""The option --once: what holds every promise once, which is what scripts/test runs."""

from collections import Counter


def pytest_addoption(parser):
    parser.addoption("--once", action="store_true", help="leave out what is marked `full`")


def pytest_collection_modifyitems(config, items):
    """A marker `full` leaves a test out, and `full(all_but=N)` all but its first N cases."""
    if not config.getoption("--once"):
        return
    cases, kept, left_out = Counter(), [], []
    for item in items:
        function = item.nodeid.partition("[")[0]
        cases[function] += 1
        marker = item.get_closest_marker("full")
        is_kept = marker is None or cases[function] <= marker.kwargs.get("all_but", 0)
        (kept if is_kept else left_out).append(item)
    config.hook.pytest_deselected(items=left_out)
    items[:] = kept
