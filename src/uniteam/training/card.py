"""The card of the networks, for programs and people: what they can name, and how they were made."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from uniteam.files import write_whole
from uniteam.mind.perception.learned.networks import WEIGHTS
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES

_EMPTY: Mapping[str, Any] = {
    "names": {"object": [], "receptacle": [], "decor": []},
    "receptacles": list(RECEPTACLE_CATEGORIES),
    "scale": 1.0,
    "calibration": {},
    "made": {},
}


def change_card(folder: Path, part: str, facts: Mapping[str, Any], **changes: Any) -> None:
    """Change what a folder's card says, and note how a part was made.

    Args:
        folder: of the networks; its card is begun where there is none.
        part: "segmenter", "namer" or "calibration".
        facts: of its making: homes, steps, figures.
        changes: fields of the card with their new values.

    Raises:
        UnwritableError: the folder cannot be written into.
    """
    card = {**read_plain_card(folder), **changes}
    card["made"] = {**card["made"], part: dict(facts)}
    write_whole(folder / "card.json", (json.dumps(card, indent=1) + "\n").encode())
    write_whole(folder / "card.md", _page(card).encode())


def read_plain_card(folder: Path = WEIGHTS) -> dict[str, Any]:
    """Return a card as plain data; an empty one where there is none."""
    path = folder / "card.json"
    return {**_EMPTY, **(json.loads(path.read_text(encoding="utf-8")) if path.is_file() else {})}


def steps_before(folder: Path | None, part: str) -> int:
    """Return how many steps the networks of a folder say that a part was trained for; 0 where they say nothing."""
    facts = {} if folder is None else read_plain_card(folder)["made"].get(part, {})
    return int(facts.get("steps in all", facts.get("steps", 0)))


def _page(card: Mapping[str, Any]) -> str:
    """Return the card for people."""
    names = card["names"]
    lines = [
        "# Networks of perception `learned`",
        "",
        "`segmenter.onnx` says where things are, `namer.onnx` what they are. Both are EfficientNet-Lite0 (Apache-2.0) "
        "with ImageNet's weights, trained further on renders of training homes only: no home, no model and no name of "
        "an unseen category, of validation or of test was used. One training model in seven was held out to validate "
        "and to calibrate.",
        "",
        f"The namer was trained with {len(names['object'])} names of objects, {len(names['receptacle'])} of "
        f"receptacles and {len(names['decor'])} of decor, and places others in the same space of words.",
        "",
        "They know rendered homes with plain light, and are not meant to judge people or to keep anybody safe.",
    ]
    for part, facts in card["made"].items():
        lines += ["", f"## How the {part} was made", "", "| what | value |", "|---|---|"]
        lines += [f"| {name} | {value} |" for name, value in facts.items()]
    return "\n".join(lines) + "\n"
