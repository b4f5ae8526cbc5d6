"""Draws the pictures of how-to pages and of two tutorials: python docs/how_to_pictures.py [FOLDER].

Each page is run as its reader does (tests/manual/run_page.py); pictures and cut files that it made are shown.
"""

import os
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib as mpl
import numpy as np
from PIL import Image

mpl.use("agg")
ROOT = Path(__file__).resolve().parents[1]
PICTURES = ROOT / "docs" / "how_to" / "pictures"
WIDTH_PX, COLOURS = 900, 48
MADE = {
    "batten": "out/batten.dxf",
    "bow": "out/kite-bow.png",
    "carry": "lamp/arch.png",
    "curves": "points.csv",
    "cutting": "arcs/arch.dxf",
    "design_files": "lamp-kit/sheets/*.dxf",
    "forces": "spring/straight-travel.png",
    "holding": "kit/parts/*base*.dxf",
    "install": "out/arch.png",
    "meshes": "kit/sheets/*.dxf",
    "lesson": "lesson/model/lesson.png",
    "messages": "out/arch.png",
    "models": "kit/sheets/*.dxf",
    "own_material": "coupon/*.dxf",
    "python": "arch-cut.dxf",
    "reshape": "out/*.dxf",
    "slat": "loaded/slat-bent.png",
    "styles": "holes/arch.dxf",
    "tabs": "screws/arch.dxf",
    "too_much": "out/s.png",
}
"""What a page's commands made that is shown there, by the name of the page."""

LONGEST_MM = 700.0
"""Of a drawing as much is shown from its left end: letters can be read, and a sheet of 600 mm is whole."""


def main(folder: Path = PICTURES) -> None:
    """One picture for each page, small enough to be read on a phone."""
    folder.mkdir(exist_ok=True)
    for page, made in MADE.items():
        with TemporaryDirectory() as place:
            picture = drawn(page, made, Path(place))
            height = round(picture.height * WIDTH_PX / picture.width)
            small = picture.resize((WIDTH_PX, height), Image.Resampling.LANCZOS)
            small.quantize(COLOURS).save(folder / f"{page}.png", optimize=True)
            print(folder / f"{page}.png")


def drawn(page: str, made: str, place: Path) -> Image.Image:
    """What the page made in an empty place, as a picture."""
    tools = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    environment = {**os.environ, "PATH": tools, "PYTHONPATH": str(ROOT), "MPLBACKEND": "agg"}
    (path,) = (path for part in ("how_to", "tutorials") for path in (ROOT / "docs" / part).glob(f"{page}.md"))
    run = [sys.executable, ROOT / "tests" / "manual" / "run_page.py", path]
    subprocess.run(run, cwd=place, env=environment, check=True)
    file = sorted(place.glob(made))[0]
    if file.suffix == ".png":
        return Image.open(file).convert("RGB")
    return looked_at(file, place / "looked-at.png")


def looked_at(file: Path, picture: Path) -> Image.Image:
    """The curves of a file as they lie there, in mm."""
    import elastica_cad as ec
    from elastica_cad.plot.canvas import Panel, new_page, save_figure

    lines = (
        [(curve.sample(400).position, "black") for curve in ec.read_curves(file)]
        if file.suffix == ".csv"
        else []
    )
    if file.suffix == ".dxf":
        import ezdxf
        from ezdxf.path import make_path

        colours = {"CUT_OUTER": "black", "CUT_INNER": "tab:red", "ENGRAVE": "tab:blue", "MARK": "tab:green"}
        for entity in ezdxf.readfile(file).modelspace():
            if entity.dxftype() not in ("TEXT", "MTEXT", "INSERT"):
                points = [(p.x, p.y) for p in make_path(entity).flattening(0.05)]
                lines.append((np.array(points), colours.get(entity.dxf.layer, "black")))
    every = np.concatenate([points for points, _ in lines])
    size = np.minimum(np.ptp(every, axis=0), (LONGEST_MM, np.inf))
    middle = every.min(axis=0) + size / 2
    width, height = 1.1 * np.maximum(size, 0.05 * size.max())  # the numbers of a batten's axis need room
    figure, (axes,) = new_page([Panel(min(8.0 * height / width, 6.0), below=0.5, left=0.6)])
    axes.set_xlim(middle[0] - width / 2, middle[0] + width / 2)
    axes.set_ylim(middle[1] - height / 2, middle[1] + height / 2)
    for points, colour in lines:
        axes.plot(*points.T, color=colour, linewidth=1)
    axes.set_aspect("equal")
    axes.set_xlabel("mm")
    save_figure(figure, picture)
    return Image.open(picture).convert("RGB")


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
