"""Lists of names by version, in JSON files. FreeCAD's Python imports this module without the libraries of the
command line.
"""

import json
from pathlib import Path

import elastica_cad as ec


def present_version() -> str:
    """Version of the package."""
    return ec.__version__


def write_list(folder: Path, listed: dict[str, set[str]]) -> None:
    """Write the list of this version into a folder."""
    folder.mkdir(exist_ok=True)
    text = json.dumps({place: sorted(found) for place, found in listed.items()}, indent=0)
    (folder / f"{present_version()}.json").write_text(text + "\n", encoding="utf-8")


def lost_names(path: Path, now: dict[str, set[str]]) -> list[str]:
    """Names in the list of an earlier version that are gone, with their place."""
    earlier = json.loads(path.read_text(encoding="utf-8"))
    return [f"{place}: {name}" for place, kept in earlier.items() for name in kept if name not in now[place]]
