"""Who may talk to the server of the studio, and that nothing which is said to it ends it."""

import http.client
import json
import os
import random
import signal
import socket
import struct
import subprocess
import sys
import time

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

from elastica_cad.cli import studio_command
from elastica_cad.errors import how_to_install
from elastica_cad.web.saved_design import compose_design
from tests.command_line import run
from tests.studio.conftest import ARCH, Server, design, running


def fetched(server, path, **headers):
    """Status, headers and text of one request over a socket of its own."""
    asking = http.client.HTTPConnection("127.0.0.1", server.port, timeout=30)
    asking.putrequest("GET", path, skip_host=True)
    for name, value in ({"Host": server.host} | headers).items():
        asking.putheader(name, value)
    asking.endheaders()
    got = asking.getresponse()
    text = got.read().decode(errors="replace")
    asking.close()
    return got.status, got.headers, text


def test_the_files_of_the_page_have_a_policy_and_set_no_cookie(server):
    status, headers, text = fetched(server, "/")
    assert status == 200
    assert "page.js" in text
    assert "Set-Cookie" not in headers
    policy = headers["Content-Security-Policy"]
    assert "default-src 'none'" in policy
    assert "unsafe" not in policy
    assert all(server.key not in part for part in (text, str(headers)))


@pytest.mark.parametrize("key", ["", "guess", "\ud7ff\0", '{"do": "open"}', '{"do": "save", "mark": ""}'])
def test_without_the_key_no_question_is_answered(server, key):
    with pytest.raises(ConnectionClosed) as closed, server.page(key):
        pass
    assert closed.value.rcvd.code == 1008
    for elsewhere in (
        {"Cookie": f"elastica-studio-{server.port}={server.key}"},
        {"Authorization": server.key},
    ):
        with pytest.raises(ConnectionClosed), server.page("guess", **elsewhere):
            pass


def test_a_missing_package_comes_with_the_command_of_other_messages(monkeypatch):
    monkeypatch.setattr(studio_command, "NEEDED", ("starlette", "no_such_package"))
    printed = run("studio --no-browser", code=2).output
    command = how_to_install("elastica-cad[studio]")
    assert command.endswith('-m pip install "elastica-cad[studio]"')
    assert f"the page needs no_such_package: {command}" in printed


@pytest.mark.parametrize("host", ["evil.example", "127.0.0.1", "evil.example:80", "127.0.0.1.evil.example"])
def test_a_name_that_was_bound_to_this_computer_is_refused(server, host):
    assert fetched(server, "/", Host=host)[0] == 403
    with pytest.raises(InvalidStatus), server.page(Host=host):
        pass


@pytest.mark.parametrize("origin", ["https://evil.example", "null", None])
def test_other_sites_open_no_socket(server, origin):
    with pytest.raises(InvalidStatus), server.page(Origin=origin):
        pass
    if origin:
        assert fetched(server, "/", Origin=origin)[0] == 403


@pytest.mark.parametrize(
    "path",
    [
        "/../server.py",
        "/%2e%2e/server.py",
        "/..%2fserver.py",
        "//etc/passwd",
        "/vendor/../../server.py",
        "/%00",
        "/vendor",
    ],
)
def test_no_path_leads_out_of_the_page(server, path):
    status, _, text = fetched(server, path)
    assert status in (400, 404, 405)
    assert "import" not in text


def test_the_newest_of_equal_questions_is_answered(server):
    with server.page() as page:
        for x in range(60):
            moved = design([*ARCH[:4], [200 + x / 10, 175], *ARCH[5:]])
            page.talk.send(json.dumps({"do": "strip", "id": x, "design": moved}))
        answered = []
        while not answered or answered[-1] < 59:
            answered.append(page.answer()["id"])
    assert len(answered) < 60  # others were overtaken


def test_a_page_that_requests_without_end_holds_up_no_other(server):
    with server.page() as page, server.page() as other:
        for n in range(500):
            page.talk.send(
                json.dumps({"do": "edit", "kind": str(n), "id": n, "design": design(), "remove": 3})
            )
        assert "curve" in other.ask("edit", design=design(), remove=3)
        answers = [page.answer() for _ in range(500)]
    assert {one["id"] for one in answers} == set(range(500))
    refused = [one["refused"]["message"] for one in answers if "refused" in one]
    assert 0 < len(refused) < 500
    assert set(refused) == {"this page asks too much at once: wait for its answers"}


