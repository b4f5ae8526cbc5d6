"""`elastica` as it is typed, run in the process of the tests."""

import re
from contextlib import chdir

from click.testing import CliRunner, Result

from elastica_cad.cli.commands import elastica


def run(line: object, *words: object, cwd: object = ".", code: int | None = 0, **options: object) -> Result:
    """Run a command and check its exit code, unless that is None. Spaces separate words in `line`.

    Exceptions are passed on; `options` are those of click's `invoke`, such as `input`.
    """
    with chdir(cwd):
        arguments = [*str(line).split(), *map(str, words)]
        result = CliRunner().invoke(elastica, arguments, catch_exceptions=False, **options)
    assert code in (None, result.exit_code), result.output
    return result


def suggested_commands(output):
    """The arguments of all commands that are suggested, in order."""
    return re.findall(r"^Change +.*\): `.*?elastica(?:_cad)? ([^`]*)`", output, re.MULTILINE)
