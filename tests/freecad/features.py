"""Features of a document as its user makes and changes them; the document is computed again."""

from collections.abc import Callable
from typing import Any


def new(create: Callable[..., Any], document: Any, *arguments: Any, **options: Any) -> Any:
    """Create a feature."""
    feature = create(document, *arguments, **options)
    document.recompute()
    return feature


def change(feature: Any, **properties: Any) -> None:
    """Set properties of a feature, in their order."""
    for name, value in properties.items():
        setattr(feature, name, value)
    feature.Document.recompute()
