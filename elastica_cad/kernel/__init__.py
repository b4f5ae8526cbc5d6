"""Conversion between records of this package and shapes of OpenCASCADE, in both directions."""
