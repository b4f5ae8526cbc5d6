"""Curves from files and to files: DXF, SVG, JSON, points, edges of CAD models."""
