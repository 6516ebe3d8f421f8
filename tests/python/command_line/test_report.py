"""The report page, in a real browser: everything B.1 and B.3 of the paper show, from one file."""

import json
import re

import pytest

import browser as browsers
from browser import one_chromium  # noqa: F401
from built import SAMPLES
from hemesh_files import grid
from program import meshes, printed, refused
from report_page import Page

import gradmesh

FRUIT = SAMPLES / "fruit.svg"
COARSE = ("--resolution", 150)


def page_data(path):
    """What the page's scripts work with."""
    return json.loads(re.search(r'<script id="data".*?>(.*?)</script>', path.read_text(), re.S)[1])


class Fruit:
    """The fruit, simplified, and the page about it."""

    def __init__(self, folder):
        names = ("after.svg", "run.json", "prices.json", "report.html")
        self.after, self.run, self.prices, self.page = (folder / name for name in names)
        keep = ("--report", self.run, "--save-analysis", self.prices)
        printed("simplify", FRUIT, "-o", self.after, *COARSE, "--method", "gqe", *keep)
        self.options = ("--run", self.run, "--load-analysis", self.prices)
        printed("report", FRUIT, self.after, "-o", self.page, *self.options)
        self.runs = json.loads(self.run.read_text())["meshes"]
        (self.told,) = self.runs
        self.data = page_data(self.page)


@pytest.fixture(scope="module")
def fruit(tmp_path_factory):
    return Fruit(tmp_path_factory.mktemp("report"))


# --- what the page holds ---


def test_the_page_tells_what_the_run_did(fruit):
    data = fruit.data
    assert data["run"] == fruit.told
    assert data["before"]["patches"] == fruit.told["patches_before"] == 132
    assert data["after"]["patches"] == fruit.told["patches_after"] < 132
    assert data["before"]["handles"] == fruit.told["handles_before"] == 660
    assert data["after"]["handles"] == fruit.told["handles_after"]
    assert data["before"]["objects"] == 1 < data["after"]["objects"] == fruit.told["objects"]
    # Resolution and metric are those of the run; the document is measured as a reader finds it.
    assert data["error"] == pytest.approx(fruit.told["error"], abs=1e-6)
    assert data["local_error"] == pytest.approx(fruit.told["local_error"], abs=1e-6)
    assert max(data["width"], data["height"]) == 150 and data["metric"] == "FLIP"
    for side, path in (("before", FRUIT), ("after", fruit.after)):
        (mesh,) = meshes(path)
        assert data[side]["elements"] == mesh["elements"]


def test_regions_are_those_of_the_analysis(fruit):
    (analysis,) = json.loads(fruit.prices.read_text())["analyses"]
    affordable = [p for p in analysis["prices"] if p[4] is not None and p[4] <= 0.01]
    regions = fruit.data["before"]["regions"]
    assert sorted(r["error"] for r in regions) == sorted(p[4] for p in affordable)
    for r in regions:
        assert len(set(r["faces"])) == r["rows"] * r["columns"] == len(r["faces"])
    assert fruit.data["after"]["regions"] == []


