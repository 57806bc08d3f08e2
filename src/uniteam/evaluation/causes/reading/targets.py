"""What of the things that count was in view and recognised, and how near the base came to them."""

from collections import Counter
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.causes.reading.belief import Look, spread
from uniteam.evaluation.causes.reading.places import nearest_to
from uniteam.evaluation.causes.story import Target
from uniteam.evaluation.recording.recording import Recording
from uniteam.world.task.judge import VIEW_COVERAGE

MOST_LOOKS = 24
"""Pictures of one instance that are looked into, evenly spread over those that show it."""


def moments_to_look(recording: Recording, names: Sequence[str], until: int) -> set[int]:
    """Return the moments before `until` at which to look at some instances.

    They are those at which an instance is large in the picture, or is in it at all where it is never large.
    """
    return {moment for name in names for moment in spread(_shown(recording, name, until), MOST_LOOKS)}


def _shown(recording: Recording, name: str, until: int) -> list[int]:
    clear = np.flatnonzero(_is_clear(recording, name)[:until])
    return (clear if len(clear) else np.flatnonzero(recording.visible_pixels(name)[:until])).tolist()


def read_target(
    recording: Recording,
    name: str,
    category: str,
    looks: Mapping[int, Look],
    bases: NDArray[np.float64],
    span: tuple[int, int],
) -> Target:
    """Return an instance as a `Target`.

    Args:
        recording: of the episode.
        name: of the instance.
        category: what it should be recognised as.
        looks: pictures, by moment.
        bases: (M, 2) where the base was (m, world).
        span: from which moment the base's nearness counts, and up to which moment (left out) anything does.
    """
    home, (begin, until) = recording.home, span
    pixels, clear = recording.visible_pixels(name)[:until], _is_clear(recording, name)[:until]
    index = recording.header.instances.index(name)
    names = {moment: looks[moment].name_of(index) for moment in sorted(looks) if moment < until and pixels[moment]}
    others = Counter(given for given in names.values() if given not in ("", category))
    nearest, distance = nearest_to(home, home.by_name[name], bases[begin:until])
    seen = np.flatnonzero(clear)
    x, y, _ = home.by_name[name].position
    return Target(
        name=name,
        seen_at=int(seen[0]) if len(seen) else None,
        seen_for=len(seen),
        most_pixels=int(pixels.max()),
        recognised_at=next((moment for moment, given in names.items() if given == category), None),
        taken_for=others.most_common(1)[0][0] if others else "",
        nearest=distance,
        nearest_at=begin + nearest,
        place=(x, y),
    )


def _is_clear(recording: Recording, name: str) -> NDArray[np.bool_]:
    """Return at which moments (M,) an instance covers as much of the picture as finding it takes."""
    camera = recording.header.camera
    return np.asarray(recording.visible_pixels(name) >= VIEW_COVERAGE * camera.width * camera.height)
