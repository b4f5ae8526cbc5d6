# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Tests of the workbench, run by FreeCAD's Test workbench or by `freecadcmd -t freecad.elastica_wb.tests`."""

import tempfile
import unittest
from pathlib import Path

import FreeCAD as App
import Part
from freecad.elastica_wb import make_strip

ARCH = ((0, 0), (30, 60), (70, 80), (120, 60), (150, 0))
SNAKE = ((0, 0), (40, 60), (80, -60), (120, 20), (160, 30), (180, 0))
# largest error of a length, mm
SLACK = 1e-9
# relative error of volumes, because OpenCASCADE integrates splines inexactly
VOLUME = 1e-3


class ElasticaTest(unittest.TestCase):
    """Tests that make strips and their files from a drawn spline."""

    def setUp(self) -> None:
        """Open an empty document."""
        self.document = App.newDocument("ElasticaTest")

    def tearDown(self) -> None:
        """Close the document."""
        App.closeDocument(self.document.Name)

    def draw(self, points: tuple[tuple[float, float], ...]) -> object:
        """Make a sketch with a spline of degree 4."""
        curve, spans = Part.BSplineCurve(), len(points) - 4
        knots = [i / spans for i in range(spans + 1)]
        counts = [5, *[1] * (spans - 1), 5]
        poles = [App.Vector(*point, 0) for point in points]
        curve.buildFromPolesMultsKnots(poles, counts, knots, False, 4)
        sketch = self.document.addObject("Sketcher::SketchObject", "Sketch")
        sketch.addGeometry(curve, False)
        self.document.recompute()
        return sketch

    def test_a_strip_and_its_flat_part(self) -> None:
        """Check that the bent strip and the flat part have the same volume."""
        strip = make_strip(self.draw(ARCH), MaxWidth="24 mm")
        flat = self.document.getObject("Flat")
        assert strip.State == ["Up-to-date"], strip.Verdict
        assert strip.Shape.isValid()
        assert abs(strip.MaxWidth.Value - 24.0) < SLACK
        assert abs(strip.Shape.Volume / flat.Shape.Volume - 1) < VOLUME

    def test_a_curve_that_no_strip_takes(self) -> None:
        """Check that a refused curve has reasons, and that its nearest curve can be made."""
        strip = make_strip(self.draw(SNAKE), flat_part=False)
        assert "Invalid" in strip.State
        assert "cannot" in strip.Verdict
        assert strip.Reasons
        strip.Follow, strip.RatioLimit, strip.StrainLimit = "Nearest", 6, 5
        self.document.recompute()
        assert strip.State == ["Up-to-date"], strip.Verdict

    def test_unknown_properties(self) -> None:
        """Check that the document is unchanged after an error about a misspelt property."""
        sketch = self.draw(ARCH)
        message = ""
        try:
            make_strip(sketch, MaxWidht=3)
        except AttributeError as error:
            message = str(error)
        assert "MaxWidht" in message
        assert [obj.Name for obj in self.document.Objects] == [sketch.Name]

    def test_cutting_files(self) -> None:
        """Check that DXF (with and without ezdxf), STEP, SVG and a cut list are written."""
        from freecad.elastica_wb.cutting_files import write_cutting_files

        strip = make_strip(self.draw(ARCH))
        with tempfile.TemporaryDirectory() as folder:
            files = write_cutting_files([strip], folder, kinds=("dxf", "svg", "step", "csv"))
            assert [file.suffix for file in files] == [".dxf", ".svg", ".step", ".csv"]
            assert all(Path(file).stat().st_size for file in files)
