"""`elastica sheets`: the materials that elastica_cad knows."""

import click

from elastica_cad.mechanics.material.sheet import Sheet, sheet_names


@click.command()
@click.argument("name", required=False)
def sheets(name: str | None) -> None:
    """List the built-in sheets, or all that is known of the sheet NAME, with its source.

    Materials vary: cut a coupon and measure your own before a large job.
    """
    if name is None:
        click.echo(
            f"{'name':26} {'mm':>5} {'E MPa':>8} {'kg/m3':>6} {'strain %':>8} {'radius mm':>9} {'kerf':>5}"
        )
        for known in sheet_names():
            one = Sheet.named(known)
            click.echo(
                f"{one.name:26} {one.thickness:5.2f} {one.youngs_modulus:8.0f} {one.density:6.0f} "
                f"{100 * one.max_strain:8.2f} {one.least_radius:9.1f} {one.kerf:5.2f}"
            )
        click.echo("\nradius: the least advisable bending radius. Details and source: elastica sheets NAME")
        return
    one = Sheet.named(name)
    rows = {
        "thickness": f"{one.thickness:g} mm",
        "Young's modulus": f"{one.youngs_modulus:g} MPa",
        "density": f"{one.density:g} kg/m3",
        "largest strain": f"{100 * one.max_strain:.3g} %",
        "least radius": f"{one.least_radius:.4g} mm",
        "kerf": f"{one.kerf:g} mm",
        "grain": str(one.grain),
        "elasto-gravity length": f"{one.elasto_gravity_length:.4g} mm",
        "source": one.source,
    }
    click.echo(one.name)
    for label, text in rows.items():
        click.echo(f"  {label:22} {text}")
