"""From nothing to a network's file: views are made, it is trained, judged, written, and described."""

import math
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import torch
from torch import nn

from uniteam.training import train_namer, train_segmenter
from uniteam.training.card import change_card, read_plain_card, steps_before
from uniteam.training.export import export_namer, export_segmenter, halve
from uniteam.training.loop import Plan
from uniteam.training.namer import Namer
from uniteam.training.proposal_crops import make_proposals
from uniteam.training.segmenter import Segmenter
from uniteam.training.start import begin_with
from uniteam.training.view_store import VIEWS_A_HOME, make_views
from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES

PROPOSALS_FROM = 5_000
"""Number of the first home whose views the segmenter's proposals are taken from: not those it was trained on."""

Advance = Callable[[str, int, int], None]
"""Told what is being done, how much of it is done, and how much there is."""


@dataclass(frozen=True)
class Order:
    """What to make.

    Attributes:
        work: folder of views, checkpoints and logs.
        homes: how many training homes.
        proposal_homes: of how many more the segmenter's proposals are taken, for the namer.
        steps: of training.
        start: folder of the networks to begin with; ImageNet's weights alone where it is None.
        models: library of the training homes' models; the pack where it is None.
        check_seconds: between two checkpoints (s).
    """

    work: Path
    homes: int
    proposal_homes: int
    steps: int
    start: Path | None = None
    models: Catalogue | None = None
    check_seconds: float = 300.0

    @property
    def views(self) -> Path:
        """Folder of the views."""
        return self.work / "views"

    @property
    def weights(self) -> Path:
        """Folder of the networks' files."""
        return self.work / "weights"


def make_segmenter(order: Order, advance: Advance) -> Mapping[str, float]:
    """Make the segmenter and return its figures."""
    _make_views(order, advance)
    began = time.monotonic()
    plan = Plan(order.steps, order.check_seconds, order.work / "segmenter")
    begun = _begun(Segmenter(len(RECEPTACLE_CATEGORIES)), order, "segmenter")
    model = train_segmenter.train_segmenter(begun, order.views, plan, _steps(order, advance))
    with torch.no_grad():
        figures = train_segmenter.figures(model, train_segmenter.validated_frames(order.views))
    _write(model, order.weights / "segmenter.onnx", export_segmenter)
    facts = _facts(order, "segmenter", train_segmenter.BATCH, figures, began)
    change_card(order.weights, "segmenter", facts, receptacles=list(RECEPTACLE_CATEGORIES))
    return figures


def make_namer(order: Order, advance: Advance) -> Mapping[str, float]:
    """Make the namer and return its figures; it learns from the segmenter's proposals too where there is one."""
    _make_views(order, advance)
    segmenter = order.weights / "segmenter.onnx"
    if segmenter.is_file() and order.proposal_homes:
        homes = range(PROPOSALS_FROM, PROPOSALS_FROM + order.proposal_homes)
        made = _Counter(advance, "homes' proposals", len(homes))
        make_proposals(order.views, segmenter, homes, made, VIEWS_A_HOME, order.models)
    began = time.monotonic()
    plan = Plan(order.steps, order.check_seconds, order.work / "namer")
    model = train_namer.train_namer(_begun(_namer(order), order, "namer"), order.views, plan, _steps(order, advance))
    assert isinstance(model, Namer)
    learnt, held_out = train_namer.divided(train_namer.all_crops(order.views))
    names = train_namer.training_names(learnt)
    figures = train_namer.figures(model, train_namer.validated_crops(held_out, names), names)
    scale = float(model.log_scale.detach().exp())
    _write(model, order.weights / "namer.onnx", export_namer)
    by_role = {role: train_namer.names_of_role(learnt, role) for role in ("object", "receptacle", "decor")}
    change_card(
        order.weights, "namer", _facts(order, "namer", train_namer.BATCH, figures, began), names=by_role, scale=scale,
        calibration={},
    )  # fmt: skip
    return figures


def _namer(order: Order) -> Namer:
    """Return the namer to train, as sharp as the card of the one to begin with says."""
    namer = Namer()
    if order.start is not None:
        with torch.no_grad():
            namer.log_scale.fill_(math.log(float(read_plain_card(order.start)["scale"])))
    return namer


def _begun(model: nn.Module, order: Order, part: str) -> nn.Module:
    if order.start is not None:
        begin_with(model, order.start / f"{part}.onnx")
    return model


def _make_views(order: Order, advance: Advance) -> None:
    made = _Counter(advance, "homes' views", order.homes)
    make_views(order.views, range(order.homes), made, library=order.models)


def _write(model: nn.Module, path: Path, export: Callable[[nn.Module, Path], None]) -> None:
    whole = path.with_suffix(".float32.onnx")
    export(model, whole)
    halve(whole, path)
    whole.unlink()


def _steps(order: Order, advance: Advance) -> Callable[[int, float], None]:
    return lambda step, loss: advance(f"steps, loss {loss:.2f}", step, order.steps)


def _facts(order: Order, part: str, batch: int, figures: Mapping[str, float], began: float) -> dict[str, Any]:
    device = "GPU" if torch.cuda.is_available() else "CPU"
    return {
        "homes": order.homes,
        "views a home": VIEWS_A_HOME,
        "homes of proposals": order.proposal_homes,
        "steps": order.steps,
        "steps in all": order.steps + steps_before(order.start, part),
        "examples a step": batch,
        "trained on": f"{device}, {(time.monotonic() - began) / 60.0:.0f} minutes since it was last begun",
        **{f"held out: {name}": round(value, 3) for name, value in figures.items()},
    }


class _Counter:
    """Counts what is done, and says so."""

    def __init__(self, advance: Advance, what: str, total: int) -> None:
        self._advance, self._what, self._total, self._done = advance, what, total, 0
        advance(what, 0, total)

    def __call__(self) -> None:
        self._done += 1
        self._advance(self._what, self._done, self._total)
