"""`elastica compare`: compare measurements of a bent strip with its report."""

from functools import partial
from pathlib import Path

import click

from elastica_cad.cli.voice import answer, say_row, wrote
from elastica_cad.design.measuring_sheet import blank_readings, measuring_page, read_measuring, read_readings
from elastica_cad.files import save
from elastica_cad.formats.write_files import File, write_files, write_text


@click.command()
@click.argument("report", type=click.Path(path_type=Path, exists=True, dir_okay=False))
@click.argument("measured", type=click.Path(path_type=Path, exists=True, dir_okay=False), required=False)
@click.option("--force", is_flag=True, help="Overwrite files.")
def compare(report: Path, measured: Path | None, force: bool) -> None:
    """Compare the measurements in MEASURED with the REPORT of a strip (NAME.json by `elastica strip`).

    Without MEASURED it writes two files beside the report: the page NAME-measure.svg (places to measure, expected
    values, meaning of differences), and NAME-measured.toml to fill in.

    \b
      elastica compare out/arch.json
      elastica compare out/arch.json out/arch-measured.toml
    """
    measuring = read_measuring(report)
    if measured is not None:
        rows = measuring.compare(read_readings(measured))
        for row in rows:
            say_row(row, is_answer=True)
        answer(
            {
                "expected": dict(measuring.expected),
                "said": [row.text for row in rows],
                "rows": [{"label": row.label, "text": row.text, "severity": row.severity} for row in rows],
            }
        )
        return
    name = report.stem
    files = (
        File(f"{name}-measure.svg", partial(save, measuring_page(name, measuring))),
        File(f"{name}-measured.toml", lambda path: write_text(path, blank_readings(measuring))),
    )
    wrote(write_files(files, report.parent, force=force))
    answer({"expected": dict(measuring.expected)})
