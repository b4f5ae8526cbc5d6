"""Two pages, a restart and edits by hand on one design file, in Chromium: nothing is lost unasked."""

import tomllib

import pytest

from elastica_cad.web.saved_design import compose_design
from tests.house.stored_files import unlinked
from tests.studio.browser import chromium
from tests.studio.conftest import design, running

pytestmark = pytest.mark.campaign


@pytest.fixture
def path(tmp_path):
    path = tmp_path / "arch.toml"
    path.write_text("# mine\n" + compose_design(design()))
    return path


def width(path):
    return tomllib.loads(path.read_text())["max_width"]


def shown(studio):
    return float(studio.browser.execute_script("return document.querySelector('#field-max_width').value"))


def linked_width(studio):
    return unlinked(studio.browser.current_url.partition("#")[2])["max_width"]


def change(studio, value):
    studio.type("#field-max_width", str(value))
    studio.until(lambda: shown(studio) == value)


def save(studio, then):
    studio.click("Save")
    return studio.until(then)


@pytest.mark.parametrize(
    "choice", ["Keep this page's design", "Use the file's design", "Keep both designs", "Close"]
)
def test_two_tabs_save_one_file(path, tmp_path, choice):
    downloads = tmp_path / "downloads"
    downloads.mkdir()
    with running(path, cwd=tmp_path) as server, chromium(downloads) as studio:
        studio.open(server.address)
        first = studio.browser.current_window_handle
        studio.browser.switch_to.new_window("tab")
        studio.open(server.address)
        change(studio, 31)
        save(studio, lambda: "Saved" in studio.text(".said"))
        studio.browser.switch_to.window(first)
        change(studio, 32)
        save(studio, lambda: studio.all("dialog[open]"))
        assert width(path) == 31
        studio.click(choice, "dialog button")
        studio.until(lambda: not studio.all("dialog[open]"))
        if choice == "Keep this page's design":
            studio.until(lambda: width(path) == 32)
            studio.until(lambda: "Saved" in studio.text(".said"))
        elif choice == "Close":
            assert shown(studio) == 32
            save(studio, lambda: studio.all("dialog[open]"))
        else:
            studio.until(lambda: shown(studio) == 31)
            if choice == "Keep both designs":
                mine = studio.until(lambda: list(downloads.glob("*.toml")))
                assert width(mine[0]) == 32
            studio.click("Undo")
            studio.until(lambda: shown(studio) == 32)
            change(studio, 33)
            save(studio, lambda: width(path) == 33)
        assert path.read_text().startswith("# mine")
        if choice != "Close":
            change(studio, 34)
            for _ in range(3):
                studio.click("Save")
            studio.until(lambda: width(path) == 34)
            studio.until(lambda: "Saved" in studio.text(".said"))
            assert not studio.all("dialog[open]")


def test_the_file_outweighs_the_address_of_a_tab_unless_the_user_says_so(path, tmp_path):
    with chromium(tmp_path) as studio:
        with running(path, cwd=tmp_path) as server:
            studio.open(server.address)
            change(studio, 35)
            studio.until(lambda: "#" in studio.browser.current_url)
            port = server.port
        studio.until(lambda: "server has stopped" in studio.text(".said"))
        assert studio.verdict() == ""
        path.write_text(path.read_text().replace("max_width = 40", "max_width = 21  # by hand"))
        with running(path, "--port", port, cwd=tmp_path) as server:
            kept = studio.browser.current_window_handle
            fragment = studio.browser.current_url.partition("#")[2]
            studio.browser.switch_to.new_window("tab")
            studio.open(f"{server.address}#{fragment}")
            assert shown(studio) == 21
            assert "differs from the file" in studio.text(".said")
            save(studio, lambda: "Saved" in studio.text(".said"))
            assert "by hand" in path.read_text()

            studio.browser.switch_to.window(kept)  # the new server has another key
            assert "server has stopped" in studio.text(".said")
            assert shown(studio) == 35
            studio.browser.get(server.address)
            studio.until(lambda: "differs from the file" in studio.text(".said"))
            assert shown(studio) == 21
            studio.until(lambda: studio.verdict().startswith("It can"))

            change(studio, 36)
            # the address follows once the page rests
            studio.until(lambda: linked_width(studio) == 36)
            studio.browser.refresh()
            studio.until(lambda: "differs from the file" in studio.text(".said"))
            assert shown(studio) == 21
            studio.click("Use it", ".said button")
            studio.until(lambda: shown(studio) == 36)
            save(studio, lambda: width(path) == 36)
            assert "by hand" in path.read_text()


def test_a_page_loaded_again_reads_the_file_again(path, tmp_path):
    with running(path, cwd=tmp_path) as server, chromium(tmp_path) as studio:
        studio.open(server.address)
        path.write_text(path.read_text().replace("max_width = 40", "max_width = 22"))
        studio.browser.get(server.address)
        studio.until(lambda: studio.all("#field-max_width") and shown(studio) == 22)
        change(studio, 23)
        save(studio, lambda: width(path) == 23)
        path.write_text("[[")
        studio.browser.get(server.address)
        studio.until(lambda: "is not a valid TOML file" in studio.text(".said"))
        studio.click("Save")
        studio.until(lambda: "is not a valid TOML file" in studio.text(".said"))
        assert path.read_text() == "[["
