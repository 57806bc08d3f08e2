"""Everything public is documented and typed."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import uniteam

PACKAGE = Path(uniteam.__file__).parent
MODULES = sorted(path.relative_to(PACKAGE).as_posix() for path in PACKAGE.rglob("*.py"))
Function = ast.FunctionDef | ast.AsyncFunctionDef


def parsed(module: str) -> ast.Module:
    return ast.parse((PACKAGE / module).read_text())


def public(body: list[ast.stmt], around: str) -> Iterator[tuple[str, ast.ClassDef | Function]]:
    """Yield the public classes, functions and methods of a module or a class by their names."""
    for node in body:
        if isinstance(node, ast.ClassDef | Function) and not node.name.startswith("_"):
            yield f"{around}{node.name}", node
            if isinstance(node, ast.ClassDef):
                yield from public(node.body, f"{node.name}.")


def functions(tree: ast.Module) -> Iterator[Function]:
    return (node for node in ast.walk(tree) if isinstance(node, Function))


def untyped(function: Function) -> list[str]:
    """Return the parameters without a type, and "return" where that has none."""
    given = function.args
    every = [*given.posonlyargs, *given.args, *given.kwonlyargs, *filter(None, (given.vararg, given.kwarg))]
    missing = [one.arg for one in every if one.annotation is None and one.arg not in ("self", "cls")]
    return missing if function.returns is not None else [*missing, "return"]


@pytest.mark.parametrize("module", MODULES)
def test_every_public_module_class_function_and_method_is_documented(module: str) -> None:
    tree = parsed(module)
    undocumented = [name for name, node in public(tree.body, "") if not (ast.get_docstring(node) or "").strip()]
    assert undocumented == []
    assert ast.get_docstring(tree)


@pytest.mark.parametrize("module", MODULES)
def test_every_function_is_typed(module: str) -> None:
    assert {f.name: missing for f in functions(parsed(module)) if (missing := untyped(f))} == {}
