"""`elastica compare`: compare measurements of bent strips with the report of a strip or a model."""

from functools import partial
from pathlib import Path

import click

from elastica_cad._text import distinct, file_word
from elastica_cad.cli.options import LENGTH, refuse_idle
from elastica_cad.cli.voice import answer, say_rows, wrote
from elastica_cad.design.measuring_sheet import (
    ERRORS,
    blank_readings,
    measuring_page,
    read_measuring,
    read_readings,
)
from elastica_cad.errors import InputError, Listed
from elastica_cad.files import save
from elastica_cad.formats.write_files import File, text_file, write_files
from elastica_cad.report_rows import Row


@click.command()
@click.argument("report", type=click.Path(path_type=Path, exists=True, dir_okay=False))
@click.argument("measured", type=click.Path(path_type=Path, exists=True, dir_okay=False), required=False)
@click.option("--reading-error", type=LENGTH, metavar="MM",
              help="Typical error of measured lengths  [default: reading_error in MEASURED, or 2].")  # fmt: skip
@click.option("--force", is_flag=True, help="Overwrite files.")
def compare(report: Path, measured: Path | None, reading_error: float | None, force: bool) -> None:
    """Compare measurements of a built strip with its design.

    REPORT is NAME.json by `elastica strip` or `elastica model`, and MEASURED has the measurements.

    Without MEASURED it writes files beside the report: for each strip, a page NAME-measure.svg (places to measure,
    expected values, meaning of differences), and NAME-measured.toml to fill in, with a table for each strip of a
    model.

    \b
      elastica compare out/arch.json
      elastica compare out/arch.json out/arch-measured.toml --reading-error 2
    """
    refuse_idle({"reading_error": ("measured",)}, {"measured": ("force",)})
    strips = read_measuring(report)
    expected = {strip: dict(measuring.expected) for strip, measuring in strips.items()}
    if measured is not None:
        rows = []
        strips_read, errors = read_readings(measured)
        if reading_error is not None:
            errors["reading_error"] = reading_error
        for strip, readings in strips_read.items():
            if strip not in strips:
                raise InputError(
                    "{path} has the table [{strip}], but the report is of a single strip. Delete this line."
                    if "" in strips else
                    "{path}: {strip!r} is not a strip of the model. Write the readings below the lines {tables}.",
                    path=measured, strip=strip, tables=", ".join(f"[{name}]" for name in strips),
                )  # fmt: skip
            rows += [Row("Strip", strip)] if strip else []
            rows += strips[strip].compare(readings, **errors)
        rows += [
            Row("Note", f"{key} has no effect, because none of {Listed(ERRORS[key])} is measured.")
            for key in errors
            if not any(readings.keys() & ERRORS[key] for readings in strips_read.values())
        ]
        say_rows(*rows, is_answer=True)
        answer(
            {
                "expected": expected.get("", expected),
                "said": [row.text for row in rows],
                "rows": [{"label": row.label, "text": row.text, "severity": row.severity} for row in rows],
            }
        )
        return
    stem = file_word(report.stem)
    names = distinct(f"{stem}-{file_word(strip)}" if strip else stem for strip in strips)
    files = (
        *(
            File(f"{name}-measure.svg", partial(save, measuring_page(name, measuring)))
            for name, measuring in zip(names, strips.values(), strict=True)
        ),
        text_file(f"{stem}-measured.toml", blank_readings(strips)),
    )
    wrote(write_files(files, report.parent, force=force))
    answer({"expected": expected.get("", expected)})
