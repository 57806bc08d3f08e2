"""Which models training homes may use, and which object categories they never hold."""

import hashlib
from collections import defaultdict
from typing import Any

TRAIN_SHARE = 0.6


def assign_pools(models: list[dict[str, Any]], unseen: frozenset[str]) -> list[dict[str, Any]]:
    """Return the models with their pool, an unseen category's always "test".

    What families draw and generate says its own pool. What was drawn one by one trains, for it is like what families
    draw for training. Of a category's converted models three fifths train, in an order that only the ids decide; a
    single one trains.
    """
    return sorted(
        (
            model | {"pool": "test" if model["role"] == "object" and model["category"] in unseen else pool}
            for model, pool in (*_said(models), *_shared_out(models))
        ),
        key=lambda m: (m["role"], m["category"], m["id"]),
    )


def _said(models: list[dict[str, Any]]) -> list[tuple[dict[str, Any], str]]:
    return [(m, m.get("pool", "train")) for m in models if _is_settled(m)]


def _is_settled(model: dict[str, Any]) -> bool:
    return "pool" in model or (model["source"] == "drawn" and model["role"] in ("object", "receptacle"))


def _shared_out(models: list[dict[str, Any]]) -> list[tuple[dict[str, Any], str]]:
    groups: defaultdict[tuple[str, str], list[dict[str, Any]]] = defaultdict(list)
    for model in models:
        if not _is_settled(model):
            groups[model["role"], model["category"]].append(model)
    result = []
    for group in groups.values():
        group.sort(key=lambda m: hashlib.sha256(m["id"].encode()).hexdigest())
        count = len(group)
        train = 1 if count == 1 else min(round(TRAIN_SHARE * count), count - 1)
        result += [(model, "train" if k < train else "test") for k, model in enumerate(group)]
    return result
