"""What users of three kernels do to bodies of strips: each operation answers with the body it made, or raises."""

import os
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path as File
from typing import Any

import numpy as np

from elastica_cad import Path, Profile, Strip
from elastica_cad.geometry import Segment, Spline
from elastica_cad.strip import BentSolid, FlatSolid
from elastica_cad.strip.outline import graph

__all__ = ["KERNELS", "OPERATIONS", "PATIENCE", "SHARED", "Bodies", "kernel_named"]

SMALL, OFFSET, WALL = 0.2, 0.1, 0.15  # mm: fillets and chamfers, outlines, shells
NEAR = 2e-3  # mm: an edge is that which passes this near to a point
MESHES = ((1.2, 10, False), (0.6, 10, False), (1.2, 10, True), (1.2, 1, True), (0.8, 10, True))
"""Elements in mm, gmsh's algorithm (10 is HXT, 1 Delaunay), and whether its optimizers run: cheap ones first."""
SICN = 0.3  # of the worst element of a mesh

OPERATIONS = (
    "volume", "fillet", "chamfer", "fillet flat", "chamfer flat", "offset", "inset", "shell", "shell flat",
    "boolean", "mirror", "split", "mesh", "STEP", "BOP",
)  # fmt: skip

PATIENCE = dict.fromkeys(OPERATIONS, 10) | {"shell": 20, "shell flat": 20, "mesh": 60, "BOP": 60}
"""Processor seconds after which an operation has failed."""

SHARED = ("mesh", "STEP", "BOP")
"""Asked of OpenCASCADE itself: what one of build123d and CadQuery answers, the other does with the same body."""


class Bodies:
    """A strip's records, and the places on its bent body by which edges and faces are found in every kernel.

    With `points` the long sides are drawn anew, through so many of their points: a plain body with the same faces.
    """

    def __init__(self, strip: Strip, *, points: int = 0) -> None:
        self.strip, self.joints = strip, BentSolid.of(strip).joints
        # of a laminate the backing, whose width follows the stiffness
        self.flat, self.bent = FlatSolid.layers(strip)[-1], BentSolid.layers(strip)[-1]
        if points:
            sides = tuple(drawn_anew(side, points) for side in self.flat.outline.segments)
            outline = Path(sides, closed=True)
            self.flat = replace(self.flat, outline=outline)
            self.bent = BentSolid.wrapped(strip.rod, outline, self.flat.holes, heights=self.bent.heights)
        self.volume = self.flat.volume

    @property
    def long_sides(self) -> list[np.ndarray]:
        """Points in the middle of every piece of the long sides, on both faces of the bent body."""
        maps = self.bent.maps[1:-1]
        ends = np.array([m.knots[-1] for m in maps])
        edges = np.array([0.0, *ends])
        found = []
        for segment in self.flat.outline.segments:
            if not isinstance(segment, Spline):
                continue
            low, high = sorted((segment.start[0], segment.end[0]))
            stops = [low, *(x for x in edges if low + 1e-6 < x < high - 1e-6), high]
            for a, b in pairwise(stops):
                u = ((a + b) / 2 - segment.start[0]) / (segment.end[0] - segment.start[0])
                point = segment.at(float(u))
                bent = maps[min(int(np.searchsorted(ends, point[0])), len(maps) - 1)]
                found += list(bent.points(point[None], self.bent.heights)[0])
        return found

    @property
    def tip(self) -> np.ndarray:
        """The middle of the face that closes the strip at its end."""
        frame = self.joints["end"]
        length = self.strip.ends[1].length
        return frame.point((length, 0.0, (self.bent.heights[0] + self.bent.heights[1]) / 2))

    @property
    def middle(self) -> tuple[np.ndarray, np.ndarray]:
        """The centre line half way along, and its tangent."""
        at = self.strip.rod.curve.at(np.array([self.strip.rod.length / 2]))
        return np.append(at.position[0], 0.0), np.array([np.cos(at.angle[0]), np.sin(at.angle[0]), 0.0])


