"""The calibration of `uniteam train`: what the networks' scores are worth."""

from pathlib import Path

from rich.console import Console

from uniteam.cli.progress import counting
from uniteam.cli.terminal import shown
from uniteam.errors import InvalidInputError

VIEWS = 40


def trained_networks(work: Path) -> Path:
    """Return the folder of the networks trained in a folder; raises InvalidInputError where one is missing."""
    weights = work / "weights"
    if not (weights / "namer.onnx").is_file() or not (weights / "segmenter.onnx").is_file():
        raise InvalidInputError(f"'{weights}' holds no two networks; train the segmenter and the namer first")
    return weights


def calibrate(work: Path, homes: int, camera: str, console: Console) -> None:
    """Fit the calibration of the networks in a folder's `weights`, and write it into their card."""
    from dataclasses import replace

    from uniteam.evaluation.worker import camera_named
    from uniteam.mind.perception.learned.asking import ROLES
    from uniteam.mind.perception.learned.eyes import Eyes
    from uniteam.mind.perception.learned.networks import read_card
    from uniteam.training.calibration import fit_calibration, watch_training_homes
    from uniteam.training.card import change_card

    weights = trained_networks(work)
    card = replace(read_card(weights), calibration={})
    with counting(console, "homes", homes) as advance:
        sightings = watch_training_homes(Eyes(weights), card, homes, VIEWS, camera_named(camera), advance)
    calibration = {role: fit_calibration(sightings.answers, role) for role in ROLES.values()}
    facts = {"homes": homes, "views a home": VIEWS, "camera": camera, "answers": len(sightings.answers)}
    change_card(weights, "calibration", facts, calibration=calibration)
    console.print(f"Written: the calibration into {shown(weights / 'card.json')}", soft_wrap=True)
