"""The `elastica` command."""

import sys

__all__ = ["main"]


def main(arguments: list[str] | None = None) -> None:
    """Run the command line; exit code 0 is done, 1 not realizable, 2 bad input.

    Examples
    --------
    >>> main(["--version"])  # doctest: +SKIP
    """
    try:
        import click  # noqa: F401 - only its presence is asked
    except ImportError:
        sys.exit("the elastica command needs click: pip install elastica-cad")
    from elastica_cad.cli.commands import elastica

    elastica.main(args=arguments, prog_name="elastica")
