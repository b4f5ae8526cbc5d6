"""Writer of GLB files with animated meshes. Every frame is a morph target, played in order."""

import json
import struct
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from elastica_cad._types import FloatArray, IntArray

GLB_MAGIC, GLB_VERSION, JSON_CHUNK, BINARY_CHUNK = 0x46546C67, 2, 0x4E4F534A, 0x004E4942
FLOAT, UNSIGNED_INT, ARRAY_BUFFER, ELEMENT_BUFFER = 5126, 5125, 34962, 34963


@dataclass(frozen=True, eq=False)
class MovingMesh:
    """A mesh of triangles whose points move from frame to frame.

    Attributes
    ----------
    name : str
    color : (red, green, blue)
        sRGB, 0..1.
    points, normals : (frames, n, 3) array
        Positions, mm, with z upward, and unit normals.
    triangles : (m, 3) array of int
        Corners, anticlockwise from outside.
    """

    name: str
    color: tuple[float, ...]
    points: FloatArray
    normals: FloatArray
    triangles: IntArray


def encode_animation(meshes: Sequence[MovingMesh], seconds: float) -> bytes:
    """Encode meshes as a GLB file, whose animation runs forward and backward through the frames in `seconds`.

    Examples
    --------
    >>> corner = np.zeros((2, 3, 3))
    >>> corner[:, 1, 0], corner[:, 2, 1], corner[1, 2, 2] = 1, 1, 1
    >>> up = np.tile([0.0, 0.0, 1.0], (2, 3, 1))
    >>> mesh = MovingMesh("flap", (0.8, 0.7, 0.5), corner, up, np.array([[0, 1, 2]]))
    >>> encode_animation([mesh], 2.0)[:4]
    b'glTF'
    """
    file = _Buffers()
    nodes: list[Any] = []
    shapes: list[Any] = []
    materials: list[Any] = []
    channels, samplers = [], []
    frames = len(meshes[0].points)
    # index of the frame at each of the equal times of the animation
    there_and_back = np.concatenate([np.arange(frames), np.arange(frames - 1)[::-1]])
    clock = file.add(np.linspace(0.0, seconds, 2 * frames - 1), "SCALAR", bounds=True)
    for k, mesh in enumerate(meshes):
        first, normal = mesh.points[0], mesh.normals[0]
        targets = [
            {"POSITION": file.add(p - first, "VEC3", bounds=True), "NORMAL": file.add(n - normal, "VEC3")}
            for p, n in zip(mesh.points[1:], mesh.normals[1:], strict=True)
        ]
        skin = {
            "attributes": {
                "POSITION": file.add(first, "VEC3", bounds=True, target=ARRAY_BUFFER),
                "NORMAL": file.add(normal, "VEC3", target=ARRAY_BUFFER),
            },
            "indices": file.add(mesh.triangles.ravel(), "SCALAR", kind=UNSIGNED_INT, target=ELEMENT_BUFFER),
            "material": k,
            "targets": targets,
        }
        c = np.asarray(mesh.color)
        # glTF needs the linear values of an sRGB colour (transfer function of IEC 61966-2-1)
        linear = np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)
        paint = {
            "baseColorFactor": [*linear.tolist(), 1.0],
            "metallicFactor": 0.0,
            "roughnessFactor": 0.8,
        }
        materials.append({"name": mesh.name, "pbrMetallicRoughness": paint})
        # glTF is in metres, with y upward; the rotation (quaternion x, y, z, w) turns z, our upward axis, to y
        place = {"scale": [1e-3] * 3, "rotation": [-(0.5**0.5), 0.0, 0.0, 0.5**0.5]}
        nodes.append({"name": mesh.name, "mesh": k, **place})
        shapes.append({"name": mesh.name, "primitives": [skin], "weights": [0.0] * len(targets)})
        # weights of the targets at each time: 1 for the target of the frame; the first frame has no target
        keys = np.eye(frames, frames - 1, -1)[there_and_back].ravel()
        samplers.append({"input": clock, "output": file.add(keys, "SCALAR"), "interpolation": "LINEAR"})
        channels.append({"sampler": k, "target": {"node": k, "path": "weights"}})
    return file.glb({
        "asset": {"version": "2.0", "generator": "elastica_cad"},
        "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": nodes, "meshes": shapes, "materials": materials,
        "animations": [{"name": "travel", "channels": channels, "samplers": samplers}],
    })  # fmt: skip


class _Buffers:
    """Binary chunk of a GLB file, with buffer views and accessors."""

    def __init__(self) -> None:
        self.binary = bytearray()
        self.views: list[dict[str, Any]] = []
        self.accessors: list[dict[str, Any]] = []

    def add(
        self, values: Any, shape: str, *, kind: int = FLOAT, bounds: bool = False, target: int | None = None
    ) -> int:
        """Append values as a buffer view and an accessor of glTF, and return the index of the accessor.

        All components have 4 bytes, so views need no padding. `shape` is the type of an element, such as "VEC3".
        """
        rows = np.ascontiguousarray(values, dtype="<f4" if kind == FLOAT else "<u4")
        view: dict[str, Any] = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": rows.nbytes}
        about: dict[str, Any] = {"bufferView": len(self.views), "componentType": kind, "count": len(rows)}
        if target is not None:
            view["target"] = target
        if bounds:
            flat = rows.reshape(len(rows), -1)
            about |= {"min": flat.min(axis=0).tolist(), "max": flat.max(axis=0).tolist()}
        self.views.append(view)
        self.accessors.append(about | {"type": shape})
        self.binary += rows.tobytes()
        return len(self.accessors) - 1

    def glb(self, content: dict[str, Any]) -> bytes:
        """Return the bytes of the file: its header, the JSON chunk with `content`, and the binary chunk."""
        sizes = [{"byteLength": len(self.binary)}]
        text = json.dumps(
            content | {"buffers": sizes, "bufferViews": self.views, "accessors": self.accessors}
        )
        chunks = ((JSON_CHUNK, text.encode(), b" "), (BINARY_CHUNK, bytes(self.binary), b"\0"))
        body = b""
        for kind, data, fill in chunks:
            padded = data + fill * (-len(data) % 4)
            body += struct.pack("<II", len(padded), kind) + padded
        return struct.pack("<III", GLB_MAGIC, GLB_VERSION, 12 + len(body)) + body
