"""`elastica help`: what can be asked for, key by key."""

import click

from elastica_cad.cli.settings import completed, explained, listed
from elastica_cad.cli.strip_options import typed_name
from elastica_cad.cli.voice import answer, say


@click.command("help")
@click.argument("key", required=False, shell_complete=completed)
def help_command(key: str | None) -> None:
    """Explain KEY of a strip or a design file, such as limits.ratio; without KEY list all.

    A key is given by its option where `elastica strip --help` shows one, by `--set KEY=VALUE`, or in a design file.
    """
    text = listed() if key is None else explained(key, typed_name(key))
    answer({"key": key, "text": text})
    say(text)
