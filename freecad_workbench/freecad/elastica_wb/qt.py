"""Qt as this FreeCAD has it: 0.20's PySide has no QtWidgets of its own."""

from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    from PySide2 import QtWidgets

__all__ = ["QtCore", "QtGui", "QtWidgets"]
