"""`elastica sheets`: list the known materials."""

import re
from collections.abc import Iterator

import click

from elastica_cad._values import counted
from elastica_cad.cli.voice import answer, say, warn
from elastica_cad.errors import number_text
from elastica_cad.mechanics.sheets import (
    PLYWOOD_SOURCE,
    Sheet,
    least_plywood_radius,
    library_folders,
    library_sheets,
    sheet_names,
    sheets_by_kind,
)

SOURCE_LABELS = {
    "thickness": "thickness", "E": "Young's modulus", "nu": "Poisson's ratio", "G": "shear modulus",
    "density": "density", "strain": "largest strain", "break": "breaking strain", "kerf": "kerf",
}  # fmt: skip
"""Names of the properties, by the word by which the sources of a sheet name them."""


@click.command()
@click.argument("name", required=False)
def sheets(name: str | None) -> None:
    """List all sheets, or the properties of one sheet.

    NAME is a sheet or a file, my.toml. Its properties are listed with their sources.

    Materials vary. Measure a coupon of your sheet before a large job. `elastica coupon` writes your sheets as TOML
    files. Use such a file as --sheet my.toml, or copy it into the library and use its name. The library is the
    folder below the list, or the folder in the environment variable ELASTICA_SHEETS.
    """
    if name is None:
        answer({"sheets": [Sheet.named(sheet_name) for sheet_name in sheet_names()]})
        groups = sheets_by_kind()
        every = [sheet for of_kind in groups.values() for sheet in of_kind]
        wide, broad = (max(len(getattr(sheet, text)) for sheet in every) for text in ("full_name", "name"))
        say(
            f"{'material':{wide}} {'--sheet':{broad}} {'E MPa':>8} {'kg/m3':>6} {'strain %':>8} "
            f"{'radius mm':>9} {'kerf mm':>7}"
        )
        for title, of_kind in groups.items():
            say(f"\n{title}")
            for sheet in of_kind:
                kerf = f"{sheet.kerf:.2f}" if sheet.kerf else "-"
                say(
                    f"{sheet.full_name:{wide}} {sheet.name:{broad}} {sheet.youngs_modulus:8.0f} "
                    f"{sheet.density:6.0f} {100 * sheet.max_strain:8.2f} {sheet.least_radius:9.1f} {kerf:>7}"
                )
        say(
            "\n--sheet: the word to type after --sheet; E: Young's modulus, the stiffness of the material; strain: "
            "largest allowed strain;\nradius: least allowed bending radius; kerf: width of a laser cut, - if "
            "not known; across the grain: for strips cut\nacross the face grain; rods: for elastica bow, with "
            "--rod DIAMETER. All properties: elastica sheets NAME"
        )
        listed, problems = library_sheets()
        folders = ", ".join(map(str, library_folders()))
        contents = counted(len(listed), "sheet") if listed else "empty"
        say(
            "library: put the files of your own sheets, NAME.toml as `elastica coupon` writes it, into "
            f"{folders} (now {contents})"
        )
        for problem in problems:
            warn(f"Note: {problem}")
        return
    sheet = Sheet.named(name)
    answer({"sheets": [sheet]})
    rows = {
        "thickness": f"{sheet.thickness:g} mm",
        "Young's modulus": f"{number_text(sheet.youngs_modulus, 'g')} MPa"
        + _in_range(sheet.youngs_modulus_range),
        "Poisson's ratio": f"{sheet.poisson_ratio:g} (stretched by 1 %, the material narrows by "
        + f"{sheet.poisson_ratio:g} %; "
        + ("used for the widths)" if sheet.poisson_known else "assumed, and used only for estimates)"),
        "shear modulus": f"{number_text(sheet.shear_ratio * sheet.youngs_modulus, '.4g')} MPa"
        + ", against twisting and tipping over sideways"
        + ("" if sheet.shear_modulus else " (assumed, as of a material without grain)"),
        "density": f"{sheet.density:g} kg/m3",
        "largest strain": f"{100 * sheet.max_strain:.3g} %" + _in_range(sheet.max_strain_range, 100),
        "least radius": f"{number_text(sheet.least_radius, '.4g')} mm",
        **_published_radii(sheet),
        "kerf": f"{sheet.kerf:g} mm" if sheet.kerf else "not known: cut a coupon",
        "grain": sheet.grain if sheet.grain == "none" else f"{sheet.grain} the strip",
        "elasto-gravity length": f"{number_text(sheet.elasto_gravity_length, '.4g')} mm; a strip of this "
        "length, held level at one end, sags by about 1/8 of it",
    }
    say(sheet.full_name if sheet.full_name == sheet.name else f"{sheet.full_name} ({sheet.name})")
    for label, text in (*rows.items(), *_sources(sheet.source)):
        say(f"  {label:22} {text}".rstrip())


def _sources(source: str) -> Iterator[tuple[str, str]]:
    """Yield the rows on the sources of a sheet's properties, from its text of all sources."""
    labels = "|".join(SOURCE_LABELS)
    parts = [part for part in re.split(rf"; (?=(?:{labels})(?:: | not ))", source) if part]
    if parts:
        yield "sources", ""
    for part in parts:
        named = re.fullmatch(rf"({labels})(?::| (?=not )) ?(.*)", part, re.DOTALL)
        yield ("  notes", part) if named is None else (f"  {SOURCE_LABELS[named[1]]}", named[2])


def _in_range(limits: tuple[float, float] | None, factor: float = 1.0) -> str:
    if limits is None:
        return ""
    low, high = (number_text(factor * limit) for limit in limits)
    return f" (range {low} to {high})"


def _published_radii(sheet: Sheet) -> dict[str, str]:
    """Return the row on published radii of plywood; none for other sheets."""
    along, across = (least_plywood_radius(sheet.thickness, direction) for direction in ("along", "across"))
    if sheet.kind != "plywood" or along is None or across is None:
        return {}
    # round to two digits, like the radii in the table of `PLYWOOD_SOURCE`
    along, across = (float(f"{radius:.2g}") for radius in (along, across))
    radii = f"{along:g} mm along the face grain, {across:g} mm across it ({PLYWOOD_SOURCE})"
    return {"published radius": radii}
