"""Which lines run when a changed place is used: its statement, or those that use the constant that it gives."""

import ast
from collections.abc import Iterator
from pathlib import Path

Lines = list[tuple[str, int, int]]
"""File below the root, first and last line."""


def lines_of(root: Path, file: Path, tree: ast.Module, node: ast.AST) -> Lines:
    """Where a node inside a function runs, or what uses what a node outside of all functions defines."""
    inside = [one for one in _bodies(tree) if any(node is below for below in ast.walk(one))]
    if inside:
        statement = inside[-1]
        body = getattr(statement, "body", None)
        last = body[0].lineno - 1 if body else statement.end_lineno or statement.lineno
        return [(str(file), statement.lineno, max(last, statement.lineno))]
    names = _defined(tree, node)
    found = [
        (str(path.relative_to(root)), one.lineno, one.end_lineno or one.lineno)
        for path in sorted((root / "elastica_cad").rglob("*.py"))
        if names and any(name in (text := path.read_text()) for name in names)
        for one in _users(ast.parse(text), names, None if path == root / file else file.stem)
    ]
    return found or [(str(file), one.lineno, one.end_lineno or one.lineno) for one in _bodies(tree)]


def _bodies(tree: ast.Module) -> Iterator[ast.stmt]:
    """Statements inside of functions, the outer ones first."""
    inner = (ast.FunctionDef, ast.AsyncFunctionDef)
    for function in (one for one in ast.walk(tree) if isinstance(one, inner)):
        for part in function.body:
            yield from (one for one in ast.walk(part) if isinstance(one, ast.stmt))


def _users(tree: ast.Module, names: set[str], home: str | None) -> Iterator[ast.stmt]:
    """Simple statements inside of functions that read one of the names, which come from the module home if any."""
    if home is not None:
        names = names & {
            one.name
            for part in ast.walk(tree)
            if isinstance(part, ast.ImportFrom) and (part.module or "").endswith(home)
            for one in part.names
        }
    for statement in _bodies(tree):
        if not hasattr(statement, "body") and any(
            isinstance(one, ast.Name) and one.id in names for one in ast.walk(statement)
        ):
            yield statement


def _defined(tree: ast.Module, node: ast.AST) -> set[str]:
    """Names of the constants of the module in whose statement the node stands."""
    for statement in tree.body:
        if isinstance(statement, ast.Assign | ast.AnnAssign) and any(
            node is one for one in ast.walk(statement)
        ):
            targets = statement.targets if isinstance(statement, ast.Assign) else [statement.target]
            return {one.id for target in targets for one in ast.walk(target) if isinstance(one, ast.Name)}
    return set()
