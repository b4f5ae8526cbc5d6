"""The studio's server, started as a user starts it, and what a page of it says."""

import base64
import json
import re
import socket
import subprocess
import sys
import zlib
from contextlib import contextmanager
from itertools import count
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from websockets.sync.client import connect

ARCH = [[0, 0], [40, 5], [80, 40], [125, 160], [200, 175], [275, 160], [320, 40], [360, 5], [400, 0]]


def design(points=ARCH, **keys):
    strip = {"label": "A1", "curve": {"spline": [list(point) for point in points], "degree": 4}}
    return {
        "schema": 1,
        "name": "arch",
        "sheet": "birch-plywood-0.8",
        "max_width": 40,
        "strips": [strip],
        **keys,
    }


WAVE = [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)]


def wave(points=WAVE, **keys):
    """A curve that a strip takes only if it is held between its ends."""
    drawn = design(points, **keys)
    drawn["strips"][0]["curve"]["degree"] = 5
    return drawn


def link(design):
    """The part of the page's address that holds a design."""
    packed = zlib.compressobj(wbits=-15)
    letters = base64.urlsafe_b64encode(packed.compress(json.dumps(design).encode()) + packed.flush())
    return letters.decode().rstrip("=")


def linked(address):
    """The design that the page's address holds."""
    letters = address.partition("#")[2]
    return json.loads(zlib.decompress(base64.urlsafe_b64decode(letters + "=" * (-len(letters) % 4)), -15))


def without_command(drawing):
    """The bytes of a drawing but for the command that made it, which a page has none of."""
    return re.sub(rb"\A999\n.*\n|<desc>.*</desc>\n", b"", drawing)


class Server:
    """A running `elastica studio`."""

    def __init__(self, process):
        self.process = process
        self.address = process.stdout.readline().strip()
        parts = urlsplit(self.address)
        self.host, self.port, self.key = parts.netloc, parts.port, parts.fragment.removeprefix("key=")

    @contextmanager
    def page(self, key=None, **headers):
        """What `Page.ask` needs; with the key and the headers of our own page unless others are given."""
        sent = {"Host": self.host} | headers
        origin = sent.pop("Origin", f"http://{self.host}")
        host = sent.pop("Host")
        plain = socket.create_connection(("127.0.0.1", self.port))  # whatever the name of the host
        with connect(
            f"ws://{host}/talk",
            sock=plain,
            origin=origin,
            additional_headers=sent,
            max_size=2**26,
            compression=None,
        ) as talk:
            talk.send(self.key if key is None else key)
            yield Page(talk)


class Page:
    def __init__(self, talk):
        self.talk, self.numbers = talk, count(1)
        self.hello = json.loads(talk.recv(30))

    def ask(self, do, **more):
        """The answer to one question; of a file its head and its bytes."""
        self.talk.send(json.dumps({"do": do, "id": next(self.numbers), **more}))
        return self.answer()

    def answer(self, seconds=120):
        got = self.talk.recv(seconds)
        if isinstance(got, str):
            return json.loads(got)
        head, _, content = got.partition(b"\n")
        return json.loads(head) | {"content": content}


@contextmanager
def running(*words, cwd=None):
    command = [Path(sys.executable).with_name("elastica"), "studio", "--no-browser", *map(str, words)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, cwd=cwd)
    try:
        yield Server(process)
    finally:
        process.terminate()
        process.wait(20)
        process.stdout.close()


@pytest.fixture(scope="session")
def server():
    with running() as started:
        yield started
