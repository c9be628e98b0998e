"""Light that comes back beside where it went in: lines of sight followed through the whole layer.

A path of light may be walked from either end. A pencil of sight enters the layer from the view face, is scattered
again and again, and collects at each vertex what the lamps send there; whatever lies beyond the outer side is black.
So a path counts up to its first vertex that lies outside: beyond the outer side where a body has pushed it in, or
beyond the face's borders. Paths, walked for an endless even layer and kept, give the picture of any dent.

A thousand paths leave a dent of a tenth of the layer 10 % too bright or too dark; if all cells shared them, all dents
of a finger would be so. Neighbouring cells have paths of their own, so that what a thousand leave is grain.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

CELL_MM = 0.1
MAX_VERTICES = 30
PATTERN = 12  # cells: paths of their own for each of the cells of a square of this side
SETS = PATTERN * PATTERN
ALL = (slice(None), slice(None))
AROUND = 60  # cells: paths go no further aside


class Paths:
    """Vertices of some paths, path by path and in their order; depths in the layer."""

    def __init__(self, path: np.ndarray, place_mm: np.ndarray, collected: np.ndarray):
        first = np.flatnonzero(np.diff(path, prepend=-1))
        self._path, self._depth_mm = path, place_mm[:, 2].astype(np.float32)
        self._aside = np.clip(np.rint(place_mm[:, :2] / CELL_MM), -AROUND, AROUND).astype(np.intp)
        sums = np.cumsum(collected)
        ends = np.append(first[1:], len(path)) - 1
        which = np.repeat(np.arange(len(first)), ends - first + 1)
        self._rest = (sums[ends][which] - sums + collected).astype(np.float32)  # from a vertex to its path's end
        self._all = float(collected.sum())

    def _beyond(self, thickness_mm: float) -> list[np.ndarray]:
        """Vertices at or below a depth: the first one of each path, the second one, and so on; paths of many first."""
        beyond = np.flatnonzero(self._depth_mm >= thickness_mm)
        if not len(beyond):
            return []
        first = np.flatnonzero(np.diff(self._path[beyond], prepend=-1))
        counts = np.diff(np.append(first, len(beyond)))
        order = np.argsort(-counts, kind="stable")
        first, counts = first[order], counts[order]
        return [beyond[first[counts > nth] + nth] for nth in range(counts[0])]

    def even(self, thickness_mm: float) -> float:
        """The sum over all paths in an endless even layer."""
        beyond = self._beyond(thickness_mm)
        return self._all - (float(self._rest[beyond[0]].sum()) if beyond else 0.0)

    def over(self, wide_mm: np.ndarray, rows: np.ndarray, columns: np.ndarray) -> np.ndarray:
        """The same at cells of a map of thickness."""
        beyond = self._beyond(float(wide_mm.min()))
        if not beyond:
            return np.full((len(rows), len(columns)), self._all)
        cells = (rows[:, None] * wide_mm.shape[1] + columns[None, :]).reshape(-1)
        flat, lost = wide_mm.reshape(-1), np.zeros(len(cells))
        at_once = max(16, 100_000 // len(beyond[0]))  # stays in the processor's cache
        for begin in range(0, len(cells), at_once):
            part = cells[begin : begin + at_once]
            most = np.zeros((len(beyond[0]), len(part)), np.float32)  # what a path loses: from its first vertex outside
            for nth in beyond:
                offsets = self._aside[nth, 1] * wide_mm.shape[1] + self._aside[nth, 0]
                here = np.take(flat, offsets[:, None] + part[None, :], mode="clip")
                loses = (here <= self._depth_mm[nth, None]) * self._rest[nth, None]
                np.maximum(most[: len(nth)], loses, out=most[: len(nth)])
            lost[begin : begin + at_once] = most.sum(axis=0)
        return (self._all - lost).reshape(len(rows), len(columns))


class Pencil:
    """Paths of one angle of sight and of light."""

    def __init__(self, sets: list[Paths], launched: int):
        self._sets, self._launched = sets, launched

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
        """scatter_per_mm: reduced, isotropic. reach_mm: the thickest the layer may be. paths: of all cells together."""
        total = scatter_per_mm + absorb_per_mm
        albedo = scatter_per_mm / total
        # The first flight is drawn among those that end within the layer.
        first = total * reach_mm / sight[2]
        inside = -np.expm1(-first)
        flight = -np.log1p(-rng.random(paths) * inside) / total
        place = flight[:, None] * sight[None, :]
        weight = inside * albedo
        alive = np.arange(paths)
        walked = []
        for _ in range(MAX_VERTICES):
            walked.append((alive, place, weight * np.exp(-total * place[:, 2] / light[2])))
            direction = rng.standard_normal((len(alive), 3))
            direction /= np.linalg.norm(direction, axis=1, keepdims=True)
            place = place + rng.exponential(1 / total, len(alive))[:, None] * direction
            weight = weight * albedo
            within = (place[:, 2] > 0) & (place[:, 2] < reach_mm)
            alive, place = alive[within], place[within]
        path, places, collected = (np.concatenate(column) for column in zip(*walked))
        order = np.lexsort((path, path % SETS))  # stable: a path's vertices stay in their order
        path, places, collected = path[order], places[order], collected[order]
        begins = np.searchsorted(path % SETS, np.arange(SETS + 1))
        return Pencil([Paths(path[i:j], places[i:j], collected[i:j]) for i, j in zip(begins, begins[1:])], paths)

    def even(self, thickness_mm: float) -> float:
        """What an endless even layer gives."""
        return sum(paths.even(thickness_mm) for paths in self._sets) / self._launched

    def relative(
        self, thick_mm: np.ndarray, even_mm: float, row: int = 0, column: int = 0, part: tuple[slice, slice] = ALL
    ) -> np.ndarray:
        """Brightness at every cell of a map of thickness over that of an endless even layer. The map: rows across,
        columns along; CELL_MM; 0 where the face ends; beyond it goes on as at its border. row, column: of the map's
        first cell on the face, so that a cell has the same paths in every map. part: rows and columns that are asked
        for; the others are 0."""
        wide = np.pad(thick_mm.astype(np.float32), AROUND, mode="edge")
        result = np.zeros(thick_mm.shape, np.float32)
        all_rows, all_columns = (np.arange(size)[which] for size, which in zip(thick_mm.shape, part))
        for number, paths in enumerate(self._sets):
            rows = all_rows[(all_rows + row) % PATTERN == number // PATTERN]
            columns = all_columns[(all_columns + column) % PATTERN == number % PATTERN]
            if len(rows) and len(columns):
                seen = paths.over(wide, rows + AROUND, columns + AROUND)
                result[np.ix_(rows, columns)] = seen / paths.even(even_mm)
        return result


class ScatteringLayer:
    """Pencils at places along a finger and across it, as angles change from base to tip and from side to side."""

    def __init__(
        self,
        rng: np.random.Generator,
        scatter_per_mm: float,
        absorb_per_mm: float,
        layer_mm: float,
        along_mm: np.ndarray,  # places, rising
        across_mm: np.ndarray,
        sights: np.ndarray,  # (along, across, 3)
        lights: np.ndarray,
        paths: int = 700 * SETS,
    ):
        self.layer_mm, self._along_mm, self._across_mm = layer_mm, along_mm, across_mm
        seed = int(rng.integers(1 << 40))  # the same draws at all places, so that nothing but angles differs
        walk = lambda *angles: Pencil.walk(  # noqa: E731
            np.random.default_rng(seed), scatter_per_mm, absorb_per_mm, *angles, 1.3 * layer_mm, paths
        )
        self._pencils = [list(map(walk, *row)) for row in zip(sights, lights)]

    def relative(
        self, along_mm: np.ndarray, across_mm: np.ndarray, thick_mm: np.ndarray, sideways: bool
    ) -> np.ndarray:
        """Brightness over that of an endless untouched layer, on a map whose columns and rows lie at these places.
        sideways: sight and light lean to the sides as well, as they do."""
        first = [round(float(places[0]) / CELL_MM) for places in (across_mm, along_mm)]
        of_columns = _shares(along_mm, self._along_mm)
        of_rows = _shares(across_mm if sideways else np.zeros_like(across_mm), self._across_mm)
        result = np.zeros(thick_mm.shape, np.float32)
        for pencils, by_column in zip(self._pencils, of_columns):
            for pencil, by_row in zip(pencils, of_rows):
                columns, rows = np.flatnonzero(by_column), np.flatnonzero(by_row)
                if len(columns) and len(rows):
                    part = slice(rows[0], rows[-1] + 1), slice(columns[0], columns[-1] + 1)
                    seen = pencil.relative(thick_mm, self.layer_mm, *first, part)
                    result += np.outer(by_row, by_column).astype(np.float32) * seen
        return result


def _shares(at_mm: np.ndarray, places_mm: np.ndarray) -> np.ndarray:
    """Weights (places, at) of a straight line between two places."""
    return np.stack([np.interp(at_mm, places_mm, one) for one in np.eye(len(places_mm))])
