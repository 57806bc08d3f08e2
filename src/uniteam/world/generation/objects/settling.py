"""Let the objects of a drawn home come to rest, keep those that lie where they should, and say what holds them."""

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import replace

import mujoco
import numpy as np

from uniteam.world.assets.model import RECEPTACLE_CATEGORIES
from uniteam.world.homes.home import Home, Instance
from uniteam.world.physics.physics import Contact, Physics
from uniteam.world.physics.physics_model import FLOOR

ON_FLOOR = 0.02
"""What is put lower than this (m) is meant to lie on the floor."""

_SECONDS = 2.0
_MAX_SLIDE = 0.25
"""An object that ends farther than this from where it was put has fallen off something (m)."""


def resting_on(home: Home, physics: Physics | None = None) -> dict[str, str]:
    """Return the receptacle that holds each object: the one it touches at most points.

    Args:
        home: with its objects at rest.
        physics: of this home, where there is one already.
    """
    physics = Physics(home) if physics is None else physics
    holders = {name: _holder(home, contacts) for name, contacts in physics.all_contacts().items()}
    return {name: holder for name, holder in holders.items() if holder is not None}


def _holder(home: Home, contacts: Sequence[Contact]) -> str | None:
    if _is_on_floor(contacts):
        return None  # it leans against furniture at most
    touched = Counter(
        contact.other
        for contact in contacts
        if contact.other in home.by_name and home.by_name[contact.other].category in RECEPTACLE_CATEGORIES
    )
    return min(touched, key=lambda other: (-touched[other], other)) if touched else None


def settle(home: Home) -> Home:
    """Return the home with its objects as they come to rest; those that fell, roll or hang on nothing are gone."""
    physics = Physics(home)
    kept = set(physics.names)
    for _ in range(3):
        physics.settle(sorted(kept), _SECONDS)
        contacts = physics.all_contacts()
        lost = {name for name in kept if not _lies_well(home, physics, name, contacts[name])}
        for name in sorted(lost):
            physics.remove(name)
        kept -= lost
        if not lost:
            break
    things = [i for i in home.instances if not i.movable or i.name in kept]
    return replace(home, instances=tuple(_settled(i, physics) if i.movable else i for i in things))


def _lies_well(home: Home, physics: Physics, name: str, contacts: Sequence[Contact]) -> bool:
    put = home.by_name[name].position
    moved = np.linalg.norm(physics.pose(name)[:3, 3] - put)
    if moved > _MAX_SLIDE or not physics.is_at_rest(name):
        return False
    if put[2] < ON_FLOOR:
        return _is_on_floor(contacts)
    return _holder(home, contacts) is not None


def _is_on_floor(contacts: Iterable[Contact]) -> bool:
    return any(contact.other == FLOOR for contact in contacts)


def _settled(instance: Instance, physics: Physics) -> Instance:
    pose = physics.pose(instance.name)
    quaternion = np.zeros(4)
    mujoco.mju_mat2Quat(quaternion, np.ascontiguousarray(pose[:3, :3]).ravel())
    quaternion *= -1.0 if quaternion[0] < 0 else 1.0
    x, y, z = (round(float(v), 5) for v in pose[:3, 3])
    w, i, j, k = (round(float(v), 6) + 0.0 for v in quaternion)
    return replace(instance, position=(x, y, z), quaternion=(w, i, j, k))
