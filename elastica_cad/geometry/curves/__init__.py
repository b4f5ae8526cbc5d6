"""Plane NURBS curves and what is asked of them: derivatives, arc length, curvature zeros, crossings, maps."""
