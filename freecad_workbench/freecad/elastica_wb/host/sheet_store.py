# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Sheets that FreeCAD offers: built-in ones, the user's library, and those that FreeCAD stores in a file."""

from collections.abc import Iterable, Iterator
from functools import lru_cache
from pathlib import Path

import FreeCAD as App
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.words import report_warning

from elastica_cad._text import plain_name
from elastica_cad.errors import InputError, note
from elastica_cad.formats.write_files import reason, write_atomically
from elastica_cad.mechanics.sheets import (
    KINDS,
    Sheet,
    built_in_figures,
    built_in_titles,
    load_sheets,
    sheet_names,
    sheets_from_table,
)


def own_sheets_file() -> Path:
    """Return the path of the file with the user's sheets."""
    return Path(App.getUserAppDataDir()) / "elastica-sheets.toml"


def own_sheets() -> dict[str, Sheet]:
    """Return the user's sheets by name. An unreadable file is reported and counts as empty."""
    path = own_sheets_file()
    try:
        state = path.stat()
    except OSError:
        return {}
    return dict(_read(path, state.st_mtime_ns, state.st_size))


@lru_cache(maxsize=1)
def _read(path: Path, *_state: int) -> dict[str, Sheet]:
    """Return the sheets of a file, cached until the file changes, because every recompute needs them."""
    try:
        return dict(load_sheets(path))
    except InputError as error:
        report_warning(str(error))
        return {}


def save_own_sheets(sheets: Iterable[Sheet]) -> None:
    """Replace the user's sheets in their file. Raise InputError if the file is unreadable."""
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
            "{path} cannot be changed: {reason}. Check the folder and its permissions.",
            path=path,
            reason=reason(error),
        ) from error
    write_atomically(path, text.encode(), force=True)


def sheet_list() -> list[str]:
    """Return the names of all sheets, the user's sheets first."""
    user_sheets = list(own_sheets())
    return user_sheets + [name for name in sheet_names() if name not in user_sheets]


def titled_sheets(names: Iterable[str]) -> Iterator[tuple[str, str | None]]:
    """Yield the entries of a list of sheets, grouped by kind.

    A group begins with (title, None), followed by (full name, name) of each sheet. The user's sheets, and
    sheets stored only in the document, come first.
    """
    groups: dict[str, list[tuple[str, str]]] = {}
    built_in = built_in_figures().keys() - own_sheets().keys()
    for name in names:
        title = KINDS[_built_in(name).kind] if name in built_in else OWN
        groups.setdefault(title, []).append((title_of(name), name))
    for title in sorted(groups, key=lambda title: title != OWN):
        yield title, None
        yield from groups[title]


OWN = note("Own sheets")


def title_of(name: str) -> str:
    """Return the full name of a built-in sheet, or the name of any other sheet."""
    return name if name in own_sheets() else built_in_titles().get(name, name)


def default_sheet() -> str:
    """Return the default sheet of new strips. If the preferences name an unknown sheet, report it once."""
    name, usual = preferences.get("DefaultSheet"), preferences.DEFAULTS["DefaultSheet"]
    if name in sheet_list():
        return str(name)
    _report_unknown(name, usual)
    return str(usual)


@lru_cache(maxsize=64)
def _report_unknown(name: str, usual: str) -> None:
    report_warning(
        note(
            "The sheet {name!r} of the preferences is unknown, so new strips have the sheet {usual}. Choose "
            "another sheet in the preferences.",
            name=name,
            usual=usual,
        )
    )


def sheet_called(name: str, saved: str = "") -> Sheet:
    """Return the sheet of that name. If the library has no such sheet, return the copy `saved` (TOML)."""
    user_sheets = own_sheets()
    if name in user_sheets:
        return user_sheets[name]
    if name in built_in_figures():  # every recompute calls this function, so avoid the slow search of files
        return _built_in(name)
    if name in sheet_names():
        return Sheet.named(name)
    if saved:
        return sheet_from_text(name, saved)
    raise InputError(
        "The sheet {name!r} is unknown. Choose another sheet, or add {name!r} to the sheet library.",
        name=name,
    )


_built_in = lru_cache(maxsize=64)(Sheet.named)


@lru_cache(maxsize=64)
def text_of(sheet: Sheet) -> str:
    """Return a sheet as the TOML text that documents store."""
    return sheet.toml()


def sheet_from_text(name: str, text: str) -> Sheet:
    """Return the sheet that a TOML text of `text_of` describes, under the given name."""
    import tomllib

    try:
        return sheets_from_table(tomllib.loads(text)["sheets"], where="this document")[plain_name(name)]
    except (tomllib.TOMLDecodeError, RecursionError, KeyError) as error:
        raise InputError(
            "The sheet {name!r} stored in this document cannot be read. Choose another sheet.", name=name
        ) from error