def test_only_the_named_design_is_read_and_saved(tmp_path):
    path = tmp_path / "arch.toml"
    path.write_text('# mine\nschema = 1\nname = "a"\nsheet = "pom-1"\nmax_width = 20\n[[strips]]\n'
                    "curve = { spline = [[0, 0], [50, 60], [100, 0]], degree = 2 }\n")  # fmt: skip
    with running(path, cwd=tmp_path) as server, server.page() as page:
        opened = page.hello["design"]
        opened["max_width"] = 25
        saved = page.ask("save", design=opened, mark=page.hello["mark"], path="/tmp/other.toml")
        assert saved["saved"] == "arch.toml"
        assert "# mine" in path.read_text()
        assert "max_width = 25" in path.read_text()
        by_hand = path.read_text().replace("= 25", "= 27  # by hand")
        path.write_text(by_hand)
        mine = opened | {"max_width": 30}
        for stale in (saved["mark"], page.hello["mark"], None, "", 7, []):
            changed = page.ask("save", design=mine, mark=stale)
            assert changed["refused"]["text"] == "{name} was changed since this page read it"
            assert changed["design"]["max_width"] == 27
            assert path.read_text() == by_hand
        with server.page() as other:  # the file is read at each hello
            assert other.hello["design"]["max_width"] == 27
            assert other.hello["mark"] == changed["mark"]
        path.write_text(by_hand + "[[")  # and where nobody can read it, nothing is written
        assert (
            "is not a valid TOML file"
            in page.ask("save", design=mine, mark=changed["mark"])["refused"]["text"]
        )
        with server.page() as other:
            assert other.hello["design"] is None
            assert "is not a valid TOML file" in other.hello["refused"]["text"]
        path.unlink()
        assert page.ask("save", design=mine, mark=changed["mark"])["design"] is None
        assert page.ask("save", design=mine, mark="")["saved"] == "arch.toml"
        assert "max_width = 30" in path.read_text()
        assert [one.name for one in tmp_path.iterdir()] == ["arch.toml"]


@pytest.mark.campaign
def test_a_saved_design_keeps_its_mode_line_ends_and_byte_order_mark(tmp_path):
    path = tmp_path / "arch.toml"
    lines = ["# mine", "schema = 1", 'sheet = "pom-1"', "max_width = 20", "[[strips]]",
             "curve = { spline = [[0, 0], [50, 60], [100, 0]], degree = 2 }", ""]  # fmt: skip
    path.write_bytes("\r\n".join(lines).encode("utf-8-sig"))
    path.chmod(0o600)
    with running(path, cwd=tmp_path) as server, server.page() as page:
        changed = page.hello["design"] | {"max_width": 25, "smooth": 0.1}
        assert page.ask("save", design=changed, mark=page.hello["mark"])["saved"] == "arch.toml"
    saved = path.read_bytes()
    assert saved.startswith("# mine".encode("utf-8-sig"))
    assert b"max_width = 25\r\n" in saved
    assert saved.count(b"\n") == saved.count(b"\r\n")
    assert path.stat().st_mode & 0o777 == 0o600


def test_pages_that_save_at_once_write_one_design_each_on_the_mark_of_the_other(tmp_path):
    path = tmp_path / "arch.toml"
    path.write_text(compose_design(design(max_width=20)))
    with running(path, cwd=tmp_path) as server, server.page() as one, server.page() as other:
        for page in (one, other):
            page.talk.send(
                json.dumps({"do": "save", "design": design(max_width=30), "mark": page.hello["mark"]})
            )
        answers = [page.answer() for page in (one, other)]
    assert ["saved" in answer for answer in answers].count(True) == 1


@pytest.mark.campaign
def test_saving_many_points_does_not_hold_up_another_page(tmp_path):
    path = tmp_path / "arch.toml"
    path.write_text(compose_design(design()))
    many = [[k / 7, k % 13 / 3] for k in range(3000)]
    with running(path, cwd=tmp_path) as server, server.page() as one, server.page() as other:
        other.ask("edit", design=design(), remove=3)  # both workers are there
        one.talk.send(json.dumps({"do": "save", "design": design(many), "mark": one.hello["mark"]}))
        began = time.monotonic()
        assert fetched(server, "/studio.js")[0] == 200
        assert "curve" in other.ask("edit", design=design(), remove=3)
        waited = time.monotonic() - began
        assert "saved" in one.answer()
        assert waited < time.monotonic() - began


