"""How long something takes, for ratios in one run."""

from time import perf_counter


def seconds(function, repeats=9, clock=perf_counter):
    """The least of several times, s."""
    spent = []
    for _ in range(repeats):
        start = clock()
        function()
        spent.append(clock() - start)
    return min(spent)
