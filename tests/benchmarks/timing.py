"""How long something takes, for ratios in one run."""

from time import perf_counter


def seconds(function, repeats=9):
    """The least of several times, s."""
    spent = []
    for _ in range(repeats):
        start = perf_counter()
        function()
        spent.append(perf_counter() - start)
    return min(spent)
