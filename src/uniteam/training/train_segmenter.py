"""Training of the segmenter."""

from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
import torch
from torch import nn

from uniteam.errors import InvalidInputError
from uniteam.mind.perception.learned.kinds import Kind
from uniteam.training.backbone import network_input
from uniteam.training.loop import Plan, Training, best_device
from uniteam.training.prefetch import prefetched
from uniteam.training.segmenter import segmenter_loss
from uniteam.training.segmenter_data import NO_RECEPTACLE, FrameSampler
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES

BATCH = 4
VALIDATED_HOMES = 2
"""Homes, the first, that are kept to validate."""
_VALIDATED_FRAMES = 64


def train_segmenter(model: nn.Module, views: Path, plan: Plan, on_step: Callable[[int, float], None]) -> nn.Module:
    """Train a segmenter on the frames of a folder, and return its averaged network.

    Raises:
        InvalidInputError: there are too few homes in the folder.
    """
    paths = sorted(views.glob("frames-*.msgpack"))
    if len(paths) <= VALIDATED_HOMES:
        raise InvalidInputError(
            f"'{views}' holds the frames of {len(paths)} homes, more than {VALIDATED_HOMES} are needed; "
            "make them with: uniteam train segmenter --homes 200"
        )
    validated = validated_frames(views)
    sampler = FrameSampler(paths[VALIDATED_HOMES:], RECEPTACLE_CATEGORIES)
    device = best_device()
    training = Training(model, plan, device)
    batches = prefetched(lambda step: sampler.batch(BATCH, np.random.default_rng([2, step])), training.step)

    def loss_of(model: nn.Module, step: int) -> torch.Tensor:
        return segmenter_loss(model, next(batches), device)

    training.run(loss_of, lambda model: figures(model, validated), on_step)
    return training.average


def validated_frames(views: Path) -> FrameSampler:
    """Return the frames that training is judged by."""
    return FrameSampler(sorted(views.glob("frames-*.msgpack"))[:VALIDATED_HOMES], RECEPTACLE_CATEGORIES)


def figures(model: nn.Module, frames: FrameSampler) -> Mapping[str, float]:
    """Return how well cells are told: each kind's intersection over union, and the receptacles' mean."""
    device = next(model.parameters()).device
    kinds = np.zeros((len(Kind), len(Kind)), dtype=np.int64)
    names = np.zeros((len(RECEPTACLE_CATEGORIES), len(RECEPTACLE_CATEGORIES)), dtype=np.int64)
    for first in range(0, min(_VALIDATED_FRAMES * 2, len(frames.frames)), 16):
        batch = frames.plain(first, 8)
        with torch.no_grad():
            geometry = torch.from_numpy(batch.geometry).to(device)
            logits = model(network_input(batch.images, device), geometry).cpu().numpy()
        np.add.at(kinds, (batch.kinds, logits[:, : len(Kind)].argmax(axis=1)), 1)
        is_known = batch.receptacles != NO_RECEPTACLE
        found = logits[:, len(Kind) + 1 :].argmax(axis=1)
        np.add.at(names, (batch.receptacles[is_known], found[is_known]), 1)
    overlap = _overlaps(kinds)
    return {
        **{kind.name.lower(): float(overlap[kind]) for kind in Kind},
        "receptacle names": float(np.nanmean(_overlaps(names))),
        "receptacle cells": float(np.trace(names) / max(1, names.sum())),
    }


def _overlaps(confusion: np.ndarray) -> np.ndarray:
    """Return the intersection over union of each class of a (K, K) confusion; not a number where there is none."""
    hits = np.diag(confusion).astype(np.float64)
    union = confusion.sum(axis=0) + confusion.sum(axis=1) - hits
    return np.where(confusion.sum(axis=1) > 0, hits / np.maximum(union, 1), np.nan)
