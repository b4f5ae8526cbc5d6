"""Refusals as tables of calls and messages."""

from collections.abc import Callable, Sequence

import pytest

from elastica_cad import InputError


def refusal_test(
    calls: Sequence[tuple[Callable[[], object], str]], kind: type[Exception] = InputError
) -> Callable[..., None]:
    """Return a test of calls, each of which raises `kind` with a message that matches the pattern beside it."""

    @pytest.mark.parametrize(("call", "message"), calls)
    def test(call: Callable[[], object], message: str) -> None:
        with pytest.raises(kind, match=message):
            call()

    return test
