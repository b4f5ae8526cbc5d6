"""The `elastica` command."""

import gc
import os
import sys
import warnings
from collections.abc import Sequence
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING

from elastica_cad._process import RARE_COLLECTIONS
from elastica_cad.errors import how_to_install

if TYPE_CHECKING:
    import click

    from elastica_cad.plot.page_process import PageProcess

__all__ = ["main"]


def main(arguments: list[str] | None = None) -> None:
    """Run the command line; exit code 0 is done, 1 not realizable, 2 bad input.

    Examples
    --------
    >>> main(["--version"])
    Traceback (most recent call last):
    SystemExit: 0
    """
    if arguments is not None:
        _command().main(args=arguments, prog_name="elastica")
    if not sys.warnoptions:
        warnings.simplefilter("ignore")  # Python's own are for programmers; what matters here is said
    # its matrices are small: threads cost more than they help, and on one the bytes are those of every machine
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    # a command is short: looking for cycles among what imports made is a tenth of its time
    gc.disable()
    with _painter(sys.argv[1:]) as painter:
        elastica = _command()
        gc.freeze()
        gc.set_threshold(*RARE_COLLECTIONS)
        gc.enable()
        try:
            elastica.main(prog_name="elastica", obj=painter)
        finally:
            gc.freeze()  # the process ends: it need not look through all it loaded for cycles once more


def _command() -> "click.Group":
    """The group of commands; without click, the end."""
    try:
        import click  # noqa: F401 - only its presence is asked
    except ImportError:
        sys.exit(f"the elastica command needs click: {how_to_install('click')}")
    from elastica_cad.cli.commands import elastica

    return elastica


def _painter(words: Sequence[str]) -> AbstractContextManager["PageProcess | None"]:
    """What paints the picture of `elastica strip` meanwhile, begun before all else is loaded."""
    if words[:1] != ["strip"] or {"-h", "--help", "--no-pictures"} & set(words):
        return nullcontext()
    from elastica_cad.plot.page_process import page_process

    return page_process()