def test_fits_lower_the_prices_of_regions(fruit, tmp_path):
    assert all(r["fitted"] is None for r in fruit.data["before"]["regions"])  # gqe does not fit
    after, told, page = (tmp_path / name for name in ("best.svg", "best.json", "best.html"))
    printed("simplify", FRUIT, "-o", after, *COARSE, "--method", "best", "--report", told)
    printed("report", FRUIT, after, "-o", page, "--run", told)
    regions = page_data(page)["before"]["regions"]
    assert all(r["fitted"] <= r["error"] for r in regions)
    shares = sorted(r["fitted"] / r["error"] for r in regions if r["error"] > 0)
    assert shares[len(shares) // 2] < 0.9


def test_the_same_page_again(fruit, tmp_path):
    again = tmp_path / "again.html"
    printed("report", FRUIT, fruit.after, "-o", again, *fruit.options)
    assert again.read_bytes() == fruit.page.read_bytes()
    # Without the files, the prices are worked out, and nothing is known of the run.
    alone = tmp_path / "alone.html"
    printed("report", FRUIT, fruit.after, "-o", alone, *COARSE)
    assert page_data(alone) == {**fruit.data, "run": None}


def test_python_writes_the_same_page(fruit, tmp_path):
    before, after = gradmesh.load(FRUIT), gradmesh.load(fruit.after)
    page = tmp_path / "page.html"
    gradmesh.report(before, after, page, run=fruit.runs, load_analysis=fruit.prices)
    assert page.read_bytes() == fruit.page.read_bytes()
    # What is given counts more than what the run says.
    gradmesh.report(before, after, page, "pear", run=fruit.runs, metric="ssim", epsilon=0.004, resolution=100)
    data = page_data(page)
    assert (data["metric"], data["epsilon"], data["height"]) == ("1 - SSIM", 0.004, 100)
    assert data["run"] == fruit.told
    results = gradmesh.simplify(before, method="gqe", resolution=150, preview=True)
    gradmesh.report(before, after, page, run=results)
    told = {**page_data(page)["run"], "seconds": fruit.told["seconds"]}
    assert told == {**fruit.told, "changed": True, "refused": None}


def test_python_may_end_the_pricing(fruit, tmp_path):
    page = tmp_path / "page.html"
    before, after = gradmesh.load(FRUIT), gradmesh.load(fruit.after)
    gradmesh.report(before, after, page, resolution=150, progress=lambda *_: False)
    data = page_data(page)
    assert data["run"] is None and data["before"]["regions"] == []
    assert data["error"] == pytest.approx(fruit.data["error"])


def test_python_refuses_as_the_command_line_does(fruit, tmp_path):
    page = tmp_path / "page.html"
    one, two = gradmesh.load(FRUIT), gradmesh.load(SAMPLES / "two.svg")
    with pytest.raises(gradmesh.InputError, match="2 meshes, choose one with its id"):
        gradmesh.report(two, two, page)
    with pytest.raises(gradmesh.InputError, match="no report of gradmesh simplify"):
        gradmesh.report(one, one, page, run=[{"id": "pear", "epsilon": "much"}])
    with pytest.raises(gradmesh.InputError, match="says nothing of the mesh pear"):
        gradmesh.report(one, one, page, run=[{"id": "apple"}])
    for options, words in [
        ({"metric": "taste"}, "metric"),
        ({"resolution": 3}, "resolution"),
        ({"epsilon": -1}, "epsilon"),
    ]:
        with pytest.raises(ValueError, match=words):
            gradmesh.report(one, one, page, **options)
    assert not page.exists()


def test_meshes_of_both_kinds(tmp_path):
    leaf, page, drawing = (tmp_path / name for name in ("leaf.hemesh", "page.html", "leaf.svg"))
    leaf.write_text(grid(3, 3))
    printed("convert", leaf, drawing)
    printed("report", leaf, drawing, "-o", page, "--metric", "ssim", *COARSE)
    data = page_data(page)
    assert (data["id"], data["metric"]) == ("leaf", "1 - SSIM")
    assert (data["before"]["color_model"], data["after"]["color_model"]) == ("bicubic", "bilinear")
    assert 0 < data["error"] < 0.01
    # Both lie in the same place.
    boxes = []
    for side in ("before", "after"):
        numbers = [x for curve in data[side]["curves"] for x in curve]
        boxes.append([min(numbers[0::2]), min(numbers[1::2]), max(numbers[0::2]), max(numbers[1::2])])
    assert boxes[0] == pytest.approx(boxes[1], abs=1)


NO_REPORT = "this is no report of gradmesh simplify."


@pytest.mark.parametrize(
    "content, sentence",
    [
        ("", NO_REPORT),
        ("[]", NO_REPORT),
        ('{"meshes": []}', "this report says nothing of the mesh pear."),
        ('{"meshes": [{"id": "pear", "epsilon": "small"}]}', NO_REPORT),
        ('{"meshes": [{"id": "pear", "metric": "taste"}]}',
         "the metric 'taste' is not known; there are: flip, ssim."),
    ],
)  # fmt: skip
def test_other_files_are_no_reports(tmp_path, content, sentence):
    path, page = tmp_path / "run.json", tmp_path / "page.html"
    path.write_text(content)
    assert refused("report", FRUIT, FRUIT, "-o", page, "--run", path) == f"{path}: {sentence}"
    assert not page.exists()


# --- what a person sees and does ---


@pytest.fixture
def page(chromium, fruit):
    page = Page(chromium, fruit.page, fruit.data)
    yield page
    page.check()


def by_id(mesh, kind):
    return {e["id"]: e for e in mesh["elements"][kind]}


def test_the_head_of_the_page(page, fruit):
    after = fruit.data["after"]
    assert page.browser.title == f"pear: 660 \u2192 {after['handles']} handles"
    assert page.text("#files") == "fruit.svg \u2192 after.svg"
    summary = page.text("#summary")
    for key in ("handles", "patches", "objects", "points", "t_junctions"):
        assert f"{fruit.data['before'][key]} \u2192 {after[key]}" in summary
    assert float(page.text("#error")) == pytest.approx(fruit.told["error"], rel=0.01)
    local = fruit.told["local_error"]
    assert page.text("#local-error") == f"up to {local:.3g} in 32 \u00d7 32 px"
    options = page.texts("#options > div")
    assert "Method\ngqe" in options and "Largest error (epsilon)\n0.01" in options


def test_pointing_at_a_patch_walks_through_its_regions(page, fruit):
    page.hover("before", page.inside("before", 65))
    assert page.mark("before", "hover") == "patch/65"
    page.click("before", page.inside("before", 65))
    assert page.selected == "Patch 65" and page.mark("before") == "patch/65"
    assert page.text("#list [aria-selected=true] b") == "65"
    regions = [r for r in fruit.data["before"]["regions"] if 65 in r["faces"]]
    assert len(regions) > 3
    borders = set()
    for i, region in enumerate([*regions, regions[0]]):
        told = page.text("#region")
        assert f"{region['rows']} \u00d7 {region['columns']} patches" in told
        error = re.search(r"error (\S+)", told)[1].replace("\u2212", "-")
        assert float(error) == pytest.approx(region["error"], rel=0.01)
        assert f"{i % len(regions) + 1} of {len(regions)}" in told
        borders.add(page.js("document.querySelector('[data-side=before] .region-border').getAttribute('d')"))
        page.press("[data-action=Next]")
    assert len(borders) == len(regions)
    page.press("[data-action=Previous]")
    assert f"1 of {len(regions)}" in page.text("#region")


def test_pointing_at_an_edge_and_a_point(page, fruit):
    halfedge = fruit.data["before"]["elements"]["faces"][65]["halfedges"][0]
    page.click("before", page.curve("before", halfedge))
    sides = by_id(fruit.data["before"], "halfedges")
    assert page.selected in {f"Half-edge {h}" for h in (halfedge, sides[halfedge]["twin"])}
    page.click("before", page.curve("before", halfedge, 0))
    assert page.selected == f"Point {sides[halfedge]['origin']}"


@pytest.mark.parametrize("side", ["before", "after"])
@pytest.mark.full
def test_buttons_lead_to_next_prev_twin_and_parent(page, fruit, side):
    halfedges = by_id(fruit.data[side], "halfedges")
    seen = {"next": 0, "prev": 0, "twin": 0, "parent": 0}
    for start in list(halfedges)[:: max(1, len(halfedges) // 12)] + list(halfedges)[-3:]:
        for link in seen:
            page.js("void (location.hash = arguments[0])", f"#{side}/halfedge/{start}")
            assert page.selected == f"Half-edge {start}" and page.mark(side) == f"halfedge/{start}"
            to = halfedges[start][link]
            button = page.browser.find_element("css selector", f"[data-action={link}]")
            assert button.is_enabled() == (to is not None)
            if to is None:
                assert button.text == f"{link}\nnone"
                continue
            button.click()
            seen[link] += 1
            assert page.selected == f"Half-edge {to}" and page.mark(side) == f"halfedge/{to}"
            assert page.js("location.hash") == f"#{side}/halfedge/{to}"
    if side == "before":
        assert seen.pop("parent") == 0  # a plain grid
    assert all(seen.values())


def test_junctions_know_their_stems(page, fruit):
    junction = next(p for p in fruit.data["after"]["elements"]["points"] if p["stem"] is not None)
    page.open(f"#after/point/{junction['id']}")
    assert "T-junction" in page.text("#details")
    page.press("[data-action=stem]")
    assert page.selected == f"Half-edge {junction['stem']}"
    parent = by_id(fruit.data["after"], "halfedges")[junction["stem"]]["parent"]
    page.press("[data-action=parent]")
    children = by_id(fruit.data["after"], "halfedges")[parent]["children"]
    assert [t for t in page.texts("#details .link") if re.match("(bar|stem)\n", t)] == [
        f"{kind}\nHalf-edge {child}" for kind, child in zip(["bar", "stem"] * len(children), children)
    ]


def test_the_lists_work_by_keyboard(page, fruit):
    page.press("#tabs [data-kind=halfedge]")
    count = len(fruit.data["before"]["elements"]["halfedges"])
    assert page.js("document.querySelectorAll('#list li').length") == count
    for keys, expected in ((page_keys("END"), count - 1), (page_keys("ARROW_UP"), count - 2), (page_keys("HOME"), 0)):
        page.keys("#list", keys)
        assert page.selected == f"Half-edge {expected}"
        assert page.mark("before") == f"halfedge/{expected}"
    page.keys("#tabs [data-kind=halfedge]", page_keys("ARROW_RIGHT"))
    assert page.text("#list li").startswith("0")
    page.keys("#list", page_keys("ARROW_DOWN"))
    assert page.selected == "Point 0"
    page.press("#sides [data-side=after]")
    assert page.selected.startswith("Patch") and page.mark("after") and not page.mark("before")
    # A button that leads on keeps the focus, to walk around the patch.
    page.open("#before/halfedge/240")
    order = []
    for _ in range(4):
        page.keys("[data-action=next]", page_keys("ENTER"))
        assert page.js("document.activeElement.dataset.action") == "next"
        order.append(page.selected)
    assert order == [f"Half-edge {h}" for h in (241, 242, 243, 240)]


def page_keys(name):
    from selenium.webdriver.common.keys import Keys

    return getattr(Keys, name)


def test_the_hermite_matrix(page, fruit):
    page.open("#before/patch/17")
    values = fruit.data["before"]["hermite"][17]

    def expect(part):
        cells = [cell.replace("\u2212", "-").split("\n") for cell in page.texts(".hermite td")]
        assert len(cells) == 16
        assert [c[0] for c in cells[:5]] == ["m0", "m0v", "m2v", "m2", "m0u"]
        for cell, value in zip(cells, values):
            assert [float(x) for x in cell[1:]] == pytest.approx(value[part], rel=1e-3, abs=1e-3)

    expect(slice(2))
    page.press(".details .choice button:last-child")
    expect(slice(2, 5))


def clip(page):
    return page.js("getComputedStyle(document.querySelector('[data-side=after]')).clipPath")


def shown(page):
    return [side for side in ("before", "after", "errors")
            if page.js(f"document.querySelector('.pane[data-side={side}]').offsetWidth > 0")]  # fmt: skip


def test_the_slider_moves(page):
    assert shown(page) == ["before", "after"] and clip(page) == "none"
    page.press("[data-view=slider]")
    assert shown(page) == ["before", "after"] and clip(page).endswith(" 50%)")
    box = page.js("document.getElementById('panes').getBoundingClientRect().toJSON()")
    middle = box["y"] + box["height"] / 2
    page.drag([(box["x"] + share * box["width"], middle) for share in (0.5, 0.4, 0.3, 0.2)])
    assert float(re.search(r"([\d.]+)%\)$", clip(page))[1]) == pytest.approx(20, abs=0.5)
    page.keys("#divider", page_keys("ARROW_RIGHT"))
    assert clip(page).endswith(" 22%)")
    page.keys("#divider", page_keys("END"))
    assert clip(page).endswith(" 100%)")
    # On the left of the divider is the mesh before, to be pointed at.
    page.click("before", page.inside("before", 65))
    assert page.selected == "Patch 65" and page.js("location.hash") == "#before/patch/65"
    page.keys("#divider", page_keys("HOME"))
    page.click("after", page.inside("after", 5))
    assert page.js("location.hash") == "#after/patch/5"


def test_the_error_map_has_a_legend(page, fruit):
    assert page.js("document.getElementById('legend').hidden")
    page.press("[data-view=errors]")
    assert shown(page) == ["errors"]
    ticks = [float(t) for t in page.texts("#legend .ticks span")]
    assert ticks[0] == 0 and ticks[-1] == pytest.approx(fruit.data["errors"]["largest"], rel=0.1)
    assert ticks == sorted(ticks)
    page.click("errors", page.inside("after", 7))
    assert page.js("location.hash") == "#after/patch/7" and page.mark("errors") == "patch/7"


def test_buttons_lead_to_the_worst_places(page, fruit):
    worst = fruit.data["worst"]
    assert worst and worst == sorted(worst, key=lambda place: -place["error"])
    assert [float(t) for t in page.texts("#worst button")] == pytest.approx(
        [place["error"] for place in worst], rel=0.1
    )
    page.press("#worst button")
    view_box = page.js("document.querySelector('[data-side=before] svg').getAttribute('viewBox')")
    x, y, width, height = map(float, view_box.split())
    assert x <= worst[0]["x"] <= x + width and width < 0.7 * fruit.data["width"]
    assert y <= worst[0]["y"] <= y + height and height < 0.7 * fruit.data["height"]


def test_outlines_and_zoom(page):
    view_box = "document.querySelector('[data-side=before] svg').getAttribute('viewBox')"
    whole = [float(x) for x in page.js(view_box).split()]
    assert whole == [0, 0, page.data["width"], page.data["height"]]
    page.press("#zoom-in")
    part = [float(x) for x in page.js(view_box).split()]
    assert part[2] == pytest.approx(whole[2] / 1.5) and part[0] > 0
    x, y = page.on_screen("before", page.inside("before", 65))
    page.drag([(x + step, y) for step in (0, 20, 40)])
    assert float(page.js(view_box).split()[0]) < part[0]
    assert page.selected == "Patch 0"  # which was no click
    page.press("#zoom-fit")
    assert page.js(view_box) == " ".join(f"{x:g}" for x in whole)
    outlines = "getComputedStyle(document.querySelector('.outlines')).display"
    assert page.js(outlines) != "none"
    page.press("#outlines")
    assert page.js(outlines) == "none"


#: Elements that are cut off or reach out of the page.
CLIPPED = """
(() => [...document.querySelectorAll("h1,h2,h3,p,button,dt,dd,td,label,figcaption,.ticks span,li")]
  .filter((e) => e.offsetWidth && !e.closest(".list"))
  .filter((e) => e.scrollWidth > e.clientWidth + 1 && getComputedStyle(e).display !== "inline"
               || e.getBoundingClientRect().right > document.documentElement.clientWidth)
  .map((e) => e.outerHTML))()
"""


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [1200, 800, 420])
@pytest.mark.full(all_but=1)
def test_nothing_is_cut_off(page, fruit, width, scheme):
    browsers.resize(page.browser, width, 900)
    browsers.prefer_color_scheme(page.browser, scheme)
    last = fruit.data["after"]["elements"]["halfedges"][-1]["id"]
    for fragment in ("#before/patch/65", f"#after/halfedge/{last}", "#after/point/3", "#before/handle/9"):
        page.open(fragment)
        for view in ("side", "slider", "errors"):
            page.press(f"[data-view={view}]")
            assert page.js(CLIPPED) == []
            assert page.js("document.documentElement.scrollWidth") <= width
    red, green, blue = (
        int(x) for x in re.findall(r"\d+", page.js("getComputedStyle(document.body).backgroundColor"))
    )
    assert (red + green + blue < 200) == (scheme == "dark")


def test_names_cannot_break_the_page(chromium, tmp_path):
    name = "</script><img src=http://example.org/x onerror=alert(1)>&amp;"
    path, out = tmp_path / "odd.svg", tmp_path / "page.html"
    text = FRUIT.read_text().replace('id="pear"', 'id="' + name.replace("&", "&amp;").replace("<", "&lt;") + '"')
    path.write_text(text)
    printed("report", path, path, "-o", out, "--epsilon", 0, *COARSE)
    page = Page(chromium, out, page_data(out))
    assert page.text("#title") == name
    assert page.browser.title.startswith(name)
    assert page.js("document.images.length") == 0
    page.press("[data-view=errors]")
    assert page.text("#legend") == "The pictures do not differ."
    page.check()
