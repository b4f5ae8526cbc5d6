"""Draw lamp.png, arch.png and slotted.png beside this file (needs build123d and matplotlib)."""

import runpy
from pathlib import Path

from elastica_cad import plot

HERE = Path(__file__).parent
PICTURES = {
    "lamp": ("lamp_build123d.py", "lamp", "Ten equal strips between two rings", (18, -60)),
    "arch": ("arch_build123d.py", "assembly", "An arch bolted to two feet", (22, -52)),
    "slotted": (
        "slotted_build123d.py",
        "both",
        "A sketched spline: the slotted strip, bent and flat",
        (38, -66),
    ),
}


def meshes(assembly):
    """Vertices, triangles and colour of every part."""
    for part in assembly.children:
        vertices, triangles = part.tessellate(0.05, 0.1)
        color = tuple(part.color)[:3] if part.color else (0.85, 0.70, 0.48)
        yield [tuple(vertex) for vertex in vertices], triangles, color


def draw(name):
    """The figure of one example."""
    script, assembly, title, (elevation, azimuth) = PICTURES[name]
    parts = runpy.run_path(str(HERE / script))[assembly]
    return plot.bodies(list(meshes(parts)), title=title, elevation=elevation, azimuth=azimuth)


if __name__ == "__main__":
    for name in PICTURES:
        plot.save_figure(draw(name), HERE / f"{name}.png", force=True, resolution=68)
