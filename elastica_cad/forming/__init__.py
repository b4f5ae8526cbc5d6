"""What a wish becomes: limits, what to keep, and the nearest rod that can be made."""

from elastica_cad.forming.binding import Binding
from elastica_cad.forming.limits import Box, HalfPlane, Keep, Limits
from elastica_cad.forming.many import nearest_rods
from elastica_cad.forming.nearest import NearestRod, Status, nearest_rod

__all__ = [
    "Binding",
    "Box",
    "HalfPlane",
    "Keep",
    "Limits",
    "NearestRod",
    "Status",
    "nearest_rod",
    "nearest_rods",
]
