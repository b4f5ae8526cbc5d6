"""geometry"""

from elastica_cad.geometry.profile import Profile

__all__ = ["Profile"]
