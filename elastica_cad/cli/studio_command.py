"""`elastica studio`: open a web page in which curves are drawn, and which shows their strips immediately."""

import webbrowser
from importlib.util import find_spec
from pathlib import Path

import click

from elastica_cad.cli.voice import answer, say
from elastica_cad.errors import missing_library

NEEDED = ("starlette", "uvicorn", "websockets", "tomlkit")


@click.command()
@click.argument("design", type=click.Path(path_type=Path), required=False)
@click.option("--port", type=click.IntRange(0, 65535), default=0, show_default="a free port",
              help="Port on this computer.")  # fmt: skip
@click.option("--no-browser", is_flag=True, help="Print the address without opening a browser.")
def studio(design: Path | None, port: int, no_browser: bool) -> None:
    """Open a page to draw a curve and see its strip.

    The page downloads the files of the strip, and reads and saves DESIGN.

    The first line is the address of the page, for a browser on this computer. Stop with Ctrl-C. The page reads
    and writes only DESIGN; other files are downloads. Without DESIGN the drawing is stored in the address of the
    page.
    """
    missing = [name for name in NEEDED if find_spec(name) is None]
    if missing:
        raise missing_library(f"the page needs {missing[0]}", "elastica-cad[studio]")
    from elastica_cad.web.server import Entrance, Studio, bound_socket, serve

    bound = bound_socket(port)
    entrance = Entrance(bound.getsockname()[1])
    page = Studio(entrance, design)
    answer({"address": entrance.address})
    say(entrance.address)
    if not no_browser:
        webbrowser.open(entrance.address)
    serve(page, bound)
