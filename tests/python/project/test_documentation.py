"""Links on the pages of the documentation lead somewhere, and their lines can be read."""

import re

import pytest

from built import ROOT

PAGES = sorted([*(ROOT / "docs").rglob("*.md"), *(ROOT / "samples").rglob("*.md"), ROOT / "README.md"])
LINK = re.compile(r"\[(?:[^\[\]]|\[[^\]]*\])*\]\(([^)\s]+)\)")


def anchors(page):
    """The anchors that headings of a page have."""
    headings = re.findall(r"^#+ (.*)$", page.read_text(), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", re.sub(r"[`*]", "", h).lower()).strip().replace(" ", "-") for h in headings}


@pytest.mark.parametrize("page", PAGES, ids=lambda p: p.relative_to(ROOT).as_posix())
def test_links_lead_somewhere(page):
    for target in LINK.findall(page.read_text()):
        if re.match(r"\w+:", target):
            continue
        path, _, anchor = target.partition("#")
        other = (page.parent / path).resolve() if path else page
        assert other.exists(), target
        assert not anchor or other.suffix != ".md" or anchor in anchors(other), target


@pytest.mark.parametrize("page", PAGES, ids=lambda p: p.relative_to(ROOT).as_posix())
def test_lines_can_be_read(page):
    """At most 120 characters, in tables 200; pictures with what they show, and code, are as long as they are."""
    code = False
    for number, line in enumerate(page.read_text().splitlines(), 1):
        code ^= line.lstrip().startswith("```")
        if code or line.lstrip().startswith("!["):
            continue
        assert len(line) <= (200 if line.startswith("|") else 120), f"{page.name}:{number}"
