"""Test with LeRobot itself what is written for it, in an environment of its own; it needs Python 3.12 or newer.

python3.12 tools/check_lerobot.py FOLDER

makes the environment where it is missing (PyTorch: several GB), runs the tests of the plug-ins in `packages`, and goes
the whole way: it records demonstrations, exports them, trains a small ACT on them for one step, and plays it in the
plug-in's environment. Networks have random weights; no weights are fetched.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from own_environment import ROOT, commands_with, folder_asked_for

PLUGINS = ("lerobot_env_uniteam", "lerobot_robot_uniteam_stretch")
LEROBOT = "lerobot[dataset,training]>=0.6,<0.7"
DEVICE = "--policy.device=cpu"

SMALL_ACT = (
    "--policy.type=act", "--policy.pretrained_backbone_weights=null", "--policy.push_to_hub=false",
    "--policy.dim_model=64", "--policy.n_heads=2", "--policy.dim_feedforward=128", "--policy.n_encoder_layers=1",
    "--policy.n_vae_encoder_layers=1", "--policy.chunk_size=10", "--policy.n_action_steps=10", DEVICE,
)  # fmt: skip


def main() -> int:
    """Return the exit status of what failed first, or 0."""
    folder = folder_asked_for(sys.argv[1:], __doc__)
    if folder is None:
        return 2
    if sys.version_info < (3, 12):
        print("LeRobot needs Python 3.12 or newer: give this to python3.12")
        return 2
    plugins = (str(ROOT / "packages" / name) for name in PLUGINS)
    work, commands = folder / "check", commands_with(folder, f"{ROOT}[gym,robot,lerobot]", *plugins, LEROBOT)
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir()
    for command, where in _steps(work):
        print("$", *command, flush=True)
        status = subprocess.run([commands / command[0], *command[1:]], cwd=where, env=_environment(work)).returncode
        if status:
            return status
    return 0


def _steps(work: Path) -> list[tuple[tuple[str, ...], Path]]:
    """Return what is done one after the other, each with the folder that it is done in."""
    policy = work / "trained" / "checkpoints" / "last" / "pretrained_model"
    return [
        (("pytest", "-n", "0", "-rs", "packages"), ROOT),
        (("uniteam", "evaluate", "--agents", "oracle", "uniteam-plus", "--split", "minival", "--episodes", "2",
          "--record", "all", "--out", "run"), work),
        (("uniteam", "export", "lerobot", "run", "--successes", "--out", "demonstrations"), work),
        (("lerobot-train", "--dataset.repo_id=uniteam/demonstrations", "--dataset.root=demonstrations",
          "--dataset.video_backend=pyav", *SMALL_ACT, "--batch_size=4", "--num_workers=0", "--steps=1", "--log_freq=1",
          "--save_freq=1", "--output_dir=trained", "--wandb.enable=false"), work),
        (("lerobot-eval", f"--policy.path={policy}", DEVICE, "--env.type=uniteam", "--env.split=minival",
          "--env.episode_length=20", "--eval.n_episodes=2", "--eval.batch_size=2", "--output_dir=played"), work),
    ]  # fmt: skip


def _environment(work: Path) -> dict[str, str]:
    """Return the variables of this process, without its own paths of modules, and without a hub."""
    own = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    return {**own, "HF_HUB_OFFLINE": "1", "HF_HOME": str(work / "hub")}


if __name__ == "__main__":
    sys.exit(main())
