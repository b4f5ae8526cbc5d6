"""Drawings as DXF and SVG files: layers, styles of curves."""
