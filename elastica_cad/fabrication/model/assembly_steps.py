"""How a model is put together: which strip next, where its ends go, what it locks into."""

from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass

from elastica_cad._values import several
from elastica_cad.fabrication.holders.base_plate import BasePlate
from elastica_cad.fabrication.holders.end_fixtures import EndFixture
from elastica_cad.fabrication.holders.placed_tab import tab_name
from elastica_cad.fabrication.holders.ring_plate import Ring
from elastica_cad.fabrication.model.assembly import HOLDERS, Holder, require_model, single_holders
from elastica_cad.fabrication.model.strip_model import Model
from elastica_cad.fabrication.strip.tabs import ENDS

FREE = "free"


@dataclass(frozen=True)
class AssemblyStep:
    """One strip to be put in.

    Attributes
    ----------
    number : int
        From 1.
    strip : str
        As it is engraved, with its place where several are called so.
    part : str
        The piece that is cut for it.
    ends : (str, str)
        What holds end 1 and end 2, by name, or "free".
    locks_into : tuple of str
        Strips that are there already and cross it in a slot.
    """

    number: int
    strip: str
    part: str
    ends: tuple[str, str]
    locks_into: tuple[str, ...] = ()


def list_assembly_steps(model: Model, holders: Iterable[Holder] = ()) -> tuple[AssemblyStep, ...]:
    """The strips in the order of the model, each with its places.

    Examples
    --------
    >>> from elastica_cad.fabrication.placed_strip import Placed
    >>> from elastica_cad.fabrication.strip_spec import make_strip
    >>> from elastica_cad.geometry.curves.plane_curve import PlaneCurve
    >>> from elastica_cad.mechanics.material.sheet import Sheet
    >>> bow = make_strip(PlaneCurve.arc((0, 0), 60, 3.1, 0.04), "birch-plywood-0.8", max_width=20, label="A")
    >>> model = Model([Placed(bow, (0, 0, 0), (1, 0, 0), (0, 0, 1))])
    >>> list_assembly_steps(model, [model.base_plate(Sheet.named("mdf-3"))])[0].ends
    ('slot A:1 of base', 'slot A:2 of base')
    """
    require_model(model)
    places = defaultdict[str, list[str]](list)
    for tab, place in _places([*model.plates, *several("holders", holders, Holder, HOLDERS)]):
        if place not in places[tab]:
            places[tab].append(place)
    parts = {member: part.name for part in model.parts for member in part.members}
    steps = []
    for i in range(len(model.placed)):
        first, last = (" and ".join(places[tab_name(model.name_of(i), end)]) or FREE for end in ENDS)
        before = [min(j.members) for j in model.joints if max(j.members) == i]
        mates = tuple(dict.fromkeys(model.single_name_of(k) for k in before))
        steps.append(AssemblyStep(i + 1, model.single_name_of(i), parts[i], (first, last), mates))
    return tuple(steps)


def _places(holders: Iterable[Holder]) -> Iterable[tuple[str, str]]:
    """Names of tabs with what holds them."""
    for holder in single_holders(holders):
        if isinstance(holder, BasePlate | Ring):
            yield from ((slot.name, f"slot {slot.name} of {holder.name}") for slot in holder.slots)
            if isinstance(holder, Ring):
                yield from ((name, f"on {holder.name}") for name in holder.seated)
        elif isinstance(holder, EndFixture):
            yield holder.tab.name, f"block {holder.number or holder.tab.name}"
