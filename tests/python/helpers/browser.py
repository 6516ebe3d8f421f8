"""A headless Chromium for tests of pages; absent where Debian's packages are not installed."""

import json
import shutil
from contextlib import contextmanager

import pytest

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
except ImportError:
    webdriver = None

PROGRAMS = [shutil.which(name) for name in ("chromium", "chromedriver")]

#: Why there is no browser, or nothing.
MISSING = (
    "python3-selenium is not installed" if webdriver is None
    else "" if all(PROGRAMS)
    else "chromium or chromium-driver is not installed"
)  # fmt: skip


@contextmanager
def chromium(width, height):
    """A browser whose page is so large, in pixels, and which keeps a log of all it asks for."""
    options = Options()
    options.binary_location = PROGRAMS[0]
    # Without a sandbox it runs as root too, and in containers with little shared memory.
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars"):  # fmt: skip
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    browser = webdriver.Chrome(service=Service(PROGRAMS[1]), options=options)
    try:
        resize(browser, width, height)
        yield browser
    finally:
        browser.quit()


@pytest.fixture(scope="module", name="chromium")
def one_chromium():
    """One for all tests of a file."""
    if MISSING:
        pytest.skip(MISSING)
    with chromium(1200, 900) as browser:
        yield browser


def resize(browser, width, height):
    metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)


def prefer_color_scheme(browser, scheme):
    feature = {"name": "prefers-color-scheme", "value": scheme}
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [feature]})


def requests(browser):
    """The addresses that pages have asked for since the last call."""
    messages = [json.loads(entry["message"])["message"] for entry in browser.get_log("performance")]
    return [
        m["params"]["request"]["url"] for m in messages if m["method"] == "Network.requestWillBeSent"
    ]


def complaints(browser):
    """What the console says since the last call."""
    return [entry["message"] for entry in browser.get_log("browser")]
