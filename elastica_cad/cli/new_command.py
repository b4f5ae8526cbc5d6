"""`elastica new`: write a commented design file of `cli/templates` that can be used unchanged, and the schema for
editors.
"""

import json
import os
from importlib.resources import files
from pathlib import Path

import click
import numpy as np

from elastica_cad._text import quote_words
from elastica_cad.cli.options import output_options
from elastica_cad.cli.suggestions import name_program
from elastica_cad.cli.voice import answer, say_rows, wrote
from elastica_cad.design.design_schema import SCHEMA_FILE, design_schema
from elastica_cad.formats.curve_writer import write_curves
from elastica_cad.formats.write_files import File, text_file, write_files
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.report_rows import Row

ARCH_MM = (
    (0, 0), (40, 5), (80, 40), (125, 160), (200, 175), (275, 160), (320, 40), (360, 5), (400, 0),
)  # fmt: skip
AROUND, UP = 48, 25


@click.command()
@click.argument("kind", type=click.Choice(["arch", "lamp", "pavilion", "revolution", "sections", "schema"]))
@output_options
def new(kind: str, output: Path, force: bool) -> None:
    """Write a commented design file as a start.

    The file KIND.toml is ready for `elastica model`. Kinds:

    arch: a strip along arch.dxf between two printed blocks; lamp: twelve strips between two rings; pavilion:
    interlocking strips on a base; revolution: a closed surface of equal strips; sections: strips along the mesh
    bowl.obj.

    It also writes elastica.schema.json, with which TOML editors complete and check keys. The kind schema writes
    this file alone, for existing designs. Begin these designs with the line #:schema elastica.schema.json
    """
    text = json.dumps(design_schema(), indent=1) + "\n"
    schema = text_file(SCHEMA_FILE, text)
    if kind == "schema":
        wrote(write_files([schema], output, force=force))
        answer({"kind": kind})
        return
    template = files("elastica_cad.cli").joinpath("templates", f"{kind}.toml").read_bytes()
    new_files = [File(f"{kind}.toml", lambda path: path.write_bytes(template))]
    if kind == "arch":
        new_files.append(
            File("arch.dxf", lambda path: write_curves([PlaneCurve.spline(ARCH_MM, degree=4)], path))
        )
    if kind == "sections":
        new_files.append(text_file("bowl.obj", _bowl()))
    present = output / SCHEMA_FILE
    if not (os.path.isfile(present) and present.read_bytes() == text.encode()):
        new_files.append(schema)
    wrote(write_files(new_files, output, force=force))
    typed = quote_words(["model", str(output / f"{kind}.toml"), "-o", str(output / f"{kind}-kit")])
    following = f"{name_program()} {typed}"
    say_rows(Row("Next", following))
    answer({"kind": kind, "next": following})


def _bowl() -> str:
    """Return an OBJ file with the mesh of a bowl, for an example."""
    t = np.linspace(0.0, 1.0, UP)[:, None]
    turn = 2 * np.pi * np.arange(AROUND) / AROUND
    least, bulge, height = 60.0, 45.0, 140.0  # least radius, bulge and height, mm
    radius = least + bulge * np.sin(np.pi * (0.12 + 0.7 * t))
    rows = np.stack(np.broadcast_arrays(radius * np.cos(turn), radius * np.sin(turn), height * t), axis=-1)
    lines = [f"v {x:.4f} {y:.4f} {z:.4f}" for x, y, z in rows.reshape(-1, 3)]
    for ring in range(UP - 1):
        for k in range(AROUND):
            a, b = ring * AROUND + k + 1, ring * AROUND + (k + 1) % AROUND + 1
            lines.append(f"f {a} {b} {b + AROUND} {a + AROUND}")
    return "\n".join(lines) + "\n"
