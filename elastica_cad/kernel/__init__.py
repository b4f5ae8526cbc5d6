"""Conversion between this package's records and OpenCASCADE's shapes."""
