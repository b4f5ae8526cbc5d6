"""FreeCAD workbench of elastica_cad: draw a spline, see whether it can be bent, get the strip."""
