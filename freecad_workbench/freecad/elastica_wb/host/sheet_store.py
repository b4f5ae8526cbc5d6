# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The sheets that a user can choose: the built-in ones and his own, kept in a TOML file."""

from collections.abc import Iterable
from functools import lru_cache
from pathlib import Path

import FreeCAD as App
from freecad.elastica_wb.host.words import report_warning

from elastica_cad.errors import InputError
from elastica_cad.formats.write_files import reason, write_atomically
from elastica_cad.mechanics.sheets import Sheet, built_in_figures, load_sheets, sheet_names, sheets_from_table


def own_sheets_file() -> Path:
    """Return the path of the file with the user's sheets."""
    return _file_in(App.getUserAppDataDir())


@lru_cache(maxsize=4)
def _file_in(folder: str) -> Path:
    return Path(folder) / "elastica-sheets.toml"


def own_sheets() -> dict[str, Sheet]:
    """The user's sheets by name; an unreadable file is told in the report view and counts as empty."""
    path = own_sheets_file()
    try:
        state = path.stat()
    except OSError:
        return {}
    return dict(_read(path, state.st_mtime_ns, state.st_size))


@lru_cache(maxsize=1)
def _read(path: Path, *_state: int) -> dict[str, Sheet]:
    """The file as it is in this state; it is asked for at every recompute."""
    try:
        return dict(load_sheets(path))
    except InputError as error:
        report_warning(str(error))
        return {}


def save_own_sheets(sheets: Iterable[Sheet]) -> None:
    """Write the user's sheets, which replace all that the file held.

    Raises
    ------
    InputError
        The file cannot be written, or what it holds cannot be read and would be lost.
    """
    text = "\n".join(sheet.toml() for sheet in sheets)
    path = own_sheets_file()
    if path.exists():
        load_sheets(path)
    try:
        if not text:
            path.unlink(missing_ok=True)
            return
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(
            "{path} can't be changed: {reason}; allow it to be written", path=path, reason=reason(error)
        ) from error
    write_atomically(path, text.encode(), force=True)


def sheet_list() -> list[str]:
    """Return the names of all sheets, the user's own first."""
    own = list(own_sheets())
    return own + [name for name in sheet_names() if name not in own]


def sheet_called(name: str, kept: str = "") -> Sheet:
    """The sheet of that name; where it is not in the library, the one kept (as TOML) in the document."""
    own = own_sheets()
    if name in own:
        return own[name]
    if name in built_in_figures():  # every recompute asks, and files need not be looked for
        return _built_in(name)
    if name in sheet_names():
        return Sheet.named(name)
    if kept:
        return sheet_from_text(name, kept)
    raise InputError(
        "there is no sheet called {name!r} here: choose another one, or add it to the sheet library",
        name=name,
    )


_built_in = lru_cache(maxsize=64)(Sheet.named)


@lru_cache(maxsize=64)
def text_of(sheet: Sheet) -> str:
    """A sheet's numbers as documents keep them: what `sheet_from_text` reads."""
    return sheet.toml()


def sheet_from_text(name: str, text: str) -> Sheet:
    """Return the sheet that a TOML text describes, under the given name."""
    import tomllib

    try:
        return sheets_from_table(tomllib.loads(text)["sheets"], where="this document")[name]
    except (tomllib.TOMLDecodeError, RecursionError, KeyError) as error:
        raise InputError(
            "the sheet {name!r} kept in this document cannot be read: choose another one", name=name
        ) from error
