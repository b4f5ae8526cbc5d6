"""The built-in sheets: the figures of `sheets.toml`, with their sources and how far they spread."""

from collections.abc import Iterator, Mapping
from functools import lru_cache
from pathlib import Path
from types import MappingProxyType
from typing import Any

_WORDS = ("kind", "grain", "poisson_ratio")  # keys that are fields of `Sheet` as they stand
_LIMITS = ("least_width_mm", "least_ligament_mm", "least_bridge_mm")

# key in the file -> field of `Sheet`, what its source is called
_FIGURES = {
    "thickness_mm": ("thickness", "thickness"),
    "youngs_modulus_MPa": ("youngs_modulus", "E"),
    "density_kg_m3": ("density", "density"),
    "max_strain": ("max_strain", "strain"),
    "kerf_mm": ("kerf", "kerf"),
}


@lru_cache(maxsize=1)
def built_in_figures() -> Mapping[str, Mapping[str, Any]]:
    """Fields of `Sheet` but for its name, by name, as they stand in the file.

    Examples
    --------
    >>> built_in_figures()["pom-0.5"]["youngs_modulus_range"]
    (2500.0, 3000.0)
    """
    import tomllib

    text = Path(__file__).with_name("sheets.toml").read_text(encoding="utf-8")
    return MappingProxyType(
        {
            name: fields
            for table, entry in tomllib.loads(text).items()
            for name, fields in _sheets(table, entry)
        }
    )


def _sheets(table: str, entry: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Name and fields of one sheet for each thickness."""
    thicknesses = entry["thickness_mm"]["value"]
    for i, thickness in enumerate(thicknesses if isinstance(thicknesses, list) else [thicknesses]):
        fields: dict[str, Any] = {key: entry[key] for key in _WORDS if key in entry}
        fields |= {key.removesuffix("_mm"): entry[key] for key in _LIMITS if key in entry}
        if "stock_mm" in entry:
            fields["stock"] = tuple(entry["stock_mm"])
        sources = [entry["note"]] if "note" in entry else []
        for key, (field, label) in _FIGURES.items():
            if key not in entry:
                sources.append(f"{label} not published: measure it on a coupon")
                continue
            figure = entry[key]
            value = figure["value"][i] if isinstance(figure["value"], list) else figure["value"]
            fields[field] = value
            if "range" in figure:
                fields[f"{field}_range"] = tuple(figure["range"])
            elif "lowest" in figure:
                fields[f"{field}_range"] = (figure["lowest"], value)
            if "source" in figure:
                sources.append(f"{label}: {figure['source']}")
        yield entry.get("name", f"{table}-{thickness:g}"), {**fields, "source": "; ".join(sources)}
