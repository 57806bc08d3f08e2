"""Write the tables of docs/improvements.md from the improvements themselves.

python tools/improvement_tables.py
"""

import re
from collections.abc import Iterable
from pathlib import Path

from uniteam.mind.agents.beyond import BEYOND
from uniteam.mind.agents.improvement import Improvement
from uniteam.mind.agents.other_ways import OTHER_WAYS
from uniteam.mind.agents.report import REPORT

PAGE = Path(__file__).parents[1] / "docs" / "improvements.md"


def table(improvements: Iterable[Improvement]) -> str:
    """Return a Markdown table of the improvements' names and summaries."""
    rows = (f"| `{improvement.name}` | {improvement.summary} |" for improvement in improvements)
    return "\n".join(("| name | what changes |", "|---|---|", *rows))


def with_tables(page: str) -> str:
    """Return the page with each table between its two marks written anew."""
    for name, improvements in (("report", REPORT), ("beyond", BEYOND), ("other", OTHER_WAYS)):
        between = rf"(<!-- table: {name} -->\n).*?(<!-- end -->)"
        page, count = re.subn(between, rf"\1\n{table(improvements)}\n\n\2", page, flags=re.DOTALL)
        if count != 1:
            raise SystemExit(f"{PAGE} must have one '<!-- table: {name} -->' with an '<!-- end -->', has {count}")
    return page


if __name__ == "__main__":
    PAGE.write_text(with_tables(PAGE.read_text()))
