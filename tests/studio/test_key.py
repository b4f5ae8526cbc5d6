"""The key of the studio in Chromium: where it is kept, and that pages of other servers do without it."""

import threading
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import pytest

from elastica_cad.web.saved_design import compose_design
from tests.studio.browser import chromium
from tests.studio.conftest import design, link, running, wave

STRANGER = """
const [studio, done] = arguments, tried = {};
const note = (name) => [(value) => { tried[name] = value; }, (problem) => { tried[name] = `${problem}`; }];
const talk = (first) => new Promise((resolve) => {
  const socket = new WebSocket(`${studio.replace("http", "ws")}talk`);
  socket.onopen = () => socket.send(first);
  socket.onmessage = ({ data }) => resolve(data);
  socket.onclose = () => resolve("closed");
});
const framed = new Promise((resolve) => {
  const frame = document.createElement("iframe");
  frame.onload = () => resolve(`${frame.contentDocument?.body.innerText}`);
  frame.src = studio;
  document.body.append(frame);
});
const form = Object.assign(document.createElement("form"), { action: studio, method: "post", target: "posted" });
document.body.append(form);
form.submit();
const other = window.open(studio);
const taken = (address, mode) => fetch(address, { mode, credentials: "include" }).then((got) => got.text());
await Promise.all([
  taken(studio, "cors").then(...note("fetch")), taken(`${studio}page.js`, "no-cors").then(...note("blind")),
  talk("guess").then(...note("socket")), talk('{"do": "open"}').then(...note("question")),
  framed.then(...note("frame")),
]);
try { tried.opened = other.document.body.innerText; } catch (problem) { tried.opened = `${problem}`; }
tried.cookies = document.cookie;
tried.kept = Object.values(sessionStorage).join() + Object.values(localStorage).join();
done(tried);
"""
"""Ways in which a page of another server could read the design or the key of the studio at `arguments[0]`."""


@contextmanager
def stranger():
    """Another server on this computer: its address, and all that browsers sent to it."""
    received = []

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self):
            received.append(f"{self.path}\n{self.headers}")
            self.send_response(200)
            self.send_header("Content-Type", "text/html")
            self.end_headers()
            self.wfile.write(b"<!doctype html><title>stranger</title><body></body>")

        def log_message(self, *_):
            pass

    with ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/", received
        server.shutdown()


def seen_addresses(studio):
    """The addresses that this tab shows, goes back to, or loaded anything from."""
    return studio.browser.execute_script(
        "return [location.href, document.referrer, ...navigation.entries().map(entry => entry.url),"
        " ...performance.getEntriesByType('resource').map(entry => entry.name)].join(' ')"
    )


def test_pages_of_other_servers_get_neither_key_nor_design(tmp_path):
    path = tmp_path / "arch.toml"
    path.write_text(compose_design(design()))
    before = path.read_bytes()
    with running(path, cwd=tmp_path) as server, chromium(tmp_path) as studio:
        studio.open(server.address)
        assert server.key not in seen_addresses(studio)
        assert studio.browser.get_cookies() == []
        home = f"http://{server.host}/"
        for _ in range(2):
            with stranger() as (elsewhere, received):
                studio.browser.switch_to.new_window("tab")
                studio.browser.get(elsewhere)
                tried = studio.browser.execute_async_script(f"(async () => {{{STRANGER}}})()", home)
                assert server.key not in f"{tried} {received}"
                assert "max_width" not in str(tried)
                assert "page.js" not in str(tried)
                assert (tried["socket"], tried["question"], tried["cookies"]) == ("closed", "closed", "")
        assert path.read_bytes() == before


@pytest.mark.campaign
def test_the_key_is_kept_for_the_tab_alone(server, tmp_path):
    with chromium(tmp_path) as studio:
        browser = studio.browser
        granted = ["clipboardReadWrite", "clipboardSanitizedWrite"]
        browser.execute_cdp_cmd("Browser.grantPermissions", {"permissions": granted})
        studio.open(server.address)
        studio.start("arch")
        browser.refresh()
        studio.until(lambda: studio.verdict().startswith("It can be made"))
        studio.tool("link")
        studio.until(lambda: studio.text(".said") == "Copied")
        copied = browser.execute_script("return navigator.clipboard.readText()")
        assert copied == browser.current_url
        assert copied.startswith(f"http://{server.host}/#")
        assert server.key not in seen_addresses(studio)

        browser.switch_to.new_window("tab")
        for address in (f"http://{server.host}/", f"http://{server.host}/#key=guess", copied):
            browser.get(address)
            studio.until(lambda: "Open the address that elastica studio printed last" in studio.text("#shut"))
        browser.get(server.address)  # typed in this tab, whose design stays
        studio.until(lambda: studio.verdict().startswith("It can be made"))
        assert browser.current_url == copied
        browser.get(f"http://{server.host}/#{link(wave())}")  # so is the link of another design
        studio.until(lambda: studio.verdict() == "It cannot be made")
        assert server.key not in seen_addresses(studio)
        assert server.key not in str(browser.execute_script("return {...localStorage}"))


@pytest.mark.campaign
def test_a_tab_without_storage_works_until_it_is_loaded_again(server, tmp_path):
    with chromium(tmp_path) as studio:
        forbidden = (
            "Object.defineProperty(window, 'sessionStorage', { get() { throw new Error('forbidden'); } })"
        )
        studio.browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": forbidden})
        studio.open(server.address)
        studio.start("arch")
        assert server.key not in seen_addresses(studio)
        studio.browser.refresh()
        studio.until(lambda: "Open the address that elastica studio printed last" in studio.text("#shut"))
