"""One small fault."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Mutant:
    """A change of one file after which some tests must fail.

    Attributes:
        name: by which it is chosen.
        file: below the repository's root.
        old: the text that it changes, which the file holds once.
        new: what stands there instead.
        tests: what is run, as pytest takes it.
    """

    name: str
    file: str
    old: str
    new: str
    tests: tuple[str, ...]


def a_third_up_and_down(name: str, file: str, number: str, line: str, *tests: str) -> tuple[Mutant, Mutant]:
    """Return the two mutants in which a number is a third more and a third less.

    Args:
        name: of the number.
        file: below the repository's root.
        number: as it is written.
        line: that holds it once.
        tests: what is run.
    """

    def changed(suffix: str, factor: float) -> Mutant:
        value = round(int(number) * factor) if number.isdigit() else float(number) * factor
        return Mutant(f"{name} {suffix}", file, line, line.replace(number, f"{value:.6g}"), tests)

    return changed("a third more", 4 / 3), changed("a third less", 2 / 3)
