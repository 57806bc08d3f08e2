"""Which models training homes may use, and which object categories they never hold."""

import hashlib
from collections import defaultdict
from typing import Any

TRAIN_SHARE = 0.6


def assign_pools(models: list[dict[str, Any]], unseen: frozenset[str]) -> list[dict[str, Any]]:
    """Return the models with their pool: by category, three fifths train, in an order that only the ids decide.

    A category of one model trains, and an unseen category only tests.
    """
    groups: defaultdict[tuple[str, str], list[dict[str, Any]]] = defaultdict(list)
    for model in models:
        groups[model["role"], model["category"]].append(model)
    result = []
    for (role, category), group in groups.items():
        group.sort(key=lambda m: hashlib.sha256(m["id"].encode()).hexdigest())
        count = len(group)
        train = (
            0
            if role == "object" and category in unseen
            else 1
            if count == 1
            else min(round(TRAIN_SHARE * count), count - 1)
        )
        result += [model | {"pool": "train" if k < train else "test"} for k, model in enumerate(group)]
    return sorted(result, key=lambda m: (m["role"], m["category"], m["id"]))
