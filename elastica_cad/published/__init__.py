"""The routes of the paper's own code, for comparisons: nothing else imports them."""

from elastica_cad._exports import exports

__getattr__, __dir__, __all__ = exports(__file__, __name__)
