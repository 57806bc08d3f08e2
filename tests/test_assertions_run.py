"""Every assertion of the tests runs: none stands in a loop over what may be empty.

`worlds.filled.filled` makes a loop certain to run, and so does an assertion before it about what it goes over.
"""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

TESTS = Path(__file__).parent
FILES = sorted(TESTS.rglob("test_*.py"))

_KEEP_LENGTH = {"enumerate", "sorted", "reversed", "list", "tuple", "set", "zip", "product", "pairwise", "permutations"}
_VIEWS = {"items", "values", "keys", "splitlines", "tolist", "permutation"}


class _Scope:
    """What is known of names in one function: to what they are bound, and which expressions have been asserted."""

    def __init__(self, module: ast.Module, function: ast.FunctionDef) -> None:
        self._bound: dict[str, ast.expr] = {}
        for node in (*module.body, *ast.walk(function)):
            if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name):
                self._bound[node.targets[0].id] = node.value
            elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name) and node.value is not None:
                self._bound[node.target.id] = node.value
        self._asserted = [(n.lineno, _parts(n.test)) for n in ast.walk(function) if isinstance(n, ast.Assert)]

    def is_filled(self, iterable: ast.expr, line: int) -> bool:
        """Return whether an expression, used as an iterable in a line, holds at least one thing for certain."""
        if any(asserted < line and ast.dump(iterable) in parts for asserted, parts in self._asserted):
            return True
        match iterable:
            case ast.Tuple(elts=elements) | ast.List(elts=elements) | ast.Set(elts=elements):
                return any(not isinstance(e, ast.Starred) or self.is_filled(e.value, line) for e in elements)
            case ast.Dict(values=values):
                return bool(values)
            case ast.Constant(value=str(text)):
                return bool(text)
            case ast.BinOp(op=ast.Mult() | ast.Add(), left=left, right=right):
                return self.is_filled(left, line) or self.is_filled(right, line)
            case ast.ListComp(generators=parts) | ast.GeneratorExp(generators=parts) | ast.SetComp(generators=parts):
                return all(not part.ifs and self.is_filled(part.iter, line) for part in parts)
            case ast.DictComp(generators=parts):
                return all(not part.ifs and self.is_filled(part.iter, line) for part in parts)
            case ast.Call(func=ast.Name(id="filled")):
                return True
            case ast.Call(func=ast.Name(id="range"), args=arguments):
                return all(isinstance(argument, ast.Constant) or _is_constant(argument) for argument in arguments)
            case ast.Call(func=ast.Name(id=name), args=arguments) if name in _KEEP_LENGTH:
                return all(self.is_filled(argument, line) for argument in arguments if not _is_number(argument))
            case ast.Call(func=ast.Attribute(attr="linspace" | "arange")):
                return True
            case ast.Call(func=ast.Attribute(attr="array" | "radians"), args=[argument]):
                return self.is_filled(argument, line)
            case ast.Call(func=ast.Attribute(value=value, attr=attribute)) if attribute in _VIEWS:
                return self.is_filled(value, line)
            case ast.Name(id=name):
                bound = self._bound.get(name)
                return name.isupper() or name[0].isupper() or (bound is not None and self.is_filled(bound, line))
            case ast.Attribute(attr=name):
                return name.isupper()
        return False


def _parts(expression: ast.expr) -> set[str]:
    """Return what an assertion speaks of, as text: each of its names, attributes and calls."""
    return {ast.dump(n) for n in ast.walk(expression) if isinstance(n, ast.Name | ast.Attribute | ast.Call)}


def _is_number(expression: ast.expr) -> bool:
    return isinstance(expression, ast.Constant) and isinstance(expression.value, int)


def _is_constant(expression: ast.expr) -> bool:
    return all(
        isinstance(n, ast.Constant | ast.BinOp | ast.operator | ast.UnaryOp | ast.unaryop)
        or (isinstance(n, ast.Name) and n.id.isupper())
        or isinstance(n, ast.expr_context)
        for n in ast.walk(expression)
    )


def idle_assertions(source: str) -> Iterator[int]:
    """Yield the lines of loops and comprehensions that may pass over nothing and in which something is asserted."""
    module = ast.parse(source)
    for function in ast.walk(module):
        if isinstance(function, ast.FunctionDef) and function.name.startswith("test_"):
            scope = _Scope(module, function)
            for loop in ast.walk(function):
                if isinstance(loop, ast.For) and _asserts(loop) and not scope.is_filled(loop.iter, loop.lineno):
                    yield loop.lineno
                if isinstance(loop, ast.Assert):
                    for generator in _judged(loop.test):
                        if not scope.is_filled(generator, loop.lineno):
                            yield loop.lineno


def _asserts(loop: ast.For) -> bool:
    return any(isinstance(node, ast.Assert) for node in ast.walk(loop))


def _judged(test: ast.expr) -> Iterator[ast.expr]:
    """Yield the comprehensions of which an assertion says that all of them hold, or none."""
    match test:
        case ast.Call(func=ast.Name(id="all"), args=[ast.GeneratorExp() as generator]):
            yield generator
        case ast.UnaryOp(
            op=ast.Not(), operand=ast.Call(func=ast.Name(id="any"), args=[ast.GeneratorExp() as generator])
        ):
            yield generator
        case ast.BoolOp(op=ast.And(), values=values):
            for value in values:
                yield from _judged(value)


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(TESTS)))
def test_no_assertion_stands_in_a_loop_over_what_may_be_empty(path: Path) -> None:
    assert list(idle_assertions(path.read_text())) == []


@pytest.mark.parametrize(
    ("body", "idle"),
    [
        ("for x in found():\n        assert x", [2]),
        ("for x in (1, 2):\n        assert x", []),
        ("things = found()\n    for x in things:\n        assert x", [3]),
        ("things = found()\n    assert things\n    for x in things:\n        assert x", []),
        ("things = found()\n    assert len(things) > 3\n    for x in enumerate(things):\n        assert x", []),
        ("for x in range(3):\n        assert x", []),
        ("for x in range(len(found())):\n        assert x", [2]),
        ("for x in filled(found()):\n        assert x", []),
        ("assert all(x for x in found())", [2]),
        ("assert not any(x for x in found())", [2]),
        ("assert all(x for x in (1, 2) if x)", [2]),
    ],
)
def test_the_check_tells_what_may_be_empty_from_what_cannot(body: str, idle: list[int]) -> None:
    assert list(idle_assertions(f"def test_it():\n    {body}\n")) == idle
