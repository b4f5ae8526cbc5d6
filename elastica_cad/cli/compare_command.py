"""`elastica compare`: what was measured on a bent strip, beside what its report expects."""

from functools import partial
from pathlib import Path

import click

from elastica_cad.cli.voice import answer, say, wrote
from elastica_cad.design.measuring_sheet import blank_readings, measuring_page, read_measuring, read_readings
from elastica_cad.files import save
from elastica_cad.formats.write_files import File, write_files, write_text


@click.command()
@click.argument("report", type=click.Path(path_type=Path, exists=True, dir_okay=False))
@click.argument("measured", type=click.Path(path_type=Path, exists=True, dir_okay=False), required=False)
@click.option("--force", is_flag=True, help="Overwrite files.")
def compare(report: Path, measured: Path | None, force: bool) -> None:
    """Tell what the readings in MEASURED say of the strip whose REPORT (NAME.json) `elastica strip` wrote.

    Without readings it writes a page beside the report, NAME-measure.svg, that says where to measure, what is
    expected and what differences mean, and NAME-measured.toml to fill in.

    \b
      elastica compare out/arch.json
      elastica compare out/arch.json out/arch-measured.toml
    """
    measuring = read_measuring(report)
    if measured is not None:
        said = measuring.compare(read_readings(measured))
        for sentence in said:
            say(sentence)
        answer({"expected": dict(measuring.expected), "said": [str(one) for one in said]})
        return
    name = report.stem
    files = (
        File(f"{name}-measure.svg", partial(save, measuring_page(name, measuring))),
        File(f"{name}-measured.toml", lambda path: write_text(path, blank_readings(measuring))),
    )
    wrote(write_files(files, report.parent, force=force))
    answer({"expected": dict(measuring.expected)})
