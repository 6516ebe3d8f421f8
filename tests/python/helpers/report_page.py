"""The page of a report in a browser, as a person uses it."""

import browser as browsers


class Page:
    """The page about the fruit, freshly opened; what fails in it fails the test."""

    def __init__(self, browser, path, data):
        self.browser, self.data = browser, data
        browsers.resize(browser, 1200, 900)
        browsers.prefer_color_scheme(browser, "light")
        browsers.requests(browser), browsers.complaints(browser)
        self.address = path.as_uri()
        self.open()

    def open(self, fragment=""):
        self.browser.get("about:blank")
        self.browser.get(self.address + fragment)

    def js(self, script, *arguments):
        return self.browser.execute_script("return " + script.strip(), *arguments)

    def text(self, selector):
        return self.js("document.querySelector(arguments[0]).innerText", selector)

    def texts(self, selector):
        return self.js("[...document.querySelectorAll(arguments[0])].map(e => e.innerText)", selector)

    def press(self, selector):
        self.browser.find_element("css selector", selector).click()

    def keys(self, selector, *keys):
        self.browser.find_element("css selector", selector).send_keys(*keys)

    @property
    def selected(self):
        return self.text("#details h2")

    def mark(self, side, group="marks"):
        """The element that is marked in a picture."""
        return self.js(f"document.querySelector('[data-side={side}] .{group}').dataset.element")

    def on_screen(self, side, place):
        """Where a place of the picture is in the window."""
        return self.js(
            "(([x, y]) => { const svg = document.querySelector(`[data-side=${arguments[0]}] svg`);"
            " const p = new DOMPoint(x, y).matrixTransform(svg.getScreenCTM()); return [p.x, p.y]; })"
            "(arguments[1])", side, place)  # fmt: skip

    def mouse(self, kind, x, y, **more):
        event = {"type": kind, "x": x, "y": y, **more}
        self.browser.execute_cdp_cmd("Input.dispatchMouseEvent", event)

    def hover(self, side, place):
        self.mouse("mouseMoved", *self.on_screen(side, place))

    def click(self, side, place):
        self.hover(side, place)
        for kind in ("mousePressed", "mouseReleased"):
            self.mouse(kind, *self.on_screen(side, place), button="left", clickCount=1)

    def drag(self, places):
        """Drags from the first of these places of the window to the last, by way of the others."""
        self.mouse("mousePressed", *places[0], button="left", clickCount=1)
        for place in places[1:]:
            self.mouse("mouseMoved", *place, button="left", buttons=1)
        self.mouse("mouseReleased", *places[-1], button="left", clickCount=1)

    def check(self):
        """That nothing has failed, nor was asked for from elsewhere."""
        assert browsers.complaints(self.browser) == []
        strangers = [url for url in browsers.requests(self.browser)
                     if not url.startswith(("data:", "about:", self.address))]  # fmt: skip
        assert strangers == []

    # places in the picture

    def curve(self, side, halfedge, t=0.5):
        ids = [h["id"] for h in self.data[side]["elements"]["halfedges"]]
        c, s = self.data[side]["curves"][ids.index(halfedge)], 1 - t
        weights = (s**3, 3 * s * s * t, 3 * s * t * t, t**3)
        return [sum(w * c[2 * i + k] for i, w in enumerate(weights)) for k in (0, 1)]

    def inside(self, side, patch):
        sides = self.data[side]["elements"]["faces"][patch]["halfedges"]
        middles = [self.curve(side, h) for h in sides]
        return [sum(m[k] for m in middles) / 4 for k in (0, 1)]
