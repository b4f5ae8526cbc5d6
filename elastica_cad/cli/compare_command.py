"""`elastica compare`: what was measured on a bent strip, beside what its report expects."""

from pathlib import Path

import click

from elastica_cad.cli.voice import answer, say, wrote
from elastica_cad.design.measuring_sheet import blank_readings, measuring_page, read_measuring, read_readings
from elastica_cad.files import save
from elastica_cad.formats.write_files import write_text, write_together


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
    page, readings = f"{name}-measure.svg", f"{name}-measured.toml"
    with write_together(report.parent, (page, readings), force=force) as folder:
        save(measuring_page(name, measuring), folder / page)
        write_text(folder / readings, blank_readings(measuring))
    wrote([report.parent / page, report.parent / readings])
    answer({"expected": dict(measuring.expected)})