def drawn_anew(segment: Segment, points: int) -> Segment:
    """A long side as one would draw it: a spline through some of its points."""
    if not isinstance(segment, Spline):
        return segment
    x, y = segment.at(np.linspace(0.0, 1.0, points)).T
    backward = bool(x[0] > x[-1])
    if backward:
        x, y = x[::-1], y[::-1]
    profile = Profile.interpolate(x - x[0], y)
    drawn = graph(profile.knots + x[0], profile.coefficients, profile.degree)
    return drawn.reversed() if backward else drawn


Answer = tuple[bool, float]
"""Is it valid, and how much volume it has (area of a face), mm3."""


class Build123d:
    """Operations as users of build123d call them."""

    def __init__(self, bodies: Bodies) -> None:
        import build123d as bd

        from elastica_cad.kernel import occt

        self.bd, self.bodies = bd, bodies
        self.bent = bd.Solid(occt.make_solid(bodies.bent))
        self.flat = bd.Solid(occt.make_solid(bodies.flat))
        self.face = bd.Face(occt.make_face(bodies.flat.outline))

    def run(self, name: str) -> Answer:
        bd, bent, flat = self.bd, self.bent, self.flat
        top = flat.faces().sort_by(bd.Axis.Z)[-1].outer_wire().edges()
        at, along = self.bodies.middle
        plane = bd.Plane(origin=tuple(at), z_dir=tuple(along))
        box = bd.Solid.make_box(6, 4, 100, bd.Plane(tuple(at - [3, 2, 50])))
        makers: Mapping[str, Callable[[], Any]] = {
            "volume": lambda: bent,
            "fillet": lambda: bent.fillet(SMALL, self.near(self.bodies.long_sides)),
            "chamfer": lambda: bent.chamfer(SMALL, None, self.near(self.bodies.long_sides)),
            "fillet flat": lambda: flat.fillet(SMALL, top),
            "chamfer flat": lambda: flat.chamfer(SMALL, None, top),
            "offset": lambda: bd.offset(self.face, OFFSET),
            "inset": lambda: bd.offset(self.face, -OFFSET),
            "shell": lambda: bd.offset(bent, -WALL, openings=self.end(bent, self.bodies.tip)),
            "shell flat": lambda: bd.offset(flat, -WALL, openings=flat.faces().sort_by(bd.Axis.X)[-1]),
            "boolean": lambda: bent - box,
            "mirror": lambda: bent.mirror(bd.Plane.YZ),
            "split": lambda: bd.Part(bd.Compound(flatten_run(bent.split(plane, bd.Keep.BOTH))).wrapped),
        }
        if name in makers:
            made = makers[name]()
            valid = made.is_valid() if callable(made.is_valid) else made.is_valid
            size = made.area if name in ("offset", "inset") else made.volume
            return bool(valid), float(size)
        return occt_answer(name, bent.wrapped)

    def near(self, points: Sequence[np.ndarray]) -> list[Any]:
        edges = self.bent.edges()
        return [min(edges, key=lambda e: e.distance_to(self.bd.Vertex(*p))) for p in points]

    def end(self, body: Any, tip: np.ndarray) -> Any:
        return min(body.faces(), key=lambda f: (f.center() - self.bd.Vector(*tip)).length)


