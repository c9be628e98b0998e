"""How bright the translucent layer looks at a thickness: light walked through it, photon by photon.

The layer scatters and absorbs; behind it all is black, before it the clear silicone has the same index, so that nothing
is reflected at that side. A photon that comes back without ever having been deeper than T comes back from a layer of
thickness T as well, whatever lies deeper: one walk through an endless layer, which remembers how deep each photon was,
gives the brightness for every thickness at once, and rising with T by construction.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Walk:
    """Photons that came back: how deep they were, what was left of each, how far aside they came out."""

    deepest_mm: np.ndarray
    weight: np.ndarray
    aside_mm: np.ndarray
    launched: int
    absorbed: float  # weight left in the layer or behind it
    behind: float

    def reflected(self, thickness_mm: float) -> float:
        return float(self.weight[self.deepest_mm < thickness_mm].sum() / self.launched)


def walk(
    rng: np.random.Generator,
    scatter_per_mm: float,
    absorb_per_mm: float,
    forwardness: float,
    incidence_cosine: float,
    photons: int = 120_000,
    bottom_mm: float = 4.0,
) -> Walk:
    """scatter_per_mm: reduced; forwardness: mean cosine g of Henyey and Greenstein. Photons enter at one angle."""
    scatter = scatter_per_mm / (1 - forwardness)
    total = scatter + absorb_per_mm
    albedo = scatter / total
    depth = np.zeros(photons)
    deepest = np.zeros(photons)
    aside = np.zeros((photons, 2))
    weight = np.ones(photons)
    sine = np.sqrt(1 - incidence_cosine**2)
    direction = np.tile([sine, 0.0, incidence_cosine], (photons, 1))
    back: list[tuple[np.ndarray, np.ndarray, np.ndarray]] = []
    absorbed = behind = 0.0
    while len(depth):
        step = rng.exponential(1 / total, len(depth))
        after = depth + step * direction[:, 2]
        out = after < 0
        # Where a photon leaves, it goes only as far as the surface.
        shortened = np.where(out, depth / np.maximum(-direction[:, 2], 1e-12), step)
        aside = aside + shortened[:, None] * direction[:, :2]
        if out.any():
            back.append((deepest[out], weight[out], np.hypot(*aside[out].T)))
        lost = after > bottom_mm
        behind += float(weight[lost].sum())
        stay = ~(out | lost)
        depth, aside, direction, weight = after[stay], aside[stay], direction[stay], weight[stay]
        deepest = np.maximum(deepest[stay], depth)
        absorbed += float(weight.sum()) * (1 - albedo)
        weight = weight * albedo
        # Russian roulette keeps the mean and ends long walks.
        faint = weight < 0.02
        survives = rng.random(len(weight)) < 0.2
        absorbed += float(weight[faint].sum() - 5 * weight[faint & survives].sum())
        weight = np.where(faint, 5 * weight, weight)
        keep = ~faint | survives
        depth, aside, direction, weight, deepest = (v[keep] for v in (depth, aside, direction, weight, deepest))
        direction = _turned(rng, direction, forwardness)
    deep, left, far = (np.concatenate(column) for column in zip(*back))
    return Walk(deep, left, far, photons, absorbed, behind)


def _turned(rng: np.random.Generator, direction: np.ndarray, g: float) -> np.ndarray:
    count = len(direction)
    drawn = rng.random(count)
    if abs(g) < 1e-3:
        cosine = 2 * drawn - 1
    else:
        cosine = (1 + g * g - ((1 - g * g) / (1 - g + 2 * g * drawn)) ** 2) / (2 * g)
    sine = np.sqrt(np.maximum(0, 1 - cosine**2))
    around = rng.uniform(0, 2 * np.pi, count)
    helper = np.where(np.abs(direction[:, 2:3]) < 0.9, [[0.0, 0.0, 1.0]], [[1.0, 0.0, 0.0]])
    first = np.cross(direction, helper)
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    second = np.cross(direction, first)
    turned = (
        first * (sine * np.cos(around))[:, None]
        + second * (sine * np.sin(around))[:, None]
        + direction * cosine[:, None]
    )
    return turned / np.linalg.norm(turned, axis=1, keepdims=True)


class Layer:
    """Brightness over thickness, relative to the untouched layer's, and how far light spreads aside."""

    def __init__(self, photons: Walk, thickness_mm: float):
        reach = 1.35 * thickness_mm
        self._table_mm = np.linspace(0, reach, 400)
        counts, _ = np.histogram(photons.deepest_mm, bins=self._table_mm, weights=photons.weight)
        rising = np.concatenate([[0.0], np.cumsum(counts)]) / photons.launched
        # A smooth law through the counted one: powers of T / (T + t), none of order zero since a layer of no thickness
        # sends nothing back.
        share = self._table_mm / (self._table_mm + thickness_mm)
        powers = np.stack([share**k for k in range(1, 8)], axis=1)
        law = np.linalg.lstsq(powers, rising, rcond=None)[0]
        smooth = powers @ law
        self.misfit = float(np.abs(smooth - rising).max() / rising[-1])
        self._relative = np.maximum.accumulate(smooth) / np.interp(thickness_mm, self._table_mm, smooth)
        near = photons.deepest_mm < thickness_mm
        self.aside_mm = float(np.sqrt(np.average(photons.aside_mm[near] ** 2, weights=photons.weight[near])))

    def relative(self, thickness_mm: np.ndarray) -> np.ndarray:
        """1 at the untouched layer's thickness."""
        return np.interp(thickness_mm, self._table_mm, self._relative)
