"""A real browser without a window, for the pages that are written; tests skip where there is none."""

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

NAMES = ("chromium", "chromium-browser", "google-chrome")
FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
)  # fmt: skip
WIDE, PHONE = {"width": 1280, "height": 800}, {"width": 390, "height": 844}


@contextmanager
def chromium() -> Iterator[Any]:
    """Yield a browser; skips the test where Playwright or Chromium is missing."""
    api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    path = next(filter(None, map(shutil.which, NAMES)), None)
    if path is None:
        pytest.skip(f"there is no Chromium: none of {', '.join(NAMES)} is on the path")
    with api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=list(FLAGS))
        yield browser
        browser.close()


@dataclass
class Tab:
    """A page that is open, and what went wrong in it or was asked of a network."""

    page: Any
    errors: list[str] = field(default_factory=list)
    fetched: list[str] = field(default_factory=list)

    @property
    def seconds(self) -> float:
        """From the page's beginning until it could be used."""
        return float(self.page.get_attribute("html", "data-ready")) / 1000.0


@contextmanager
def opened(browser: Any, file: Path, viewport: dict[str, int] = WIDE, theme: str = "light") -> Iterator[Tab]:
    """Open a file without a network, wait until it can be used, and see to it that nothing went wrong by the end."""
    context = browser.new_context(viewport=viewport, color_scheme=theme, offline=True)
    tab = Tab(context.new_page())
    tab.page.on("console", lambda said: tab.errors.append(said.text) if said.type in ("error", "warning") else None)
    tab.page.on("pageerror", lambda error: tab.errors.append(str(error)))
    tab.page.on("request", lambda request: tab.fetched.append(request.url))
    tab.page.goto(file.as_uri())
    tab.page.wait_for_selector("html[data-ready]", state="attached", timeout=60_000)
    yield tab
    assert tab.errors == []
    assert [url for url in tab.fetched if not url.startswith(("file:", "blob:", "data:"))] == []
    context.close()


def nameless(page: Any) -> list[str]:
    """Return what can be used or looked at on a page, and has no name that can be read aloud."""
    found: list[str] = page.evaluate(
        """() => [...document.querySelectorAll("button, input, select, a, [role=slider], [role=img], dialog, table")]
            .filter((e) => !(e.getAttribute("aria-label") || e.textContent.trim() || e.labels?.[0]?.textContent.trim()))
            .map((e) => e.outerHTML.slice(0, 80))"""
    )
    return found
