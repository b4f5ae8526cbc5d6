"""Worker processes and the queue of requests.

Of several waiting requests of the same kind from a page, only the newest is answered.
"""

import asyncio
from collections.abc import Awaitable, Callable
from contextlib import suppress
from pathlib import Path
from signal import Signals
from typing import Any

from elastica_cad._process import python_command
from elastica_cad.errors import InputError
from elastica_cad.web.answers import refused
from elastica_cad.web.worker import text_answer

WORKERS = 2

LONGEST_S = {"file": 180.0, "model": 60.0, "sheets": 60.0, "bend": 30.0, "cures": 60.0}
"""Time limits, s, of some kinds of requests. The limit of all others is `USUAL_S`."""

USUAL_S = 15.0

MOST_WAITING = 12
"""Largest number of different waiting requests from a page. The studio's page sends fewer."""

Send = Callable[[bytes, bytes], Awaitable[None]]
"""Function that sends the kind and contents of an answer."""


class Workers:
    """Two worker processes, and a queue of requests.

    Requests are answered in the order of arrival. A request takes the place of a waiting request of the same
    kind.
    """

    def __init__(self, saved: Path | None) -> None:
        self._saved = saved
        # the request, its line for a worker, and the function for the answer, by page and kind of request
        self._waiting: dict[tuple[int, str], tuple[dict[str, Any], bytes, Send]] = {}
        # the page for which each process computes something that may take long
        self._busy: dict[asyncio.subprocess.Process, int] = {}
        self._arrived = asyncio.Semaphore(0)
        self._tasks: list[asyncio.Task[None]] = []

    def start(self) -> None:
        """Start the processes, which are ready after a second."""
        self._tasks = [asyncio.create_task(self._work()) for _ in range(WORKERS)]

    async def stop(self) -> None:
        """Stop the processes."""
        for task in self._tasks:
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)

    def request(self, page: int, question: dict[str, Any], line: bytes, send: Send) -> bool:
        """Queue a request. It replaces a waiting request of the same kind from the same page.

        Return False if too many other requests from the page are waiting.
        """
        key = (page, f"{question.get('do')} {question.get('kind', '')}")
        if key not in self._waiting:
            if sum(waiting == page for waiting, _ in self._waiting) >= MOST_WAITING:
                return False
            self._arrived.release()
        self._waiting[key] = question, line, send
        return True

    def forget(self, page: int) -> None:
        """Drop the waiting requests of a closed page, and end processes that compute for it for long."""
        for process in [process for process, busy_page in self._busy.items() if busy_page == page]:
            with suppress(ProcessLookupError):
                process.kill()
        for key in [key for key in self._waiting if key[0] == page]:
            del self._waiting[key]

    async def _work(self) -> None:
        """Answer waiting requests one by one by a worker process.

        The process is ended after an error, or if an answer takes too long.
        """
        process = None
        try:
            while True:
                process = process or await _start_worker(self._saved)
                await self._arrived.acquire()
                if not self._waiting:  # the page of a request was closed
                    continue
                key = next(iter(self._waiting))
                question, line, send = self._waiting.pop(key)
                seconds = LONGEST_S.get(str(question.get("do")), USUAL_S)
                if seconds > USUAL_S:
                    self._busy[process] = key[0]
                try:
                    kind, content = await asyncio.wait_for(_response(process, line), seconds)
                except (TimeoutError, asyncio.IncompleteReadError, OSError, ValueError) as failure:
                    code = await _end(process)
                    reason = (
                        "The request took longer than {seconds} s. Use fewer strips, samples or holes."
                        if isinstance(failure, TimeoutError) else
                        "The process that computed this has ended ({code}); SIGKILL usually means too little "
                        "memory. Try again, or use fewer strips, samples or holes."
                    )  # fmt: skip
                    refusal = refused(InputError(reason, seconds=round(seconds), code=code))
                    kind, content = b"text", text_answer(question, refusal)
                self._busy.pop(process, None)
                process = process if process.returncode is None else None
                # the page may have been closed meanwhile
                with suppress(Exception):
                    await send(kind, content)
        finally:
            if process is not None:
                await _end(process)


async def _start_worker(saved: Path | None) -> asyncio.subprocess.Process:
    command = [*python_command("elastica_cad.web.worker", "main"), *([str(saved)] if saved else [])]
    pipe = asyncio.subprocess.PIPE
    # start workers in a separate session, because Ctrl-C must reach only the server, which ends the workers
    return await asyncio.create_subprocess_exec(*command, stdin=pipe, stdout=pipe, start_new_session=True)


async def _response(process: asyncio.subprocess.Process, line: bytes) -> tuple[bytes, bytes]:
    """Return the kind (text or file) and the content of the worker's answer to a line."""
    assert process.stdin is not None
    assert process.stdout is not None
    process.stdin.write(line + b"\n")
    await process.stdin.drain()
    kind, size = (await process.stdout.readline()).split()
    return kind, await process.stdout.readexactly(int(size))


async def _end(process: asyncio.subprocess.Process) -> str:
    """End a process, and return the signal or the exit code with which it ended."""
    # `kill` of a process that has ended takes its exit code away from asyncio
    with suppress(TimeoutError):
        await asyncio.wait_for(process.wait(), 0.1)
    if process.returncode is None:
        process.kill()
    code = await process.wait()
    return Signals(-code).name if code < 0 else f"exit code {code}"
