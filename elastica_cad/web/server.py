"""Server of the page, only for this computer. It saves a design unless its file was changed meanwhile."""

import asyncio
import hmac
import json
import os
import secrets
import socket
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress
from dataclasses import dataclass, field
from importlib.resources import files
from itertools import count
from pathlib import Path
from typing import Any

from starlette.applications import Starlette
from starlette.datastructures import MutableHeaders
from starlette.requests import HTTPConnection
from starlette.responses import PlainTextResponse
from starlette.routing import Mount, WebSocketRoute
from starlette.staticfiles import StaticFiles
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from starlette.websockets import WebSocket, WebSocketDisconnect

from elastica_cad.errors import ElasticaError, FieldName, InputError, installed_version
from elastica_cad.formats.write_files import write_atomically
from elastica_cad.web.answers import CHANGED, refused
from elastica_cad.web.saved_design import file_mark, open_design, start_designs
from elastica_cad.web.vocabulary import page_words
from elastica_cad.web.worker import read_question, text_answer
from elastica_cad.web.workers import Workers

HOST = "127.0.0.1"

MOST_BYTES = 16 * 2**20
"""Largest size of a message, such as a dropped drawing."""

TOO_MUCH = "this page asks too much at once: wait for its answers"

POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self' {socket}; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)

HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cache-Control": "no-cache",
}
"""Headers of all responses, in addition to the policy."""


@dataclass(frozen=True)
class Entrance:
    """Check of requests: a request must name this computer as host and come from this site.

    The files of the page are public. A socket is answered only after it has sent the key.
    """

    port: int
    key: str = field(default_factory=lambda: secrets.token_urlsafe(24))

    @property
    def address(self) -> str:
        """Address of the page for a browser. The key is in the fragment, which browsers do not send."""
        return f"http://{HOST}:{self.port}/#key={self.key}"

    def refusal(self, connection: HTTPConnection) -> str:
        """Return why a request is refused, or "" if it is permitted."""
        host = connection.headers.get("host", "")
        if host not in (f"{HOST}:{self.port}", f"localhost:{self.port}"):
            return "This server answers to its own name only.\n"
        origin = connection.headers.get(
            "origin", "" if connection.scope["type"] == "websocket" else f"http://{host}"
        )
        return "" if origin == f"http://{host}" else "This server answers to its own page only.\n"


