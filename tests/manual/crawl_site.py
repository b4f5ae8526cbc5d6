"""Walks a built site in Chromium as a reader does: python crawl_site.py FOLDER [--page PAGE] [--pictures FOLDER].

Every page is opened at a desk's and at a phone's width. Told are links and pictures that lead nowhere or out of the
site, pages wider than a phone, what the browser complains about, and what axe finds against WCAG 2.1 A and AA. With
`--find WORD PAGE`, the word is typed into the search beside the page's index, and has to find the page.
"""

import argparse
import sys
import threading
from contextlib import suppress
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from importlib.resources import files
from pathlib import Path
from urllib.parse import urldefrag, urlsplit

from selenium import webdriver
from selenium.common.exceptions import TimeoutException
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.support.ui import WebDriverWait

DESK, PHONE = (1280, 900), (390, 844)
"""Width and height of windows, px."""

SLOWEST_S = 600
"""The page of all public names takes axe two minutes on a machine that has other work."""

SEARCH_S = 30

AXE = """
const done = arguments[arguments.length - 1];
axe.run(document, {runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa"]})
   .then(found => done(found.violations.map(v => v.id + ": " + v.nodes.map(n => n.target.join(" ")).join(", "))));
"""
LINKS = "return [...document.querySelectorAll('a[href]')].map(a => a.href)"
BROKEN = "return [...document.images].filter(i => !i.complete || !i.naturalWidth).map(i => i.src)"
ANCHOR = "return document.getElementById(arguments[0]) !== null"
SEARCHED = "return document.querySelector('#search-results .search-summary')?.innerText"
FOUND = "return [...document.querySelectorAll('#search-results li > a')].map(a => a.href.split(/[?#]/)[0])"
WIDER = "return document.documentElement.scrollWidth - window.innerWidth"


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *_):
        """Nothing."""


def main() -> None:
    """Exit with what is wrong, a line each."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("site", type=Path)
    parser.add_argument("--page", default="", help="look at this page alone")
    parser.add_argument("--pictures", type=Path)
    parser.add_argument("--find", nargs=2, action="append", default=[], metavar=("WORD", "PAGE"))
    arguments = parser.parse_args()
    # below a folder, as sites are published, so that a link can lead out of it
    site = arguments.site.resolve()
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(_Quiet, directory=str(site.parent)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    home = f"http://127.0.0.1:{server.server_port}/{site.name}/"
    pages, wrong = (
        ([], find(home, arguments.find))
        if arguments.find
        else crawl(home, arguments.pictures, arguments.page)
    )
    server.shutdown()
    print(f"{len(pages)} pages")
    sys.exit("\n".join(wrong) or None)


def opened() -> webdriver.Chrome:
    """A browser that keeps what pages complain about."""
    options = webdriver.ChromeOptions()
    for flag in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(options=options, service=Service("/usr/bin/chromedriver"))
    browser.set_script_timeout(SLOWEST_S)
    browser.command_executor.client_config.timeout = SLOWEST_S
    return browser


def find(home: str, searches: list[list[str]]) -> list[str]:
    """What is wrong with the search for words that a reader types, each with the page that it has to find."""
    wrong, browser = [], opened()
    try:
        for word, page in searches:
            language = page.partition("/")[0] + "/" if page.startswith(("de/", "zh_CN/")) else ""
            browser.get(f"{home}{language}index.html")
            browser.find_element("css selector", "input[name=q]").send_keys(f"{word}\ue007")
            with suppress(TimeoutException):
                WebDriverWait(browser, SEARCH_S).until(lambda browser: browser.execute_script(SEARCHED))
            found = browser.execute_script(FOUND)
            if f"{home}{page}" not in found:
                wrong.append(f"{word}: {page} is not found, but {found}")
            wrong += [f"{word}: {entry['message']}" for entry in browser.get_log("browser")]
    finally:
        browser.quit()
    return wrong


def crawl(home: str, pictures: Path | None, only: str = "") -> tuple[list[str], list[str]]:
    """Every page that links lead to from the first, or one page alone, and what is wrong with them."""
    browser = opened()
    axe = files("axe_core_python").joinpath("axe.min.js").read_text(encoding="utf-8")
    waiting, pages, wrong, targets = [home + (only or "index.html")], [], [], set()
    try:
        while waiting:
            page = waiting.pop()
            pages.append(page)
            name = page.removeprefix(home)
            for width, height in (PHONE, DESK):
                browser.set_window_size(width, height)
                browser.get(page)
                if browser.execute_script(WIDER) > 0:
                    wrong.append(f"{name}: wider than {width} px")
                browser.execute_script(axe)
                wrong += [f"{name}, {width} px: {one}" for one in browser.execute_async_script(AXE)]
                if pictures is not None:
                    pictures.mkdir(parents=True, exist_ok=True)
                    browser.save_screenshot(pictures / f"{name.replace('/', '-')}-{width}.png")
            wrong += [f"{name}: no picture {one}" for one in browser.execute_script(BROKEN)]
            text = [entry["message"] for entry in browser.get_log("browser")]
            wrong += [
                f"{name}: {one}" for one in text if "/favicon.ico" not in one
            ]  # asked for where a page has none
            for link in browser.execute_script(LINKS):
                if not link.startswith(home):
                    if urlsplit(link).netloc == urlsplit(home).netloc:
                        wrong.append(f"{name}: {link} is not of this site")
                    continue
                file, anchor = urldefrag(link)
                targets.add((name, file, anchor))
                if not only and file.endswith(".html") and file not in pages and file not in waiting:
                    waiting.append(file)
        for name, file, anchor in sorted(targets, key=lambda one: one[1:]):
            if file.endswith(".html") and anchor:
                if browser.current_url != file:
                    browser.get(file)
                if not browser.execute_script(ANCHOR, anchor):
                    wrong.append(f"{name}: nothing called {anchor} in {file.removeprefix(home)}")
    finally:
        browser.quit()
    return pages, wrong


if __name__ == "__main__":
    main()
