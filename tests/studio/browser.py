"""The studio in Chromium, by mouse, keyboard and sight, as a person uses it."""

import time
from contextlib import contextmanager, suppress
from importlib.resources import files

import numpy as np
from selenium import webdriver
from selenium.common.exceptions import StaleElementReferenceException
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import Select

AXE = """
const done = arguments[arguments.length - 1];
axe.run(document, {runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa"]})
   .then(found => done(found.violations.map(v => v.id + ": " + v.nodes.map(n => n.target.join(" ")).join(", "))));
"""

TIMED = """
window.painted = [];
let moved = 0;
addEventListener("pointermove", event => { moved = event.timeStamp; }, true);
new MutationObserver(() => {
  const since = moved;
  requestAnimationFrame(() => setTimeout(() => window.painted.push(performance.now() - since)));
}).observe(document.querySelector("g.strip"), { childList: true });
"""
"""Milliseconds from the last move of the pointer to each strip that is painted."""


@contextmanager
def chromium(downloads, size=(1400, 1000), language="en"):
    options = webdriver.ChromeOptions()
    # WebGL without a graphics card; the page itself is composed as on any machine without one, not through WebGL
    for flag in (
        "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader", "--disable-gpu-compositing",
        f"--window-size={size[0]},{size[1]}", f"--lang={language}",
    ):  # fmt: skip
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    options.add_experimental_option(
        "prefs", {"download.default_directory": str(downloads), "intl.accept_languages": language}
    )
    browser = webdriver.Chrome(options=options, service=Service("/usr/bin/chromedriver"))
    browser.set_script_timeout(60)
    try:
        yield Studio(browser, downloads)
    finally:
        browser.quit()


class Studio:
    def __init__(self, browser, downloads):
        self.browser, self.downloads = browser, downloads

    def open(self, address):
        self.browser.get(address)
        self.until(lambda: self.all(".tools button") and "#" in self.browser.current_url)

    def until(self, seen, seconds=60):
        """What `seen` gives once that is something."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if found := seen():
                return found
            time.sleep(0.05)
        raise AssertionError(f"not seen in {seconds} s; the page says {self.text('.told')!r}")

    def all(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def text(self, selector):
        read = "return [...document.querySelectorAll(arguments[0])].map(one => one.innerText).join(' ')"
        return self.browser.execute_script(read, selector)

    def click(self, text, selector="button"):
        def clicked():
            with suppress(StaleElementReferenceException):  # the page has made its buttons anew meanwhile
                (one,) = [one for one in self.all(selector) if one.text == text and one.is_displayed()]
                one.click()
                return True

        self.until(clicked)

    def tool(self, name):
        """Press a tool; on a phone the rare ones are behind More."""
        (button,) = self.all(f"[data-do={name}]")
        if not button.is_displayed():
            self.all("[data-do=more]")[0].click()
        button.click()

    def start(self, name):
        """Begin with one of the examples."""
        before, empty = self.browser.current_url, None if self.all(".yes, .care, .no") else self.verdict()
        self.all("[data-do=starts]")[0].click()
        self.until(lambda: self.all(f"[data-name={name}]"))[0].click()
        self.until(lambda: self.browser.current_url != before)
        self.until(lambda: self.verdict() not in ("", empty))

    def mouse(self, kind, at, **more):
        more = {"button": "left", "buttons": 1} | more
        self.browser.execute_cdp_cmd(
            "Input.dispatchMouseEvent", {"type": kind, "x": at[0], "y": at[1], **more}
        )

    def press(self, at, *ways):
        """Press the mouse there, lead it to places so far away, let it go."""
        self.mouse("mouseMoved", at, buttons=0)
        self.mouse("mousePressed", at, clickCount=1)
        places = [np.add(at, way) for way in ways]
        for place in places:
            self.mouse("mouseMoved", place)
        self.mouse("mouseReleased", places[-1] if places else at, clickCount=1)

    def touch(self, *fingers):
        """Lead fingers, each from its first place to its last, and lift them."""

        def send(kind, places):
            points = [{"x": float(x), "y": float(y), "id": k} for k, (x, y) in enumerate(places)]
            self.browser.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

        steps = list(zip(*fingers, strict=True))
        for k in range(len(fingers)):  # one comes down after the other
            send("touchStart", steps[0][: k + 1])
        for places in steps[1:]:
            send("touchMove", places)
        send("touchEnd", [])

    def drop(self, path):
        """Drop a file on the drawing, as from the desktop."""
        x, y = self.center(".plane > svg").tolist()
        data = {"items": [], "files": [str(path)], "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "drop"):
            self.browser.execute_cdp_cmd(
                "Input.dispatchDragEvent", {"type": kind, "x": x, "y": y, "data": data}
            )

    def box(self, selector):
        return self.browser.execute_script(
            "const r = document.querySelector(arguments[0]).getBoundingClientRect();"
            "return [r.x, r.y, r.width, r.height]",
            selector,
        )

    def center(self, selector):
        x, y, wide, high = self.box(selector)
        return np.array([x + wide / 2, y + high / 2])

    def point(self, k):
        return self.center(f"g.points circle:nth-child({k})")

    def verdict(self):
        return self.text(".verdict strong")

    def shape(self, layer="strip"):
        """What the drawing shows in a layer, to tell whether it has changed."""
        return self.browser.execute_script(
            "return document.querySelector(arguments[0]).innerHTML", f"g.{layer}"
        )

    def scene(self):
        """The picture of the strip in space."""
        return self.all(".scene canvas")[0].screenshot_as_png

    def choose(self, selector, value):
        Select(self.all(selector)[0]).select_by_value(value)

    def type(self, selector, text):
        (one,) = self.all(selector)
        one.send_keys("\ue009a\ue000", text or "\ue003", "\t")  # Ctrl-A, the text or Backspace, Tab

    def download(self, kind, name):
        if self.browser.execute_script("return !document.querySelector('.downloads').open"):
            self.all(".downloads summary")[0].click()
        self.all(f".downloads [data-kind={kind}]")[0].click()
        path = self.downloads / name
        self.until(lambda: path.exists() and not list(self.downloads.glob("*.crdownload")), 120)
        return path

    def complaints(self):
        self.browser.execute_script(
            files("axe_core_python").joinpath("axe.min.js").read_text(encoding="utf-8")
        )
        return self.browser.execute_async_script(AXE)

    def logged(self):
        """What the browser complains of, but for what composing without a graphics card costs."""
        text = [entry["message"] for entry in self.browser.get_log("browser")]
        return [one for one in text if "GPU stall due to ReadPixels" not in one]
