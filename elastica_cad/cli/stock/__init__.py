"""Commands that begin with stock, not with a drawn curve."""
