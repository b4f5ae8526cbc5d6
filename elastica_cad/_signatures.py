"""Signatures of public functions and records with plain types, for `help` and notebooks."""

import inspect
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin


class PlainText(str):
    """Text that is displayed without quotes in a signature."""

    __slots__ = ()
    __repr__ = str.__str__


class _RecordSignature:
    """Signature of a record, computed on access, because each subclass has its own."""

    def __get__(self, _: object, record: Any) -> inspect.Signature:
        initializer = inspect.signature(record.__init__)
        parameters = [*initializer.parameters.values()][1:]
        return _plain(initializer.replace(parameters=parameters, return_annotation=inspect.Signature.empty))


def simplify_signature(value: Any) -> None:
    """Simplify the displayed signature of a function, or of a class of this package and its public methods."""
    if inspect.isfunction(value) and "__signature__" not in vars(value):
        value.__signature__ = plain_signature(value)  # type: ignore[attr-defined]  # read by inspect
    if not inspect.isclass(value) or "__signature__" in vars(value):
        return
    # PySide2 gives every class a __signature__ that cannot be set, and Enum has a special signature
    if inspect.isfunction(value.__init__) and type(value) is type and not hasattr(type, "__signature__"):
        value.__signature__ = _RecordSignature()  # type: ignore[attr-defined]  # read by inspect
    for base in value.__mro__:
        if base.__module__.startswith(__package__):
            for name, method in vars(base).items():
                if not name.startswith("_"):
                    simplify_signature(getattr(method, "__func__", method))


def plain_signature(function: Any) -> inspect.Signature:
    """Return the signature of a function with plain types.

    Examples
    --------
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> def strip(curve: PlaneCurve, width: Annotated[float | None, "mm"] = None) -> "PlaneCurve": ...
    >>> plain_signature(strip)
    <Signature (curve: PlaneCurve, width: float | None = None) -> PlaneCurve>
    """
    return _plain(inspect.signature(function))


def _plain(signature: inspect.Signature) -> inspect.Signature:
    parameters = [
        parameter.replace(annotation=_plain_type(parameter.annotation))
        for parameter in signature.parameters.values()
    ]
    return signature.replace(
        parameters=parameters, return_annotation=_plain_type(signature.return_annotation)
    )


def _plain_type(hint: Any) -> Any:
    """Return a type annotation as text, without names of modules and `Annotated`; in a union, None is last."""
    if hint is inspect.Signature.empty:
        return hint
    kind, parts = get_origin(hint), get_args(hint)
    if isinstance(hint, str):
        text = hint
    elif kind is Annotated:
        text = _plain_type(parts[0])
    elif kind in (Union, UnionType):
        names = dict.fromkeys(map(_plain_type, _with_array_like(parts)))
        text = " | ".join(sorted(names, key="None".__eq__))
    elif kind is Literal:
        text = " | ".join(map(repr, parts))
    else:
        text = "None" if hint is NoneType else getattr(kind or hint, "__name__", None) or str(hint)
        if parts and text not in ("Callable", "ndarray"):
            text += f"[{', '.join('...' if part is ... else _plain_type(part) for part in parts)}]"
    return PlainText(text)


def _with_array_like(parts: tuple[Any, ...]) -> tuple[Any, ...]:
    if not any(getattr(part, "__module__", "").startswith("numpy._typing") for part in parts):
        return parts
    from numpy.typing import ArrayLike

    members = get_args(ArrayLike)
    return (*(part for part in parts if part not in members), "ArrayLike")
