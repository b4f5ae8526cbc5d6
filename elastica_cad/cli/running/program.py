"""How the running program was called, for the commands that it tells."""

import shlex
import shutil
import sys
from pathlib import Path


def name_program() -> str:
    """Its name, its path where the name alone would find another, or the interpreter with the module."""
    called = Path(sys.argv[0])
    if called.parts[-2:] == ("elastica_cad", "__main__.py"):
        return f"{shlex.quote(sys.executable)} -m elastica_cad"
    found = shutil.which("elastica")
    if called.stem == "elastica" and called.exists() and not (found and called.samefile(found)):
        return shlex.quote(sys.argv[0])
    return "elastica"
