"""`elastica new`: a commented design file to start from, which runs as it is."""

from importlib.resources import files
from pathlib import Path

import click
import numpy as np

from elastica_cad.formats.file_access.file_transaction import write_together

KINDS = ("arch", "lamp", "pavilion", "revolution", "sections")

BOWL_MM = (60.0, 45.0, 140.0)  # least radius, bulge and height of the mesh that `sections` starts with
AROUND, UP = 48, 25  # its points


@click.command()
@click.argument("kind", type=click.Choice(KINDS))
@click.option("-o", "--output", type=click.Path(path_type=Path), default=Path(), help="Folder for the file.")
@click.option("--force", is_flag=True, help="Overwrite a file that exists.")
def new(kind: str, output: Path, force: bool) -> None:
    """Write KIND.toml, a commented design file that `elastica model` makes as it is.

    arch: one strip between two printed blocks; lamp: a ring above and below twelve strips; pavilion: strips that
    lock into each other on a base; revolution: a closed surface of equal strips; sections: strips along a mesh.
    """
    text = files("elastica_cad.cli").joinpath("templates", f"{kind}.toml").read_bytes()
    written = {f"{kind}.toml": text}
    if kind == "sections":
        written["bowl.obj"] = _bowl().encode("ascii")
    with write_together(output, written, force=force) as folder:
        for name, content in written.items():
            (folder / name).write_bytes(content)
    click.echo(f"wrote {' and '.join(str(output / name) for name in written)}")
    click.echo(f"next: elastica model {output / f'{kind}.toml'} -o {output / f'{kind}-kit'}")


def _bowl() -> str:
    """A round surface about z as OBJ."""
    t = np.linspace(0.0, 1.0, UP)[:, None]
    turn = 2 * np.pi * np.arange(AROUND) / AROUND
    least, bulge, height = BOWL_MM
    radius = least + bulge * np.sin(np.pi * (0.12 + 0.7 * t))
    rows = np.stack(np.broadcast_arrays(radius * np.cos(turn), radius * np.sin(turn), height * t), axis=-1)
    lines = [f"v {x:.4f} {y:.4f} {z:.4f}" for x, y, z in rows.reshape(-1, 3)]
    for ring in range(UP - 1):
        for k in range(AROUND):
            a, b = ring * AROUND + k + 1, ring * AROUND + (k + 1) % AROUND + 1
            lines.append(f"f {a} {b} {b + AROUND} {a + AROUND}")
    return "\n".join(lines) + "\n"
