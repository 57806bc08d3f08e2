"""Training of the namer."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np
import torch
from numpy.typing import NDArray
from torch import nn

from uniteam.errors import InvalidInputError
from uniteam.training.backbone import network_input
from uniteam.training.loop import Plan, Training, best_device
from uniteam.training.namer import Namer, name_vectors, namer_loss
from uniteam.training.namer_data import HELD_OUT, CropSampler, is_held_out, plain_batch, role_of
from uniteam.training.prefetch import prefetched
from uniteam.training.records import CropRecord, read_crops

BATCH = 32
DESIGNED_JUNK = 4
"""One in so many random pieces is kept where there are real false alarms."""
_VALIDATED = {"object": 400, "receptacle": 250, "decor": 50, "junk": 100}
"""Crops of each role."""


def train_namer(model: nn.Module, views: Path, plan: Plan, on_step: Callable[[int, float], None]) -> nn.Module:
    """Train a namer on the crops of a folder, and return its averaged network.

    Raises:
        InvalidInputError: there are no crops in the folder.
    """
    training_crops, held_out = divided(all_crops(views))
    if not training_crops:
        raise InvalidInputError(f"'{views}' holds no crops; make them with: uniteam train namer --homes 200")
    names = training_names(training_crops)
    device = best_device()
    training = Training(model, plan, device)
    sampler, vectors = CropSampler(training_crops, names), name_vectors(names).to(device)
    batches = prefetched(lambda step: sampler.batch(BATCH, np.random.default_rng([1, step])), training.step)
    generator = torch.Generator().manual_seed(training.step)
    validated = validated_crops(held_out, names)

    def loss_of(model: nn.Module, step: int) -> torch.Tensor:
        assert isinstance(model, Namer)
        return namer_loss(model, next(batches), vectors, generator)

    training.run(loss_of, lambda model: figures(model, validated, names), on_step)
    return training.average


def all_crops(views: Path) -> list[CropRecord]:
    """Return the crops of a folder; where there are proposals, few of the pieces that are no whole things by design."""
    crops = read_crops(sorted(views.glob("crops-*.msgpack")))
    proposals = read_crops(sorted(views.glob("proposals-*.msgpack")))
    if proposals:
        crops = [c for number, c in enumerate(crops) if c.thing is not None or number % DESIGNED_JUNK == 0]
    return crops + proposals


def divided(crops: Sequence[CropRecord]) -> tuple[list[CropRecord], list[CropRecord]]:
    """Return the crops to train with, and those of models that are held out, each with its share of junk."""
    junk = [c for c in crops if c.thing is None]
    things = [c for c in crops if c.thing is not None]
    kept = [c for c in things if c.thing is not None and is_held_out(c.thing.model)]
    learnt = [c for c in things if c.thing is not None and not is_held_out(c.thing.model)]
    return learnt + [c for i, c in enumerate(junk) if i % HELD_OUT], kept + junk[::HELD_OUT]


def training_names(crops: Sequence[CropRecord]) -> list[str]:
    """Return the names that crops bear, sorted; a nameless thing has none."""
    return sorted({c.thing.category for c in crops if c.thing and c.thing.category and c.thing.role != "door"})


def names_of_role(crops: Sequence[CropRecord], role: str) -> list[str]:
    """Return the names that things of a role bear, sorted."""
    return sorted({c.thing.category for c in crops if c.thing and c.thing.category and c.thing.role == role})


def figures(model: nn.Module, crops: Sequence[CropRecord], names: Sequence[str]) -> Mapping[str, float]:
    """Return how often crops get their name, by role and by pixels in view, and how well junk is told."""
    found, junk = embeddings(model, crops, names)
    scores = found @ name_vectors(names).numpy().T
    labels = plain_labels(crops, names)
    roles = np.array([role_of(c.thing) for c in crops])
    pixels = np.array([c.pixels for c in crops])
    result = {}
    for role, low, high in (("object", 400, 1 << 30), ("object", 100, 400), ("receptacle", 400, 1 << 30)):
        some = (roles == role) & (pixels >= low) & (pixels < high)
        own = np.array(
            [name in {c.thing.category for c in crops if c.thing and c.thing.role == role} for name in names]
        )
        best = np.where(own, scores[some], -np.inf).argmax(axis=1)
        result[f"{role} {low}+"] = float((best == labels[some]).mean()) if some.any() else 0.0
    is_junk = roles == "junk"
    result["junk told"] = float((junk[is_junk] > 0).mean()) if is_junk.any() else 0.0
    result["things kept"] = float((junk[~is_junk] <= 0).mean())
    return result


def plain_labels(crops: Sequence[CropRecord], names: Sequence[str]) -> NDArray[np.int64]:
    """Return the (N,) indices of the crops' names, -1 where there is none."""
    index = {name: label for label, name in enumerate(names)}
    return np.array([-1 if c.thing is None else index.get(c.thing.category, -1) for c in crops], dtype=np.int64)


def embeddings(
    model: nn.Module, crops: Sequence[CropRecord], names: Sequence[str], at_once: int = 64
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return the (N, DIMENSIONS) vectors and (N,) junk logits that a network gives crops."""
    device = next(model.parameters()).device
    vectors, junk = [], []
    for first in range(0, len(crops), at_once):
        batch = plain_batch(crops[first : first + at_once], names)
        with torch.no_grad():
            found = model(network_input(batch.crops, device), torch.from_numpy(batch.shapes).to(device))
        vectors.append(found[0].cpu().numpy())
        junk.append(found[1].cpu().numpy())
    return np.concatenate(vectors), np.concatenate(junk)


def validated_crops(crops: Sequence[CropRecord], names: Sequence[str]) -> list[CropRecord]:
    """Return those of some crops that training is judged by, the same each time."""
    order = np.random.default_rng(0).permutation(len(crops))
    known = [crops[i] for i in order if crops[i].thing is None or name_of(crops[i]) in names]
    return [c for role, most in _VALIDATED.items() for c in [c for c in known if role_of(c.thing) == role][:most]]


def name_of(crop: CropRecord) -> str:
    """Return the name of what a crop shows, empty for no whole thing."""
    return "" if crop.thing is None else crop.thing.category