@pytest.mark.campaign
def test_after_an_interrupt_the_port_is_free_and_nothing_is_printed():
    command = [sys.executable, "-m", "elastica_cad", "studio", "--no-browser", "--port"]
    port = "0"
    for _ in range(2):
        process = subprocess.Popen(
            [*command, port], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, process_group=0
        )
        server = Server(process)
        with server.page() as page:
            page.ask("edit", design=design(), remove=3)
            port = str(server.port)
            os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to all processes of the command
            text = process.communicate(timeout=20)[1]
        assert (process.returncode, text) == (0, "")


BOMB = (
    '<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa">'
    + "".join(f'<!ENTITY {chr(98 + k)} "{f"&{chr(97 + k)};" * 10}">' for k in range(9))
    + "]><svg xmlns='http://www.w3.org/2000/svg'><text>&j;</text></svg>"
)


def hostile_questions():
    """Questions that no page of ours asks."""
    deep = {}
    for _ in range(200):
        deep = {"curve": deep}
    yield from (
        {},
        {"do": "read", "name": "a.svg", "text": BOMB},
        {"do": "read", "name": "../../a.svg", "text": "<svg/>"},
    )
    yield from (
        {"do": "read", "name": "a.dxf", "text": "0\nSECTION\n" * 1000},
        {"do": "read", "name": "a.exe", "text": ""},
    )
    yield {"do": "read", "name": "a.toml", "text": "[" * 100_000}
    yield {"do": "strip", "design": deep}
    for wrong in (
        None,
        7,
        "x",
        [],
        {},
        [[1e308, 1e308], [0, 0], [1, 1]],
        [["a", "b"]],
        [[0, 0]] * 500,
        [[1e9, 0]] * 3,
    ):
        yield {"do": "strip", "design": design() | {"strips": [{"curve": {"spline": wrong, "degree": 2}}]}}
    for key in ("max_width", "sheet", "strips", "limits", "style", "gravity", "samples", "ends", "name"):
        for wrong in (None, -1, 1e308, 10**400, "x" * 10_000, "9" * 5000 + "**9", [], {}, True):
            yield {"do": "strip", "design": design(**{key: wrong})}
    yield {"do": "model", "design": design(patterns=[{"rotate": {"count": 10**9}}])}
    yield {"do": "file", "kind": "../dxf", "design": design()}
    yield {"do": "edit", "design": design(), "near": "here"}
    yield {"do": "edit", "design": design(), "remove": -5}
    yield {"do": "save", "design": {"a": {"b": None}, "c": object.__name__}}


@pytest.mark.campaign
def test_a_hostile_question_gets_one_sentence(server):
    with server.page() as page:
        for question in hostile_questions():
            answer = page.ask(**({"do": "nothing"} | question))
            if "refused" in answer:
                assert answer["refused"]["message"].strip()
                assert "Traceback" not in answer["refused"]["message"]
        assert "refused" not in page.ask("strip", design=design())


def test_nonsense_is_answered_and_the_next_question_too(server):
    with server.page() as page:
        for text in (
            "",
            "{",
            "[]",
            "7",
            "null",
            '"x"',
            "{" * 5000,
            '{"do": {}}',
            '{"do": "strip", "design": 3}',
            '{"do": "strip", "id": NaN}',
            '{"do": "strip", "id": 1e999}',
            '{"do": "strip", "id": ' + 300 * "[" + 300 * "]" + "}",
            '{"do": "strip", "design": ' + 900 * "[" + 900 * "]" + "}",
            '{"do": "strip", "design": {"curve": ' + 900 * "[" + 900 * "]" + "}}",
            '{"do": "save", "design": {"a": [null, {"b": null}]}}',
            '{"do": "strip", "kind": {}}',
            '{"do": "strip", "language": []}',
        ):
            page.talk.send(text)
            message = page.answer()["refused"]["message"]
            assert "memory" not in message  # which a page is told of a worker that has ended
            assert "{" not in message
        assert "refused" not in page.ask("strip", design=design())
    with server.page() as page:
        page.talk.send(b"\x00\xff")  # ends that page, not the server
    with server.page() as page:
        assert "refused" not in page.ask("strip", design=design())


