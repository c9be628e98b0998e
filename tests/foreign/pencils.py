"""Light that comes back beside where it went in: lines of sight followed through the whole layer.

A path of light may be walked from either end. A pencil of sight enters the layer from the view face, is scattered again
and again, and collects at each vertex what the lamps send there; whatever lies beyond the outer side is black. So a path
counts up to its first vertex that lies outside: beyond the outer side where a body has pushed it in, or beyond the
face's borders. One set of paths, walked for an endless even layer and kept, gives the picture of any dent.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

CELL_MM = 0.1
MAX_VERTICES = 30


@dataclass(frozen=True)
class Pencil:
    """Paths of one angle of sight and of light: where their vertices lie, and what each collects."""

    place_mm: np.ndarray  # (paths, vertices, 3): along, across, depth in the layer; depth inf where a path has ended
    collected: np.ndarray  # (paths, vertices)
    launched: int

    @staticmethod
    def walk(
        rng: np.random.Generator,
        scatter_per_mm: float,
        absorb_per_mm: float,
        sight: np.ndarray,  # unit vectors: along, across, into the layer
        light: np.ndarray,
        reach_mm: float,
        paths: int,
    ) -> Pencil:
        """scatter_per_mm: reduced, isotropic. reach_mm: the thickest the layer may be."""
        total = scatter_per_mm + absorb_per_mm
        albedo = scatter_per_mm / total
        # The first flight is drawn among those that end within the layer.
        first = total * reach_mm / sight[2]
        inside = -np.expm1(-first)
        flight = -np.log1p(-rng.random(paths) * inside) / total
        place = flight[:, None] * sight[None, :]
        weight = np.full(paths, inside * albedo)
        places = np.full((paths, MAX_VERTICES, 3), np.inf)
        collected = np.zeros((paths, MAX_VERTICES))
        alive = np.arange(paths)
        for vertex in range(MAX_VERTICES):
            places[alive, vertex] = place[alive]
            collected[alive, vertex] = weight[alive] * np.exp(-total * place[alive, 2] / light[2])
            direction = rng.standard_normal((paths, 3))
            direction /= np.linalg.norm(direction, axis=1, keepdims=True)
            place = place + rng.exponential(1 / total, paths)[:, None] * direction
            weight = weight * albedo
            alive = alive[(place[alive, 2] > 0) & (place[alive, 2] < reach_mm)]
        return Pencil(places, collected, paths)

    def even(self, thickness_mm: float) -> float:
        """What an endless even layer gives."""
        inside = np.logical_and.accumulate(self.place_mm[..., 2] < thickness_mm, axis=1)
        return float((self.collected * inside).sum() / self.launched)

    def over(self, thick_mm: np.ndarray) -> np.ndarray:
        """The same at every cell of a map of thickness (rows across, columns along; CELL_MM; 0 where the face ends);
        beyond the map it goes on as at its border."""
        offsets = np.zeros(self.place_mm.shape[:2] + (2,), int)
        ended = ~np.isfinite(self.place_mm[..., 2])
        offsets[~ended] = np.rint(self.place_mm[..., :2][~ended] / CELL_MM).astype(int)
        around = 60
        offsets = np.clip(offsets, -around, around)
        wide = np.pad(thick_mm.astype(np.float32), around, mode="edge")
        rows, columns = thick_mm.shape
        total = np.zeros(thick_mm.shape, np.float32)
        for path in range(self.launched):
            inside = None
            for vertex in range(MAX_VERTICES):
                if ended[path, vertex]:
                    break
                right, down = offsets[path, vertex]
                here = wide[around + down : around + down + rows, around + right : around + right + columns]
                passes = here > np.float32(self.place_mm[path, vertex, 2])
                inside = passes if inside is None else inside & passes
                total += inside * np.float32(self.collected[path, vertex])
        return total / self.launched


class ScatteringLayer:
    """Pencils at places along a finger, whose angles change from base to tip."""

    def __init__(
        self,
        rng: np.random.Generator,
        scatter_per_mm: float,
        absorb_per_mm: float,
        layer_mm: float,
        places_mm: np.ndarray,  # along, rising
        sights: np.ndarray,  # (n, 3)
        lights: np.ndarray,
        paths: int = 1500,
    ):
        self.layer_mm, self.places_mm = layer_mm, places_mm
        seed = int(rng.integers(1 << 40))  # the same draws at all places, so that nothing but angles differs
        self._pencils = [
            Pencil.walk(np.random.default_rng(seed), scatter_per_mm, absorb_per_mm, sight, light, 1.3 * layer_mm, paths)
            for sight, light in zip(sights, lights)
        ]
        self._even = [pencil.even(layer_mm) for pencil in self._pencils]

    def relative(self, s_mm: np.ndarray, thick_mm: np.ndarray) -> np.ndarray:
        """Brightness over that of an endless untouched layer, on a map whose columns lie at s_mm."""
        place = np.interp(s_mm, self.places_mm, np.arange(len(self.places_mm)))
        low = np.minimum(place.astype(int), len(self.places_mm) - 2)
        share = place - low
        result = np.zeros(thick_mm.shape, np.float32)
        for number in sorted(set(low) | set(low + 1)):
            weight = np.where(low == number, 1 - share, 0) + np.where(low + 1 == number, share, 0)
            result += weight[None, :].astype(np.float32) * (self._pencils[number].over(thick_mm) / self._even[number])
        return result