class Guard:
    """ASGI middleware that checks each request with `Entrance`, and adds the security policy to each
    response.
    """

    def __init__(self, app: ASGIApp, entrance: Entrance) -> None:
        self.app, self.entrance = app, entrance

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a permitted request to the application. Refuse other requests."""
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        connection = HTTPConnection(scope)
        refusal = self.entrance.refusal(connection)

        async def guarded(message: Message) -> None:
            if message["type"] == "http.response.start":
                policy = POLICY.format(socket=f"ws://{connection.headers.get('host')}")
                MutableHeaders(scope=message).update(HEADERS | {"Content-Security-Policy": policy})
            await send(message)

        if not refusal:
            await self.app(scope, receive, guarded)
        elif scope["type"] == "websocket":
            await WebSocket(scope, receive, send).close(1008, refusal.strip())
        else:
            await PlainTextResponse(refusal, 403)(scope, receive, guarded)


class Studio:
    """Server of the page, of its requests, and of the design file that it may save.

    Parameters
    ----------
    entrance : Entrance
    path : Path, optional
        Design file that is opened, and saved on request.
    """

    def __init__(self, entrance: Entrance, path: Path | None = None) -> None:
        self.entrance, self.path = entrance, path
        if path is not None and path.exists():
            # report an invalid design in the terminal before the page opens
            open_design(path)
        # first message to each page
        self._hello = page_words() | {
            "do": "hello",
            "starts": start_designs(),
            "version": installed_version("elastica-cad") or "from a checkout",
            "file": None if path is None else path.name,
        }
        self._workers = Workers(path)
        self._pages = count(1)
        page = Path(str(files("elastica_cad.web").joinpath("page")))
        routes = [
            WebSocketRoute("/talk", self._talk),
            Mount("/", StaticFiles(directory=page, html=True)),
        ]
        self.app = Guard(Starlette(routes=routes, lifespan=self._alive), entrance)

    @asynccontextmanager
    async def _alive(self, _: Starlette) -> AsyncIterator[None]:
        self._workers.start()
        yield
        await self._workers.stop()

    async def _talk(self, talk: WebSocket) -> None:
        """Answer the messages of one page, after the page has sent the key, until it is closed."""
        page = next(self._pages)

        async def send(kind: bytes, content: bytes) -> None:
            await (talk.send_text(content.decode()) if kind == b"text" else talk.send_bytes(content))

        async def greet(_: bytes, opened: bytes) -> None:
            await send(b"text", json.dumps({"design": None} | json.loads(opened) | self._hello).encode())

        try:
            await talk.accept()
            key = await talk.receive_text()
            if not hmac.compare_digest(key.encode(), self.entrance.key.encode()):
                await talk.close(1008, "wrong key")
                return
            self._workers.request(page, {"do": "open"}, b'{"do": "open"}', greet)
            while True:
                await self._take(page, await talk.receive_text(), send)
        # the page was closed, at whatever moment, or another program sent bytes
        except (WebSocketDisconnect, RuntimeError, KeyError):
            with suppress(WebSocketDisconnect, RuntimeError):
                await talk.close()
        finally:
            self._workers.forget(page)

    async def _take(self, page: int, text: str, send: Any) -> None:
        """Pass a request of the page to a worker, and its answer to `send`.

        A save is written to the file first.
        """
        try:
            request = read_question(text)
        except InputError as problem:
            await send(b"text", text_answer({}, refused(problem)))
            return
        path = self.path

        async def written(kind: bytes, content: bytes) -> None:
            await send(kind, content if path is None else _save_if_unchanged(path, content))

        saves = request.get("do") == "save" and not request.get("copy")
        # a request is one line for a worker, and JSON allows a space in place of a line feed
        line = text.replace("\n", " ").encode()
        if not self._workers.request(page, request, line, written if saves else send):
            await send(b"text", text_answer(request, refused(InputError(TOO_MUCH))))


def _save_if_unchanged(path: Path, content: bytes) -> bytes:
    """Write the answer to a save to the file, unless the file was changed since the page read it.

    Return the answer for the page.
    """
    answer = json.loads(content)
    if "refused" in answer:
        return content
    text, mark = answer.pop("text"), answer.pop("mark")
    try:
        if file_mark(path) != mark:
            raise InputError(CHANGED, name=path.name)
        write_atomically(path, text.encode(errors="replace"), force=True)  # half a surrogate pair becomes "?"
        answer |= {"saved": path.name, "mark": file_mark(path)}
    except ElasticaError as problem:
        answer |= refused(problem)
    return json.dumps(answer).encode()


def bound_socket(port: int) -> socket.socket:
    """Return a listening socket for connections from this computer only. Port 0 selects any free port."""
    bound = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    # by default, recently closed connections would block the port for a minute
    if os.name == "posix":
        bound.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        bound.bind((HOST, port))
        # from now on, a browser that connects waits until the server is ready
        bound.listen()
    except (OSError, OverflowError) as problem:
        bound.close()
        raise InputError(
            "Port {port} is not available. Leave out {field} to use a free port.",
            field=FieldName("port"),
            port=port,
            where={"option": "--port"},
        ) from problem
    return bound


def serve(studio: Studio, bound: socket.socket) -> None:
    """Run the server until Ctrl-C."""
    import uvicorn

    settings = uvicorn.Config(
        studio.app,
        log_level="warning",
        ws_max_size=MOST_BYTES,
        timeout_graceful_shutdown=1,
        server_header=False,
    )
    with suppress(KeyboardInterrupt):
        asyncio.run(uvicorn.Server(settings).serve(sockets=[bound]))