def test_a_question_that_needs_too_much_memory_or_time_ends_with_a_sentence(server):
    with server.page() as page:
        message = page.ask("strip", design=design(samples="10000 * 1000"))
        assert "refused" in message
        assert "refused" not in page.ask("strip", design=design())


def test_abandoned_downloads_end_with_their_pages_and_write_nothing():
    command = [sys.executable, "-m", "elastica_cad", "studio", "--no-browser"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    server, drawn, asked = Server(process), random.Random(94), design()
    asked["strips"][0] |= {"count": 300, "origin": [0, 0, "50 * i"]}
    try:
        for _ in range(6):
            with server.page() as page:
                page.talk.send(json.dumps({"do": "file", "id": 1, "kind": "kit", "design": asked}))
                time.sleep(drawn.uniform(0, 0.3))
                # an abrupt end, as of a computer that is switched off
                page.talk.socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
                page.talk.socket.close()
        with server.page() as page:  # with both processes busy, it would wait for minutes
            assert "refused" not in page.ask("strip", design=design())
    finally:
        process.send_signal(signal.SIGINT)
        text = process.communicate(timeout=20)[1]
    assert text == ""


def test_half_a_surrogate_pair_in_a_saved_design_is_answered(tmp_path):
    with running(tmp_path / "new.toml") as started, started.page() as page:
        answer = page.ask("save", design=design(name="half \ud83d"), mark="")
        assert answer["saved"] == "new.toml"
        assert 'name = "half ?"' in (tmp_path / "new.toml").read_text()


@pytest.mark.campaign
def test_ten_thousand_malformed_messages(server):
    drawn = random.Random(65)
    whole = json.dumps({"do": "strip", "id": 1, "design": design()})
    with server.page() as page:
        for _ in range(10_000):
            letters = list(whole)
            for _ in range(drawn.randint(1, 6)):
                letters[drawn.randrange(len(letters))] = chr(
                    drawn.choice((drawn.randrange(32, 127), 0, 8232, 0x10FFFF))
                )
            page.talk.send("".join(letters[: drawn.randint(0, len(letters))]))
        while page.ask("edit", design=design(), remove=3).get("do") != "edit":
            pass
        assert server.process.poll() is None


@pytest.mark.campaign
def test_half_open_sockets_are_no_harm(server):
    held = [socket.create_connection(("127.0.0.1", server.port)) for _ in range(300)]
    for one in held:
        one.sendall(b"GET / HTTP/1.1\r\nHost: ")
    with server.page() as page:
        assert "refused" not in page.ask("strip", design=design())
    for one in held:
        one.close()


@pytest.mark.campaign
def test_fifty_pages_for_ten_minutes(server):
    """A change a second each: none is lost, and memory is flat. MINUTES=1 in the environment makes it shorter."""
    from concurrent.futures import ThreadPoolExecutor

    import psutil

    seconds, pages, parent = (
        60 * float(os.environ.get("MINUTES", "10")),
        50,
        psutil.Process(server.process.pid),
    )

    def memory():
        return sum(one.memory_info().rss for one in (parent, *parent.children(recursive=True)))

    def change(k):
        drawn, missed, times = random.Random(k), 0, []
        with server.page() as page:
            until = time.monotonic() + seconds
            while time.monotonic() < until:
                began = time.monotonic()
                moved = design([*ARCH[:4], [200 + drawn.uniform(-9, 9), 175], *ARCH[5:]])
                missed += "length" not in page.ask("strip", design=moved)
                times.append(time.monotonic() - began)
                time.sleep(max(0.0, 1.0 - times[-1]))
        return missed, times

    with ThreadPoolExecutor(pages) as pool:
        running_pages = [pool.submit(change, k) for k in range(pages)]
        time.sleep(seconds / 5)
        early = memory()
        found = [one.result() for one in running_pages]
    late, times = memory(), sorted(one for _, times in found for one in times)
    result = f"median {times[len(times) // 2]:.2f} s, {early / 1e6:.0f} MB, then {late / 1e6:.0f} MB"
    print(f"\n{len(times)} changes, {result}")
    assert sum(missed for missed, _ in found) == 0
    assert late < 1.1 * early + 20e6
