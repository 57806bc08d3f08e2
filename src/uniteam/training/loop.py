"""Training that can be stopped and goes on: steps, a learning rate that falls, checkpoints, and a log of figures."""

import json
import math
import time
from collections.abc import Callable, Mapping
from copy import deepcopy
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path

import torch
from torch import Tensor, nn

from uniteam.files import try_folder, write_whole

BACKBONE_RATE, HEAD_RATE = 1e-4, 1.5e-3
WEIGHT_DECAY = 0.02
_WARM_UP = 0.02
"""Share of the steps in which the learning rate rises."""
_LAST_RATE = 0.02
"""Share of the learning rate at the end."""
_AVERAGING = 0.998
_MOST_GRADIENT = 5.0


@dataclass(frozen=True)
class Plan:
    """How long to train, and how often to look.

    Attributes:
        steps: in all; a run that was stopped goes on to it.
        check_seconds: between two validations, each of which is logged and kept as a checkpoint (s).
        folder: of checkpoint and log.
    """

    steps: int
    check_seconds: float
    folder: Path


class Training:
    """A network in training, with an average of its weights, which is what is validated and used."""

    def __init__(self, model: nn.Module, plan: Plan, device: torch.device) -> None:
        """Take a network; its attribute `backbone` is trained more slowly. Goes on from the folder's checkpoint."""
        try_folder(plan.folder)
        self.model = model.to(device, memory_format=torch.channels_last)
        self.average = deepcopy(self.model).eval()
        self.plan, self.step, self.device = plan, 0, device
        backbone = [p for name, p in model.named_parameters() if name.startswith("backbone.")]
        others = [p for name, p in model.named_parameters() if not name.startswith("backbone.")]
        groups = [{"params": backbone, "peak": BACKBONE_RATE}, {"params": others, "peak": HEAD_RATE}]
        self.optimizer = torch.optim.AdamW(groups, lr=HEAD_RATE, weight_decay=WEIGHT_DECAY)
        if self.checkpoint.is_file():
            self._restore()

    @property
    def checkpoint(self) -> Path:
        """Where the state is kept."""
        return self.plan.folder / "checkpoint.pt"

    def run(
        self,
        loss_of: Callable[[nn.Module, int], Tensor],
        figures_of: Callable[[nn.Module], Mapping[str, float]],
        on_step: Callable[[int, float], None],
    ) -> None:
        """Train to the plan's end.

        Args:
            loss_of: from the network and the number of the step to the loss.
            figures_of: from the averaged network to the figures that are logged.
            on_step: called with the number of steps done and the loss.
        """
        checked, losses = time.monotonic(), []
        while self.step < self.plan.steps:
            losses.append(self._take_step(loss_of))
            on_step(self.step, losses[-1])
            if time.monotonic() - checked > self.plan.check_seconds or self.step == self.plan.steps:
                self._check(figures_of, sum(losses) / len(losses))
                checked, losses = time.monotonic(), []

    def _take_step(self, loss_of: Callable[[nn.Module, int], Tensor]) -> float:
        self.model.train()
        for group in self.optimizer.param_groups:
            group["lr"] = group["peak"] * self._rate()
        with torch.autocast(self.device.type, dtype=torch.bfloat16):
            loss = loss_of(self.model, self.step)
        self.optimizer.zero_grad(set_to_none=True)
        loss.backward()
        nn.utils.clip_grad_norm_(self.model.parameters(), _MOST_GRADIENT)
        self.optimizer.step()
        self.step += 1
        share = min(_AVERAGING, self.step / (self.step + 10.0))
        with torch.no_grad():
            for mean, value in zip(self.average.parameters(), self.model.parameters(), strict=True):
                mean.lerp_(value, 1.0 - share)
        return float(loss.detach())

    def _rate(self) -> float:
        """Return the share of the peak learning rate: it rises, then falls as a cosine."""
        done = self.step / self.plan.steps
        if done < _WARM_UP:
            return (done + 1.0 / self.plan.steps) / _WARM_UP
        return _LAST_RATE + (1.0 - _LAST_RATE) * 0.5 * (1.0 + math.cos(math.pi * (done - _WARM_UP) / (1.0 - _WARM_UP)))

    def _check(self, figures_of: Callable[[nn.Module], Mapping[str, float]], loss: float) -> None:
        with torch.no_grad():
            figures = figures_of(self.average)
        entry = {"step": self.step, "loss": round(loss, 4), **{name: round(v, 4) for name, v in figures.items()}}
        with (self.plan.folder / "log.jsonl").open("a") as log:
            log.write(json.dumps(entry) + "\n")
        content = BytesIO()
        state = {"model": self.model.state_dict(), "average": self.average.state_dict()}
        torch.save({**state, "optimizer": self.optimizer.state_dict(), "step": self.step}, content)
        write_whole(self.checkpoint, content.getvalue())

    def _restore(self) -> None:
        state = torch.load(self.checkpoint, map_location=self.device, weights_only=True)
        self.model.load_state_dict(state["model"])
        self.average.load_state_dict(state["average"])
        self.optimizer.load_state_dict(state["optimizer"])
        self.step = int(state["step"])


def best_device() -> torch.device:
    """Return a GPU where there is one."""
    return torch.device("cuda" if torch.cuda.is_available() else "cpu")