class CadQuery:
    """Operations as users of CadQuery call them."""

    def __init__(self, bodies: Bodies) -> None:
        import cadquery as cq

        from elastica_cad.kernel import occt

        self.cq, self.bodies = cq, bodies
        self.bent = cq.Solid(occt.make_solid(bodies.bent))
        self.flat = cq.Solid(occt.make_solid(bodies.flat))
        self.face = cq.Face(occt.make_face(bodies.flat.outline))

    def run(self, name: str) -> Answer:
        cq, bent, flat = self.cq, self.bent, self.flat
        top = max(flat.Faces(), key=lambda f: f.Center().z).outerWire().Edges()
        at, along = self.bodies.middle
        half = cq.Face.makePlane(900, 900, tuple(at), tuple(along))
        box = cq.Solid.makeBox(6, 4, 100, cq.Vector(*(at - [3, 2, 50])))
        outer = self.face.outerWire()

        def filled(distance: float) -> Any:
            return cq.Face.makeFromWires(max(outer.offset2D(distance), key=lambda w: w.Length()))

        makers: Mapping[str, Callable[[], Any]] = {
            "volume": lambda: bent,
            "fillet": lambda: bent.fillet(SMALL, self.near(self.bodies.long_sides)),
            "chamfer": lambda: bent.chamfer(SMALL, None, self.near(self.bodies.long_sides)),
            "fillet flat": lambda: flat.fillet(SMALL, top),
            "chamfer flat": lambda: flat.chamfer(SMALL, None, top),
            "offset": lambda: filled(OFFSET),
            "inset": lambda: filled(-OFFSET),
            "shell": lambda: bent.hollow([self.end(bent, self.bodies.tip)], -WALL),
            "shell flat": lambda: flat.hollow([max(flat.Faces(), key=lambda f: f.Center().x)], -WALL),
            "boolean": lambda: bent.cut(box),
            "mirror": lambda: bent.mirror("YZ"),
            "split": lambda: bent.split(half),
        }
        if name in makers:
            made = makers[name]()
            size = made.Area() if name in ("offset", "inset") else made.Volume()
            return bool(made.isValid()), float(size)
        return occt_answer(name, bent.wrapped)

    def near(self, points: Sequence[np.ndarray]) -> list[Any]:
        edges = self.bent.Edges()
        places = [self.cq.Vertex.makeVertex(*map(float, p)) for p in points]
        return [min(edges, key=lambda e: e.distance(place)) for place in places]

    def end(self, body: Any, tip: np.ndarray) -> Any:
        return min(body.Faces(), key=lambda f: (f.Center() - self.cq.Vector(*tip)).Length)


class FreeCAD:
    """Operations as users of FreeCAD's Part call them."""

    def __init__(self, bodies: Bodies) -> None:
        import FreeCAD as App
        import Part
        from freecad.elastica_wb.curves import part_shapes as shapes

        self.app, self.part, self.bodies = App, Part, bodies
        self.bent = shapes.make_solid(bodies.bent)
        self.flat = shapes.make_solid(bodies.flat)
        self.face = shapes.make_face(bodies.flat.outline)

    def run(self, name: str) -> Answer:
        bent, flat, vector = self.bent, self.flat, self.app.Vector
        at, along = self.bodies.middle
        top = max(flat.Faces, key=lambda f: f.CenterOfMass.z)
        farthest = max(flat.Faces, key=lambda f: f.CenterOfMass.x)
        edges = [e for e in flat.Edges if any(e.isSame(o) for o in top.OuterWire.Edges)]
        box = self.part.makeBox(6, 4, 100, vector(*(at - [3, 2, 50])))
        plane = self.part.Plane(vector(*at), vector(*along))

        def halves() -> Any:
            pieces, _ = bent.generalFuse([plane.toShape(-450, 450, -450, 450)], 1e-6)
            return self.part.makeCompound(pieces.Solids)

        makers: Mapping[str, Callable[[], Any]] = {
            "volume": lambda: bent,
            "fillet": lambda: bent.makeFillet(SMALL, self.near(self.bodies.long_sides)),
            "chamfer": lambda: bent.makeChamfer(SMALL, self.near(self.bodies.long_sides)),
            "fillet flat": lambda: flat.makeFillet(SMALL, edges),
            "chamfer flat": lambda: flat.makeChamfer(SMALL, edges),
            "offset": lambda: self.face.makeOffset2D(OFFSET),
            "inset": lambda: self.face.makeOffset2D(-OFFSET),
            "shell": lambda: bent.makeThickness([self.end(bent, self.bodies.tip)], -WALL, 1e-3),
            "shell flat": lambda: flat.makeThickness([farthest], -WALL, 1e-3),
            "boolean": lambda: bent.cut(box),
            "mirror": lambda: bent.mirror(vector(0, 0, 0), vector(1, 0, 0)),
            "split": halves,
        }
        if name in makers:
            made = makers[name]()
            size = made.Area if name in ("offset", "inset") else made.Volume
            return bool(made.isValid()), float(size)
        if name == "BOP":
            bent.check(True)
            return True, float(bent.Volume)
        if name == "STEP":
            path = scratch("freecad.step")
            bent.exportStep(path)
            back = self.part.read(path)
            return bool(back.isValid()), float(back.Volume)
        path = scratch("freecad.brep")
        bent.exportBrep(path)
        return meshed(path), float(bent.Volume)

    def near(self, points: Sequence[np.ndarray]) -> list[Any]:
        places = [self.part.Vertex(*map(float, p)) for p in points]
        return [min(self.bent.Edges, key=lambda e: e.distToShape(place)[0]) for place in places]

    def end(self, body: Any, tip: np.ndarray) -> Any:
        return min(body.Faces, key=lambda f: (f.CenterOfMass - self.app.Vector(*tip)).Length)


