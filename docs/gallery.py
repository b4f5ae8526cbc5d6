"""Build every example, time it, draw it, and write docs/models_in_numbers.md.

python docs/gallery.py             the table
python docs/gallery.py --pictures  and NAME/NAME.png beside each script of examples/
"""

import runpy
import sys
import time
from contextlib import contextmanager
from pathlib import Path

import numpy as np

import elastica_cad as ec
from elastica_cad.design.design_file import read_design
from elastica_cad.form_finding import nearest_search, rod_solution

EXAMPLES = Path(__file__).parents[1] / "examples"
NUMBERS = Path(__file__).with_name("models_in_numbers.md")
race = runpy.run_path(str(Path(__file__).with_name("plain_highs.py")))["race"]
# seconds for stiffness and fabricability, and in all, from Table 1 of the paper
PAPER = {
    "shell": (1.44, 2.01),
    "flower_pot": (14.56, 16.0),
    "horse": (2.99, 14.6),
    "pavilion": (0.30, 4.23),
    "lantern": (0.473, 0.47),
    "lamp": (14.11, 14.2),
    "vase": (0.01, 0.01),
    "carpet": (3.36, 5.12),
    "facade": (7.53, 8.86),
    "spiral": None,
}
FLAT = {"spiral": 1, "vase": 1, "facade": 1, "lamp": 1}  # parts shown as they are cut
VIEWS = {
    "horse": (15.0, -70.0),
    "lamp": (35.0, -60.0),
    "spiral": (35.0, -60.0),
    "facade": (20.0, -60.0),
    "revolution": (25.0, -90.0),
}


SOLVERS = [
    (place, name)
    for place, names in (
        (ec, ("nearest_rod", "nearest_rods", "optimal_rod", "revolution")),
        (ec.mechanics, ("optimal_laminate",)),
        (rod_solution, ("rod_of_request", "laminate_of_request")),
        (nearest_search, ("find_nearest",)),  # where a request imports it from, when it may change
    )
    for name in names
]


@contextmanager
def stopwatch():
    """Processor seconds spent in finding rods while the block runs, in a list of one, and what was found."""
    spent, kept, answers = [0.0], [getattr(*solver) for solver in SOLVERS], []
    running = []

    def timed(function):
        def run(*arguments, **options):
            if running:  # within another solver
                return function(*arguments, **options)
            running.append(function)
            start = time.process_time()
            try:
                found = function(*arguments, **options)
            finally:
                running.pop()
            spent[0] += time.process_time() - start
            answers.extend(found if isinstance(found, tuple | list) else [found])
            return found

        return run

    for (place, name), function in zip(SOLVERS, kept, strict=True):
        setattr(place, name, timed(function))
    yield spent, answers
    for (place, name), function in zip(SOLVERS, kept, strict=True):
        setattr(place, name, function)


def built(name):
    """The model of an example, its nearest rods, the seconds that finding rods took, and those of the design."""
    if name == "pavilion":
        design = read_design(EXAMPLES / "pavilion" / "pavilion.toml", ec.read_curves)
        build = design.model
    else:
        build = runpy.run_path(str(EXAMPLES / name / f"{name}.py"))["build"]
    with stopwatch() as (spent, answers):
        start = time.process_time()
        model = build()
        seconds = time.process_time() - start
    return model, [found for found in answers if isinstance(found, ec.NearestRod)], spent[0], seconds


def draw(name, model):
    """NAME/NAME.png with few colours, small enough to be looked at in a page."""
    from PIL import Image

    from elastica_cad import plot

    if name == "facade":
        model = runpy.run_path(str(EXAMPLES / name / f"{name}.py"))["states"]()
    elevation, azimuth = VIEWS.get(name, (25.0, -60.0))
    file = EXAMPLES / name / f"{name}.png"
    figure = plot.model(model, elevation=elevation, azimuth=azimuth, flat=FLAT.get(name, 2))
    plot.save_figure(figure, file, force=True, resolution=90)
    Image.open(file).convert("RGB").quantize(48).save(file, optimize=True)


def draw_arch(file):
    """The first picture of README: what `make demo` draws, small enough for a page."""
    from PIL import Image

    from elastica_cad.plot.canvas import save_figure
    from elastica_cad.plot.strip_pictures import strip_sheet

    (curve,) = ec.read_curves(EXAMPLES / "arch" / "arch.dxf")
    strip = ec.make_strip(curve, "birch-plywood-0.8", max_width=40, label="ARCH")
    save_figure(strip_sheet(strip), file, force=True, resolution=90)
    Image.open(file).convert("RGB").quantize(48).save(file, optimize=True)


def shares(distances, lengths):
    """The largest of some distances in mm, and the largest share of the curve's length."""
    share = max(distance / length for distance, length in zip(distances, lengths, strict=True))
    return f"{max(distances):.3f} ({100 * share:.2f} %)"


