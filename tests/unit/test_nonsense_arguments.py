"""Arguments that mean nothing are refused in a sentence, where a foreign error or an endless search was met."""

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import InputError
from elastica_cad.design import Cutting
from elastica_cad.form_finding import smooth_curve
from elastica_cad.mechanics import bend_path
from elastica_cad.model import BasePlate, PlateOptions, Rib
from elastica_cad.strip import ENGRAVE, Measuring, Text

ARCH = ec.PlaneCurve.spline([(0, 0), (30, 14), (70, 14), (100, 0)], degree=3)
PROFILE = ec.meridian_through([(70, 0), (85, 16), (125, 55), (90, 115), (75, 140)])
SQUARE = ec.Path.rectangle(60.0, 40.0)
PLATE = BasePlate(ec.Sheet.named("mdf-3"), ec.Frame(), SQUARE)
RIB = Rib("rib-1", ec.Sheet.named("mdf-3"), ec.Frame(), SQUARE, Text((0.0, 0.0), "rib-1", 4.0, 0.0, ENGRAVE))


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: ARCH.at(np.zeros((0, 2))), "arc lengths are an array of 2 dimensions"),
        (lambda: ARCH.zeros_along(None, 1.0), "Give a callable"),
        (lambda: ARCH.zeros_along(ec.ElasticaError, 1.0), "values of a function cannot be .*: give numbers"),
        (lambda: ARCH.zeros_along(len, 1.0), "a value for each"),
        (lambda: bend_path("x", np.zeros((0, 2))), "what is bent is a str. Pass a Rod"),
        (lambda: ARCH.zeros_along(np.sin, -1e-300), "a positive size"),
        (lambda: ARCH.zeros_along(np.sin, 1.0, [0.5]), "a break cannot be .*: give two finite numbers"),
        (lambda: Measuring.of(0), "Pass a Strip"),
        (lambda: smooth_curve(ARCH, natural_curvature="pom-1"), "natural_curvature is"),
        (lambda: ec.two_state_rod(ARCH, ARCH, limits=np.zeros((0, 2))), "limits is a ndarray"),
        (lambda: ec.matched_pair(ARCH, ARCH, keep=np.zeros((0, 2))), "`keep` is array"),
        (lambda: PLATE.checked("x"), "options is a str. Pass a PlateOptions"),
        (lambda: RIB.checked([None]), "options is a list. Pass a PlateOptions"),
        (lambda: PlateOptions(ignore_limits=np.ones(3)), "ignore_limits is array"),
        (lambda: ec.revolve(PROFILE, 20, sheet="pom-1", ignore_limits=np.ones(3)), "ignore_limits is array"),
        (lambda: Cutting().file_name("arch", np.zeros(0)), "part of a file name is a ndarray"),
        (lambda: Cutting().file_name(np.zeros(2), "dxf"), "part of a file name is a ndarray"),
        (lambda: ec.two_state_rod(ARCH, ARCH, free=np.zeros((2, 2))), "free is array"),
    ],
)
def test_nonsense_is_refused_in_a_sentence(call, sentence):
    with pytest.raises(InputError, match=sentence):
        call()