def flatten_run(shapes: Any) -> list[Any]:
    """All shapes of nested lists."""
    return [one for item in shapes for one in (flatten_run(item) if isinstance(item, list) else [item])]


def scratch(name: str) -> str:
    """A place for a file that is read at once."""
    return str(File(tempfile.gettempdir()) / f"elastica-{os.getpid()}-{name}")


KERNELS: Mapping[str, type] = {"build123d": Build123d, "cadquery": CadQuery, "freecad": FreeCAD}


def kernel_named(name: str) -> Any:
    """The class that runs the operations of a kernel."""
    return KERNELS[name]


def occt_answer(name: str, shape: Any) -> Answer:
    """What build123d and CadQuery share: mesh, STEP round trip, the check before boolean operations."""
    from elastica_cad.kernel.step_files import NamedShape, read_step_shape, step_bytes

    if name == "BOP":
        return not faulty(shape), volume(shape)
    if name == "STEP":
        path = File(scratch("strip.step"))
        path.write_bytes(step_bytes([NamedShape("strip", shape)], name="strip"))
        back = read_step_shape(path)
        from OCP.BRepCheck import BRepCheck_Analyzer

        return bool(BRepCheck_Analyzer(back).IsValid()), volume(back)
    from OCP.BRepTools import BRepTools

    path = File(scratch("strip.brep"))
    BRepTools.Write_s(shape, str(path))
    return meshed(str(path)), volume(shape)


def volume(shape: Any) -> float:
    """As the kernel's programs show it."""
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    sums = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, sums)
    return float(sums.Mass())


def faulty(shape: Any) -> bool:
    """As "Check geometry" of FreeCAD asks it."""
    from OCP.BOPAlgo import BOPAlgo_ArgumentAnalyzer

    analyzer = BOPAlgo_ArgumentAnalyzer()
    analyzer.SetShape1(shape)
    for mode in ("ArgumentTypeMode", "SelfInterMode", "SmallEdgeMode", "RebuildFaceMode", "ContinuityMode",
                 "TangentMode", "MergeVertexMode", "MergeEdgeMode", "CurveOnSurfaceMode"):  # fmt: skip
        setattr(analyzer, mode, True)
    analyzer.Perform()
    return bool(analyzer.HasFaulty())


def meshed(path: str) -> bool:
    """Tetrahedra by gmsh: True where one of a few usual settings gives none worse than `SICN`."""
    worst = 0.0
    for size, algorithm, optimized in MESHES:
        worst = max(worst, worst_element(path, size, algorithm, optimized))
        if worst >= SICN:
            return True
    raise RuntimeError(f"worst element {worst:.2f}")


def worst_element(path: str, size: float, algorithm: int, optimized: bool) -> float:
    """The smallest signed inverse condition number (1 for a regular tetrahedron) of a mesh."""
    import gmsh

    gmsh.initialize(interruptible=False)
    try:
        for option, value in (
            ("General.Terminal", 0),
            ("Mesh.MeshSizeMax", size),
            ("Mesh.MeshSizeMin", size),
            ("Mesh.Algorithm3D", algorithm),
            ("Mesh.Optimize", 1),
            ("Mesh.OptimizeNetgen", 1),
        ):
            gmsh.option.setNumber(option, value)
        gmsh.model.occ.importShapes(path)
        gmsh.model.occ.synchronize()
        gmsh.model.mesh.generate(3)
        for method in ("", "Relocate3D", "Netgen") if optimized else ():
            gmsh.model.mesh.optimize(method)
        _, tags, _ = gmsh.model.mesh.getElements(3)
        rows = [gmsh.model.mesh.getElementQualities(row, "minSICN") for row in tags if len(row)]
        return float(min((np.min(row) for row in rows), default=0.0))
    finally:
        gmsh.finalize()
