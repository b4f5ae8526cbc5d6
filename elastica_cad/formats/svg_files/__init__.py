"""Curves drawn in SVG: path data, groups and clones, as edges in mm."""
