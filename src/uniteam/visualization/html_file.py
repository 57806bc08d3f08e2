"""A page as one file: its styles, scripts and data lie in it, and it is forbidden to fetch anything."""

import base64
import html
import json
from collections.abc import Sequence
from dataclasses import dataclass
from hashlib import sha256
from importlib.resources import files
from importlib.resources.abc import Traversable
from typing import Any

_SHARED = "uniteam.visualization.page_parts"
_READ_DATA = 'const DATA = JSON.parse(document.getElementById("data").textContent);'


@dataclass(frozen=True)
class PageParts:
    """What a page is made of, but for its data.

    Attributes:
        package: in which its files lie.
        body: name of the file with the body's HTML.
        styles: names of its own style sheets, in their order; those that all pages share come before.
        scripts: names of its own scripts, in their order; they run as one, in strict mode.
    """

    package: str
    body: str
    styles: Sequence[str]
    scripts: Sequence[str]


def html_file(parts: PageParts, title: str, data: Any) -> str:
    """Return the whole page.

    Args:
        parts: of the page.
        title: for the browser's tab.
        data: plain JSON data, which the scripts find parsed as `DATA`.
    """
    own, shared = files(parts.package), files(_SHARED)
    style = "\n".join([_text(shared, "theme.css"), *(_text(own, name) for name in parts.styles)])
    code = "\n".join([_text(shared, "theme.js"), *(_text(own, name) for name in parts.scripts)])
    script = f'(() => {{\n"use strict";\n{_READ_DATA}\n{code}}})();'
    return _PAGE.format(
        title=html.escape(title),
        policy=_policy(style, script),
        style=style,
        body=_text(own, parts.body),
        data=_in_script(data),
        script=script,
    )


def _text(folder: Traversable, name: str) -> str:
    return folder.joinpath(name).read_text(encoding="utf-8")


def _policy(style: str, script: str) -> str:
    """Return the rule by which the browser runs this style and script only, and fetches nothing."""
    return (
        f"default-src 'none'; style-src '{_digest(style)}'; script-src '{_digest(script)}'; "
        "img-src data: blob:; media-src blob:; base-uri 'none'; form-action 'none'"
    )


def _digest(text: str) -> str:
    return f"sha256-{base64.b64encode(sha256(text.encode()).digest()).decode()}"


def _in_script(data: Any) -> str:
    """Return JSON that cannot end the element it lies in, whatever words it holds."""
    text = json.dumps(data, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")


_PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{title}</title>
<link rel="icon" href="data:,">
<style>{style}</style>
</head>
<body>
{body}
<script type="application/json" id="data">{data}</script>
<script>{script}</script>
</body>
</html>
"""
