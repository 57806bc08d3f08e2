"""What `learned` is worth in the homes of a split: the figures, and the tables of `docs/perception.md`."""

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from uniteam.geometry import PinholeCamera
from uniteam.mind.perception.learned.asking import Asking
from uniteam.mind.perception.learned.eyes import Eyes
from uniteam.mind.perception.learned.networks import read_card
from uniteam.mind.perception.words.meaning import load_words
from uniteam.training.calibration import FIRST_HOME
from uniteam.training.example_views import NoteLook, ignore_look
from uniteam.training.figures import (
    BINS,
    asked_figures,
    calibration_error,
    proposal_recall,
    receptacle_overlaps,
    worst_confusions,
)  # fmt: skip
from uniteam.training.naming import Named, named
from uniteam.training.records import things_of
from uniteam.training.sightings import Sightings, Watcher
from uniteam.training.views import training_home, views_of
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES
from uniteam.world.homes.home import Home

Rows = list[tuple[str, ...]]


@dataclass(frozen=True)
class Watched:
    """What was seen in some homes, with the names that true regions got."""

    sightings: Sightings
    names: list[Named]
    unseen: frozenset[str]


def watch(
    homes: Sequence[Home],
    weights: Path,
    camera: PinholeCamera,
    views: int,
    on_home: Callable[[], None],
    on_look: NoteLook = ignore_look,
) -> Watched:
    """Look at views of homes with the networks of a folder; `on_look` is told of each view."""
    eyes, card = Eyes(weights), read_card(weights)
    watcher, names = Watcher(eyes, Asking(card, load_words()), camera, on_look), list[Named]()
    unseen = homes[0].library.unseen_categories
    groups: list[Collection[str]] = [card.names["object"], sorted(unseen), RECEPTACLE_CATEGORIES]
    for number, home in enumerate(homes):
        seen = list(views_of(home, views, np.random.default_rng([number, 3]), 0.0, 0.0))
        watcher.watch(seen, things_of(home))
        names += named(eyes, seen, things_of(home), groups, camera)
        on_home()
    return Watched(watcher.sightings, names, unseen)


def homes_with_seen_instances(count: int) -> list[Home]:
    """Return training homes in which no network was trained, of models that they were trained with."""
    return [training_home(number) for number in range(FIRST_HOME + 500, FIRST_HOME + 500 + count)]


def tables(watched: Watched) -> Mapping[str, Rows]:
    """Return the tables, the first row of each its head."""
    return {
        "Finding: regions that overlap a thing within 3 m": _proposals(watched.sightings),
        "As asked: recall at the precision that is named": _asked(watched),
        "Naming a true region": _naming(watched),
        "Receptacles by pixels: intersection over union": _receptacles(watched.sightings),
        "Receptacles: the largest confusions": _confusions(watched.sightings),
        "Calibration": _calibration(watched.sightings),
        "Time a frame": _time(watched.sightings),
    }


def as_markdown(tables: Mapping[str, Rows]) -> str:
    """Return tables in Markdown."""
    lines: list[str] = []
    for title, (head, *rows) in tables.items():
        lines += [f"### {title}", "", "| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
        lines += ["| " + " | ".join(row) + " |" for row in rows]
        lines.append("")
    return "\n".join(lines)


def _proposals(sightings: Sightings) -> Rows:
    rows: Rows = [("things", "pixels in view", "number", "overlap .3", "overlap .5")]
    for role in ("object", "receptacle"):
        for low, high in BINS:
            count, loose = proposal_recall(sightings.present, role, low, high, 0.3)
            if count:
                tight = proposal_recall(sightings.present, role, low, high, 0.5)[1]
                rows.append((f"{role}s", _size(low), str(count), f"{loose:.2f}", f"{tight:.2f}"))
    return rows


def _asked(watched: Watched) -> Rows:
    groups: list[tuple[str, str, Callable[[str], bool], tuple[float, ...]]] = [
        ("objects of seen categories", "object", lambda name: name not in watched.unseen, (0.5, 0.0)),
        ("objects of unseen categories", "object", lambda name: name in watched.unseen, (0.15, 0.0)),
        ("receptacles", "receptacle", lambda name: True, (0.5, 0.0)),
    ]
    rows: Rows = [("things", "pixels in view", "number", "at", "threshold", "recall", "precision")]
    for title, role, is_of_group, precisions in groups:
        for low, high in BINS:
            for least in precisions:
                f = asked_figures(watched.sightings, role, low, high, is_of_group, least)
                if f.there:
                    at = f"precision {least:g}" if least else "best F1"
                    numbers = (f"{f.threshold:.2f}", f"{f.recall:.2f}", f"{f.precision:.2f}")
                    rows.append((title, _size(low), str(f.there), at, *numbers))
    return rows


def _naming(watched: Watched) -> Rows:
    rows: Rows = [("things", "pixels in view", "number", "first name right", "names")]
    tests: list[tuple[str, Callable[[Named], bool]]] = [
        ("objects of seen categories", lambda n: n.thing.role == "object" and n.thing.category not in watched.unseen),
        ("objects of unseen categories", lambda n: n.thing.category in watched.unseen),
        ("receptacles", lambda n: n.thing.role == "receptacle"),
    ]
    for title, is_of in tests:
        for low, high in BINS:
            own = [n for n in watched.names if is_of(n) and low <= n.pixels < high]
            if own:
                right = np.mean([n.name == n.thing.category for n in own])
                count = len({n.thing.category for n in own})
                rows.append((title, _size(low), str(len(own)), f"{right:.2f}", f"{count} of them there"))
    return rows


def _receptacles(sightings: Sightings) -> Rows:
    overlaps = receptacle_overlaps(sightings.receptacle_pixels)
    mean = float(np.mean(list(overlaps.values()))) if overlaps else float("nan")
    ordered = sorted(overlaps.items(), key=lambda pair: -pair[1])
    return [("receptacle", "overlap"), ("mean", f"{mean:.3f}"), *((name, f"{value:.2f}") for name, value in ordered)]


def _confusions(sightings: Sightings) -> Rows:
    worst = worst_confusions(sightings.receptacle_pixels)
    return [("is", "was said to be", "share of its pixels"), *((a, b, f"{share:.2f}") for a, b, share in worst)]


def _calibration(sightings: Sightings) -> Rows:
    rows: Rows = [("role", "expected calibration error", "score said: share right (answers)")]
    for role in ("object", "receptacle"):
        error, bins = calibration_error(sightings.answers, role)
        rows.append((role, f"{error:.3f}", ", ".join(f"{s:.2f}: {r:.2f} ({n})" for s, r, n in bins)))
    return rows


def _time(sightings: Sightings) -> Rows:
    milliseconds = np.array(sightings.seconds) * 1e3
    low, middle = np.percentile(milliseconds, (10, 50))
    return [("frames", "median", "tenth percentile"), (str(sightings.frames), f"{middle:.0f} ms", f"{low:.0f} ms")]


def _size(low: int) -> str:
    return "400 and more" if low == 400 else "100 to 400"
