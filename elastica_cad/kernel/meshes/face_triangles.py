"""The triangles of a body, face by face, as arrays."""

from collections.abc import Iterator

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.kernel.occt import sub_shapes
from elastica_cad.kernel.ocp_import import Shape, kernel


def face_triangles(body: Shape, *, chord: float, turn: float) -> Iterator[tuple[FloatArray, IntArray]]:
    """Of every face the points (n, 3) and the triangles (m, 3) of their numbers, anticlockwise from outside.

    Parameters
    ----------
    body : Shape
        One kind of mesh is kept with it: a second call with coarser values may find the finer one.
    chord : float
        How far triangles may leave the faces, mm.
    turn : float
        Largest turn from one triangle to the next along an edge, rad.
    """
    k = kernel()
    k.BRepMesh_IncrementalMesh(body, chord, False, turn)
    for face in map(k.as_face, sub_shapes(body, k.TopAbs_ShapeEnum.TopAbs_FACE)):
        place = k.TopLoc_Location()
        net = k.BRep_Tool.Triangulation_s(face, place)
        move = place.Transformation()
        nodes = (net.Node(i).Transformed(move) for i in range(1, net.NbNodes() + 1))
        corners = np.array([net.Triangle(i).Get() for i in range(1, net.NbTriangles() + 1)]) - 1
        if face.Orientation() == k.TopAbs_Orientation.TopAbs_REVERSED:
            corners = corners[:, ::-1]
        yield np.array([(p.X(), p.Y(), p.Z()) for p in nodes]), corners
