"""`elastica sheets`: list the known materials."""

import click

from elastica_cad.cli.voice import answer, say, warn
from elastica_cad.mechanics.sheets import (
    PLYWOOD_SOURCE,
    Sheet,
    least_plywood_radius,
    library_folders,
    library_sheets,
    sheet_names,
    sheets_by_kind,
)


@click.command()
@click.argument("name", required=False)
def sheets(name: str | None) -> None:
    """List all sheets, or all properties of the sheet NAME (or of a file, my.toml) with their source.

    Materials vary. Measure a coupon of your sheet before a large job. `elastica coupon` writes your sheets as TOML
    files. Use such a file as --sheet my.toml, or copy it into the library and use its name. The library is the
    folder below the list, or the folder in the environment variable ELASTICA_SHEETS.
    """
    if name is None:
        answer({"sheets": [Sheet.named(known) for known in sheet_names()]})
        groups = sheets_by_kind()
        every = [one for of_kind in groups.values() for one in of_kind]
        wide, broad = (max(len(getattr(one, text)) for one in every) for text in ("full_name", "name"))
        say(
            f"{'sheet':{wide}} {'name':{broad}} {'E MPa':>8} {'kg/m3':>6} {'strain %':>8} "
            f"{'radius mm':>9} {'kerf':>5}"
        )
        for title, of_kind in groups.items():
            say(f"\n{title}")
            for one in of_kind:
                kerf = f"{one.kerf:.2f}" if one.kerf else "-"
                say(
                    f"{one.full_name:{wide}} {one.name:{broad}} {one.youngs_modulus:8.0f} {one.density:6.0f} "
                    f"{100 * one.max_strain:8.2f} {one.least_radius:9.1f} {kerf:>5}"
                )
        say(
            "\nradius: least advisable bending radius; kerf -: not known. All properties: elastica sheets NAME"
        )
        say(f"library: {', '.join(map(str, library_folders()))} ({len(library_sheets()[0])} sheets)")
        for problem in library_sheets()[1]:
            warn(f"Note: {problem}")
        return
    one = Sheet.named(name)
    answer({"sheets": [one]})
    rows = {
        "thickness": f"{one.thickness:g} mm",
        "Young's modulus": f"{one.youngs_modulus:g} MPa",
        "Poisson's ratio": f"{one.poisson_ratio:g}" + ("" if one.poisson_known else ", nominal"),
        "shear modulus": f"{one.shear_ratio * one.youngs_modulus:.4g} MPa"
        + ("" if one.shear_modulus else ", as without grain"),
        "density": f"{one.density:g} kg/m3",
        "largest strain": f"{100 * one.max_strain:.3g} %",
        "least radius": f"{one.least_radius:.4g} mm",
        **_published(one),
        "kerf": f"{one.kerf:g} mm" if one.kerf else "not known: cut a coupon",
        "grain": str(one.grain),
        "elasto-gravity length": f"{one.elasto_gravity_length:.4g} mm",
        "source": one.source,
    }
    say(one.full_name if one.full_name == one.name else f"{one.full_name} ({one.name})")
    for label, text in rows.items():
        say(f"  {label:22} {text}")


def _published(sheet: Sheet) -> dict[str, str]:
    """The published radii of plywood, along and across its face grain."""
    along, across = (least_plywood_radius(sheet.thickness, way) for way in ("along", "across"))
    if sheet.kind != "plywood" or along is None or across is None:
        return {}
    told = f"{along:.3g} mm along the face grain, {across:.3g} mm across it ({PLYWOOD_SOURCE})"
    return {"published radius": told}
