"""A part of a page that a command writes, between two marks, and all else in it as its author left it."""

import re

from uniteam.errors import InvalidInputError

END = "<!-- end -->"


def block_of(page: str, name: str) -> str | None:
    """Return what stands between a page's marks of a name; None where it has none."""
    match = _pattern(name).search(page)
    return match[2].strip() if match else None


def with_block(page: str, name: str, content: str) -> str:
    """Return the page with what stands between its marks of a name replaced, or put behind it where it has none.

    Raises:
        InvalidInputError: it has the marks twice, or the first of them only.
    """
    block = f"<!-- {name} -->\n\n{content.strip()}\n\n{END}"
    count = len(_pattern(name).findall(page))
    if page.count(f"<!-- {name} -->") != count or count > 1:
        raise InvalidInputError(f"the page must have '<!-- {name} -->' once, with an '{END}' behind it")
    if count == 0:
        return f"{page.rstrip()}\n\n{block}\n".lstrip()
    return _pattern(name).sub(lambda match: block, page)


def _pattern(name: str) -> re.Pattern[str]:
    return re.compile(rf"(<!-- {re.escape(name)} -->)((?:(?!<!-- ).)*?){re.escape(END)}", re.DOTALL)