def row(name, model, found, solving, seconds):
    """One line of the table."""
    rods = [part.strip.rod for part in model.parts]
    places = np.concatenate([p.frame.point(p.strip.rod.position) for p in model.placed])
    size = " x ".join(f"{extent / 10:.0f}" for extent in np.ptp(places, axis=0))
    times = ["" if t is None else f"{t:.2f}" for t in PAPER[name] or (None, None)]
    nodes = ", ".join(map(str, sorted({rod.s.size for rod in rods})))
    sheets = ", ".join(sorted({layer.sheet.name for part in model.parts for layer in part.strip.layers}))
    ratio = f"{min(rod.ratio for rod in rods):.2f}-{max(rod.ratio for rod in rods):.2f}"
    wish = (
        shares([near.deviation for near in found], [near.rod.length for near in found]) if found else "exact"
    )
    made = shares([part.strip.held_deviation for part in model.parts], [rod.length for rod in rods])
    return (
        f"| {name.replace('_', ' ')} | {sheets} | {len(model.placed)} ({len(rods)}) | {nodes} | {size} | {ratio} "
        f"| {wish} | {made} | {solving:.2f} | {times[0]} | {seconds:.2f} | {times[1]} |"
    )


def main(*options):
    """Write the table of the models, and draw them on request."""
    lines = [
        "| model | sheets | strips (computed) | samples | size, cm | stiffness ratio | from the target, mm "
        "| as made, mm | rods, s | paper | all, s | paper |",
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |",
    ]
    raced = [
        "| model | linear programs | ours, ms | plain HiGHS, ms | ours / HiGHS |",
        "| --- | --- | --- | --- | --- |",
    ]
    total, programs, apart = np.zeros(4), np.zeros(3), 0.0
    race([part.strip.rod for part in built("spiral")[0].parts])  # imports are paid for once
    for name, times in PAPER.items():
        model, found, solving, seconds = built(name)
        lines.append(row(name, model, found, solving, seconds))
        print(lines[-1], flush=True)
        if times:
            *spent, off = race([part.strip.rod for part in model.parts])
            raced.append(race_row(name.replace("_", " "), len(model.parts), *spent))
            total += [solving, seconds, *times]
            programs += [len(model.parts), *spent]
            apart = max(apart, off)
        if "--pictures" in options:
            draw(name, model)
    if "--pictures" in options:
        draw_arch(EXAMPLES / "arch" / "arch.png")
    lines.append(
        f"| all of the paper's | | | | | | | | {total[0]:.2f} | {total[2]:.2f} | {total[1]:.2f} | {total[3]:.2f} |"
    )
    raced.append(race_row("all", *programs))
    text = (
        "# The paper's models in numbers\n\n"
        "This page is for readers of [the paper](explanation/reproduce_the_paper.md) by Hafner and Bickel. "
        "`python docs/gallery.py` writes it from one run. Seconds are processor time. The columns are:\n\n"
        "- *strips (computed)*: strips of the model, and how many of them were computed (the others are copies); "
        "*samples*: places along a strip at which it is computed;\n"
        "- *stiffness ratio*: largest stiffness of a strip divided by its smallest, from the least to the largest "
        "of all strips;\n"
        "- *from the target*: the largest distance between the design and the requested curve, in mm and as a "
        "fraction of the curve's length (*exact*: no curve was changed);\n"
        "- *as made*: the largest computed distance between a strip in its fixtures and its design, without "
        "errors of sheet and work, in mm and as a fraction of its length;\n"
        "- *rods*: seconds to compute the stiffness within the limits; *all*: seconds for the whole design, from "
        "surfaces or formulae to strips;\n"
        "- *paper*: the seconds in Table 1 of Hafner and Bickel, measured on another machine. Except for the "
        "Pavilion and the Spiral, their surfaces were different but similar.\n\n" + "\n".join(lines) + "\n\n"
        f"The rods of the paper's models took {total[0] / total[2]:.1%} of the paper's seconds.\n\n"
        "## Compared with HiGHS\n\n"
        "HiGHS is a solver of linear programs. This table compares two ways to compute "
        "the least stiffness ratio of every computed strip above, at its "
        "samples. *Ours* is `sampled_stiffness`; *plain HiGHS* solves the paper's linear programs with all rows at "
        "once (Eq. 4; with weight Eq. 6 with its 3n + 4 variables). "
        f"Both find the same ratios to {apart:.0e}.\n\n" + "\n".join(raced) + "\n"
    )
    NUMBERS.write_text(text, encoding="utf-8")


def race_row(name, count, ours, plain):
    """One line of the table of linear programs."""
    return f"| {name} | {count:.0f} | {1000 * ours:.1f} | {1000 * plain:.1f} | {ours / plain:.1%} |"


if __name__ == "__main__":
    main(*sys.argv[1:])
