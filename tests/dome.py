"""A dome as a mesh, for designs whose strips follow sections of a surface."""

import numpy as np

UP, AROUND = 13, 33


def dome():
    """Vertices (n, 3), mm, of a dome of radius 100 and height 80, and faces (m, 4) that count vertices from 1."""
    up, around = np.meshgrid(np.linspace(0, np.pi / 2, UP), np.linspace(0, 2 * np.pi, AROUND), indexing="ij")
    points = np.stack(
        [100 * np.cos(up) * np.cos(around), 100 * np.cos(up) * np.sin(around), 80 * np.sin(up)], -1
    )
    points[:, -1], points[-1] = points[:, 0], (0, 0, 80)
    corner = (np.arange(UP - 1)[:, None] * AROUND + np.arange(AROUND - 1)).ravel()
    faces = np.stack([corner, corner + 1, corner + AROUND + 1, corner + AROUND], -1) + 1
    return points.reshape(-1, 3), faces


def obj_text(points, faces):
    """The lines of an OBJ file."""
    return "\n".join(
        [f"v {x} {y} {z}" for x, y, z in points] + [f"f {a} {b} {c} {d}" for a, b, c, d in faces]
    )
