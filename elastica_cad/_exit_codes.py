"""Exit codes of commands that were ended from outside, as shells have them: 128 and the number of the signal."""

INTERRUPTED = 130
"""After Ctrl-C."""

OUTPUT_CLOSED = 141
"""After the reader of the output has ended (SIGPIPE)."""
