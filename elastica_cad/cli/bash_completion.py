"""Completion of `--set KEY=VALUE` in bash, for which "=" ends a word."""

from typing import Any

from click.shell_completion import BashComplete, add_completion_class


class KeysAndValues(BashComplete):
    """As click has it, with the parts of KEY=VALUE put together again, and no space behind KEY=."""

    source_template = BashComplete.source_template.replace(
        "COMPREPLY+=($value)",
        "COMPREPLY+=($value)\n            [[ $value == *= ]] && compopt -o nospace",
    )
    there = ""
    """What bash holds for a word of its own before the one that it asks for."""

    def get_completion_args(self) -> tuple[list[str], str]:
        """The words before the last, and that."""
        args, last = super().get_completion_args()
        words = [""]
        for before, word in zip(["", *args], [*args, last], strict=True):
            if "=" in (before, word):
                words[-1] += word
            else:
                words.append(word)
        *args, last = words[1:]
        key, between, _ = last.partition("=")
        self.there = key + between if between and not key.startswith("-") else ""
        return args, last

    def format_completion(self, item: Any) -> str:
        """The part that bash puts in."""
        return f"{item.type},{item.value.removeprefix(self.there)}"


def install() -> None:
    """Let bash be answered in this way."""
    add_completion_class(KeysAndValues)
