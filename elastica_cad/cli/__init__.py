"""The `elastica` command.

Large modules are imported inside `main`, which catches Ctrl-C and prints no traceback.
"""

import gc
import os
import sys
import warnings
from typing import TYPE_CHECKING

from elastica_cad.defaults import INTERRUPTED, OUTPUT_CLOSED

if TYPE_CHECKING:
    from elastica_cad.plot.drawing_process import DrawingProcess

__all__ = ["main"]


def main(arguments: list[str] | None = None) -> None:
    """Run the command line. Exit codes: 0 done, 1 not realizable, 2 bad input, 130 Ctrl-C, 141 output closed.

    Examples
    --------
    >>> main(["--version"])
    Traceback (most recent call last):
    SystemExit: 0
    """
    if arguments is None:
        if not sys.warnoptions:
            # hide Python's warnings, which are for programmers
            warnings.simplefilter("ignore")
        # OpenBLAS with one thread is faster for small matrices, and gives equal results on every machine
        os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
        # garbage collection of imported objects would take a fifth of a command's time
        gc.set_threshold(200_000, 20, 20)
    try:
        from elastica_cad.plot.drawing_process import drawing_process

        # a program that calls `main` may have imported matplotlib, so its process makes the drawings
        with drawing_process(() if arguments is not None else sys.argv[1:]) as process:
            code = _run(arguments, process)
    except KeyboardInterrupt:
        code = INTERRUPTED
    except RuntimeError as error:
        # Python 3.11 raises a RuntimeError for a Ctrl-C that arrives while a class is created
        if not isinstance(error.__cause__, KeyboardInterrupt):
            raise
        code = INTERRUPTED
    except BrokenPipeError:
        code = OUTPUT_CLOSED
    finally:
        if arguments is None:
            # skip garbage collection at the end of the process
            gc.freeze()
    if code == OUTPUT_CLOSED:
        _drop_output(1, 2)
    sys.exit(code)


def _run(arguments: list[str] | None, process: "DrawingProcess | None") -> int:
    """Run the command and return its exit code.

    Errors of click and of a closed output are printed as sentences.
    """
    try:
        import click
    except ImportError:
        from elastica_cad.errors import how_to_install

        sys.exit(f"the elastica command needs click: {how_to_install('click')}")
    from elastica_cad.cli.commands import elastica

    try:
        code = elastica.main(args=arguments, prog_name="elastica", standalone_mode=False, obj=process)
    except click.ClickException as problem:
        problem.show()
        return problem.exit_code
    except click.Abort:
        return INTERRUPTED
    except OSError as problem:
        if problem.filename is not None:  # an error with a file name is not about standard output
            raise
        _drop_output(1)
        sys.stderr.write(f"Error: the answer can't be written: {problem.strerror or problem}\n")
        return 2
    return code if isinstance(code, int) else 0


def _drop_output(*streams: int) -> None:
    """Discard the buffered text of standard output (1) and standard error (2)."""
    for stream in streams:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream)
