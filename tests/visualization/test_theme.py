"""Colours of the pages: what is written can be read, in light and in dark."""

import re
from importlib.resources import files

import pytest
from worlds.filled import filled

THEME = files("uniteam.visualization.page_parts").joinpath("theme.css").read_text()


def colours(selector: str) -> dict[str, str]:
    block = THEME.partition(f"{selector} {{")[2].partition("}")[0]
    return dict(re.findall(r"--([\w-]+): (#[0-9a-f]{6})", block))


def luminance(colour: str) -> float:
    """Return the relative luminance of WCAG 2.2."""
    shares = (int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5))
    red, green, blue = (s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4 for s in shares)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one: str, other: str) -> float:
    darker, lighter = sorted((luminance(one), luminance(other)))
    return (lighter + 0.05) / (darker + 0.05)


@pytest.mark.parametrize("selector", [":root", ':root[data-theme="dark"]'])
def test_words_stand_out_from_what_they_stand_on(selector: str) -> None:
    own = colours(selector)
    for words in filled(("ink", "soft", "accent", "object", "start", "goal", "good", "bad", "run-0", "run-1")):
        for ground in ("paper", "card"):
            assert contrast(own[words], own[ground]) >= 4.5, (words, ground)
    for words, ground in filled((("good", "good-tint"), ("bad", "bad-tint"), ("on-accent", "accent"))):
        assert contrast(own[words], own[ground]) >= 4.5, (words, ground)
