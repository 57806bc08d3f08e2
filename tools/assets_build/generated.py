"""Instances that Infinigen generated: their triangles with finishes of our own, at real size."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.generated_plan import FIRST_TEST, Generated
from assets_build.instance import Piece
from assets_build.masses import DENSITIES
from assets_build.primitives import Drawing, Finish
from assets_build.selection import Entry
from assets_build.variation import Pool, Variation

WIDEST_GRASP = 0.139
"""An object's least side (m) is no more than what the gripper spans."""
FLAT = 1e-3
"""A part of less volume than this share of what its area could hold is a flat skin."""
SPREAD = 0.3
"""Objects' sizes differ by so much (share) about the usual one."""


def generated_pieces(planned: Generated, triangles: Path) -> Iterator[Piece]:
    """Yield the instances of a factory of which the folder has the triangles."""
    for seed in planned.seeds:
        path = triangles / f"{planned.file(seed)}.npz"
        if path.exists():
            yield _piece(planned, seed, path)


def _piece(planned: Generated, seed: int, path: Path) -> Piece:
    pool: Pool = "test" if seed >= FIRST_TEST else "train"
    v = Variation(planned.factory, pool, seed % 10_000, planned.train if pool == "train" else planned.test)
    with np.load(path) as content:
        corners = outward(sized(oriented(content["corners"].astype(np.float64), planned), planned, v))
        slots, names = content["materials"], [str(name) for name in content["names"]]
    drawing = Drawing()
    finishes = slot_finishes(names, v)
    for slot in np.unique(slots):
        drawing.add(corners[slots == slot], finishes[int(slot)])
    provenance = {
        "source": "Infinigen",
        "source_id": f"{planned.factory} {seed}",
        "creator": "the authors of Infinigen",
        "licence": "BSD-3-Clause",
    }
    entry = Entry(
        planned.file(seed), planned.role, planned.category, planned.name, collision=planned.collision, boxes=16
    )
    density = planned.density or DENSITIES.get(planned.category, DENSITIES[planned.role])
    return Piece(drawing, entry, density, provenance, pool)


def oriented(corners: NDArray[np.float64], planned: Generated) -> NDArray[np.float64]:
    """Return the corners with their front towards -y, and what should lie laid down on its broad side."""
    if planned.lying:
        order = np.argsort(np.ptp(corners.reshape(-1, 3), axis=0))
        corners = corners[..., [order[1], order[2], order[0]]]
        if np.linalg.det(np.eye(3)[[order[1], order[2], order[0]]]) < 0:
            corners = corners * np.array([-1.0, 1.0, 1.0])
    angle = np.radians(planned.turn)
    c, s = round(float(np.cos(angle)), 12), round(float(np.sin(angle)), 12)
    return corners @ np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]).T


def sized(corners: NDArray[np.float64], planned: Generated, v: Variation) -> NDArray[np.float64]:
    """Return the corners at real size: objects get their usual longest side, furniture is shortened to the most."""
    extent = np.ptp(corners.reshape(-1, 3), axis=0)
    if planned.role == "receptacle":
        return corners * np.minimum(1.0, np.array([planned.longest, planned.longest, planned.tallest]) / extent)
    usual = planned.longest * v.between(1.0 - SPREAD / 2, 1.0 + SPREAD / 2) / extent.max()
    return corners * min(usual, WIDEST_GRASP / extent.min())


def outward(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the corners with every connected part's triangles turned to wind around its outside.

    A part that is flat, as the skin of a tabletop, turns its face away from the middle of the whole.
    """
    parts = _connected_parts(corners)
    sizes = np.bincount(parts)
    middles = np.column_stack([np.bincount(parts, corners.mean(axis=1)[:, k]) / sizes for k in range(3)])
    a, b, c = np.moveaxis(corners - middles[parts][:, None], 1, 0)
    faces = np.cross(b - a, c - a)
    volumes = np.bincount(parts, np.einsum("ij,ij->i", a, np.cross(b, c)))
    areas = np.bincount(parts, np.linalg.norm(faces, axis=1))
    flat = corners.reshape(-1, 3)
    whole = (flat.min(axis=0) + flat.max(axis=0)) / 2
    away = np.bincount(parts, np.einsum("ij,ij->i", faces, middles[parts] - whole))
    outwards = np.where(np.abs(volumes) > FLAT * areas**1.5, volumes, away)
    return np.where((outwards[parts] < 0)[:, None, None], corners[:, ::-1], corners)


def _connected_parts(corners: NDArray[np.float64]) -> NDArray[np.int64]:
    """Return for each triangle which connected part of the surface it belongs to."""
    spots = np.round(corners.reshape(-1, 3) / 1e-5).astype(np.int64)
    triangles = np.unique(spots, axis=0, return_inverse=True)[1].reshape(-1, 3)
    count = int(triangles.max()) + 1
    edges = np.concatenate([triangles[:, :2], triangles[:, 1:]])
    links = coo_matrix((np.ones(len(edges), np.int8), edges.T), (count, count))
    labels = connected_components(links, directed=False)[1][triangles[:, 0]]
    return np.unique(labels, return_inverse=True)[1].reshape(-1)


def slot_finishes(names: list[str], v: Variation) -> list[Finish]:
    """Return a finish for each material slot by the name of its shader, equal ones for equal names."""
    kinds = [name.split(".")[0].removeprefix("shader_").removesuffix("_z") for name in names]
    known = {kind: finish_of(kind, v) for kind in dict.fromkeys(kinds)}
    return [known[kind] for kind in kinds]


def finish_of(kind: str, v: Variation) -> Finish:
    """Return a finish of our own for a kind of shader."""
    if "white" in kind:
        return p.paint(v, p.PALE)
    if "black" in kind:
        return p.paint(v, p.DARK)
    if "wood" in kind:
        return p.wood(v)
    if "metal" in kind:
        return p.metal(v)
    if "marble" in kind:
        return f.MARBLE
    if "glass" in kind or "translucent" in kind:
        return p.paint(v, p.GLASSES)
    if "leather" in kind:
        return p.leather(v)
    if "fabric" in kind or "velvet" in kind or "knit" in kind:
        return p.cloth(v)
    if "text" in kind:
        return p.label(v)
    if "vase" in kind:
        return p.speckle(v)
    if "ceramic" in kind:
        return p.paint(v, p.CERAMIC)
    if "lampshade" in kind or "plaster" in kind:
        return p.paint(v, p.PALE)
    return p.paint(v)
