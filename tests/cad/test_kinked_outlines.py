"""Bodies of strips whose width kinks or steps: kernels refuse much on edges with a kink inside them."""

import pytest

MEANT = (
    "fillet", "chamfer", "fillet flat", "offset", "inset", "boolean", "mirror", "split", "STEP", "BOP",
)  # fmt: skip
CURVES = ("drawn through three points", "two arcs")


@pytest.fixture(scope="module", params=CURVES)
def bodies(request, campaign):
    bank, operations = campaign
    return operations.Bodies(bank.made(request.param, "plain"))


@pytest.fixture(scope="module")
def campaign(request):
    """The bank of strips and the operations on their bodies."""
    import importlib.util
    import sys
    from pathlib import Path

    found = []
    for name in ("bank", "operations"):
        path = Path(__file__).resolve().parents[1] / "campaign" / f"{name}.py"
        spec = importlib.util.spec_from_file_location(f"campaign_{name}", path)
        module = importlib.util.module_from_spec(spec)
        sys.modules[spec.name] = module
        spec.loader.exec_module(module)
        found.append(module)
    return found


@pytest.mark.campaign
@pytest.mark.build123d
def test_build123d(bodies, campaign):
    runner = campaign[1].Build123d(bodies)
    for name in MEANT:
        valid, size = runner.run(name)
        assert valid, name
        assert size > 0, name


@pytest.mark.campaign
@pytest.mark.cadquery
def test_cadquery(bodies, campaign):
    runner = campaign[1].CadQuery(bodies)
    for name in MEANT:
        valid, size = runner.run(name)
        assert valid, name
        assert size > 0, name


@pytest.mark.parametrize(
    "kernel",
    [
        pytest.param("Build123d", marks=pytest.mark.build123d),
        pytest.param("CadQuery", marks=pytest.mark.cadquery),
    ],
)
def test_a_fillet_between_a_slot_and_a_step_of_width(kernel, campaign):
    """Along an edge of one span both kernels gave up."""
    bank, operations = campaign
    runner = getattr(operations, kernel)(operations.Bodies(bank.made("two arcs", "slotted")))
    valid, size = runner.run("fillet")
    assert valid
    assert 0 < size < runner.bodies.volume


def test_volumes(bodies, campaign):
    """As CAD programs show them, by plain integration; by the adaptive one to rounding."""
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    from elastica_cad.kernel import occt

    body = occt.make_solid(bodies.bent)
    assert campaign[1].volume(body) == pytest.approx(bodies.volume, rel=1e-6)
    sums = GProp_GProps()
    BRepGProp.VolumeProperties_s(body, sums, 1e-9)
    assert sums.Mass() == pytest.approx(bodies.volume, rel=1e-9)


def test_the_laser_goes_round_in_one_go(bodies):
    """The drawing keeps one spline a side and one closed loop."""
    from elastica_cad.geometry import Spline

    drawing = bodies.strip.drawing()
    (cut,) = [layered.path for layered in drawing.paths if layered.layer == "CUT_OUTER"]
    assert cut.closed
    assert sum(isinstance(segment, Spline) for segment in cut.segments) == 2
