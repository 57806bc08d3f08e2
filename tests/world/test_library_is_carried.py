"""A home carries its library: what draws, moves or judges a home never fetches another."""

import ast
from pathlib import Path

import pytest

import uniteam

SOURCE = Path(uniteam.__file__).parent


@pytest.mark.parametrize(
    "folder",
    ["world/rendering", "world/physics", "world/simulation", "world/oracle", "world/certification", "visualization"],
)
def test_no_one_but_makers_readers_and_commands_fetches_the_pack(folder: str) -> None:
    guilty = [
        path.relative_to(SOURCE).as_posix()
        for path in (SOURCE / folder).rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Name) and node.id in ("load_catalogue", "load_library")
    ]
    assert not guilty
