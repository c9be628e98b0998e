"""One picture of one finger, with its truth."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from contact import Body, Dent, blurred, cubic_weights
from dots import Dot, draw_dot
from face import Face, Pose, RestShape
from finger import Blemish, Finger
from pencils import CELL_MM
from points import Pair, PairDent

KNOTS_ALONG = 90
REGION_MM = 0.1


@dataclass(frozen=True)
class Truth:
    """NaN off the face. depth along z where the pixel's point of the view face is; z of it; mm to the face's border."""

    depth_mm: np.ndarray
    border_mm: np.ndarray
    knots_u: np.ndarray
    knots_v: np.ndarray
    knot_z_mm: np.ndarray  # of the view face at every knot
    knot_normal_z: np.ndarray
    markers_px: np.ndarray  # (n, 2) engraved dots, upper row then lower, base to tip
    markers_shown: np.ndarray
    regions: list[dict[str, object]]


class Renderer:
    """Keeps what does not change from picture to picture."""

    def __init__(self, finger: Finger):
        self.finger = finger
        camera = finger.camera
        every = max(5, camera.width_px // KNOTS_ALONG)
        self._u = _knots(camera.width_px, every)
        self._v = _knots(camera.height_px, every)
        self._from_u = cubic_weights(camera.width_px, self._u).astype(np.float32)
        self._from_v = cubic_weights(camera.height_px, self._v).astype(np.float32)
        pixels = np.stack(np.meshgrid(self._u, self._v), axis=-1).astype(float)
        self._origins, self._lines = camera.sight_lines(pixels)
        u = (np.arange(camera.width_px) - camera.centre_px[0]) / camera.width_px
        v = (np.arange(camera.height_px) - camera.centre_px[1]) / camera.width_px
        radius = u[None, :] ** 2 + v[:, None] ** 2
        self._even: dict[bool, tuple[np.ndarray, np.ndarray, np.ndarray]] = {}
        self._lens = (1 - finger.vignetting * radius / radius.max()).astype(np.float32)

    def _full(self, knots: np.ndarray) -> np.ndarray:
        return self._from_v @ (knots.astype(np.float32) @ self._from_u.T)

    def light(
        self,
        pose: Pose,
        lamp_gains: np.ndarray | None = None,
        bodies: Sequence[Body] = (),
        hidden: frozenset[int] = frozenset(),
        with_truth: bool = False,
        pairs: Sequence[Pair] = (),
    ) -> tuple[np.ndarray, Truth | None]:
        """Grey levels before the sensor; hidden: indices of dots that something covers; pairs: no part of the truth."""
        finger, rest = self.finger, self.finger.rest
        face = Face(rest, pose)
        s_knots, w_knots = face.meet(self._origins, self._lines)
        half = rest.width_mm / 2
        on_face_light = finger.lamps.irradiance(
            face, np.clip(s_knots, 0, rest.length_mm), np.clip(w_knots, -half, half), lamp_gains
        )
        s, w, grey = self._full(s_knots), self._full(np.clip(w_knots, -4 * half, 4 * half)), self._full(on_face_light)
        per_px = _mm_per_px(s)
        cover = _cover(half - np.abs(w), _mm_per_px(w)) * _cover(s, per_px) * _cover(rest.length_mm - s, per_px)
        face_grey = grey * self._borders(s, w) if finger.scattering else grey
        for blemish in finger.blemishes:
            _blemish(face_grey, s, w, blemish)
        depth = np.zeros_like(s) if with_truth else None
        for body in bodies:
            self._press(Dent(face, finger.skin, body), body, s, w, face_grey, depth)
        for pair in pairs:
            self._press(PairDent(face, pair), pair, s, w, face_grey, None)
        picture = cover * face_grey + (1 - cover) * self._backdrop(grey, s, w)
        for number, dot in enumerate(finger.dots):
            if number not in hidden:
                draw_dot(picture, finger.camera, face, dot)
        truth = None
        if depth is not None:
            truth = self._truth(face, bodies, hidden, s, w, cover, depth, s_knots, w_knots)
        return picture * self._lens, truth

    def _backdrop(self, grey: np.ndarray, s: np.ndarray, w: np.ndarray) -> np.ndarray:
        backdrop, rest = self.finger.backdrop, self.finger.rest
        off = np.maximum(np.abs(w) - rest.width_mm / 2, 0)
        uneven = 1 + backdrop.wave * np.sin(0.23 * s + 0.2 * w)
        side = backdrop.side_share * grey * np.exp(-off / backdrop.side_fade_mm) * uneven + backdrop.floor_grey
        base = np.clip(-s / 1.5, 0, 1)
        tip = np.clip((s - rest.length_mm) / 0.6, 0, 1)
        return side * (1 - base) * (1 - tip) + backdrop.base_grey * base + backdrop.tip_grey * tip

    def _press(
        self,
        dent: Dent | PairDent,
        what: Body | Pair,
        s: np.ndarray,
        w: np.ndarray,
        grey: np.ndarray,
        depth: np.ndarray | None,
    ) -> None:
        finger, rest = self.finger, self.finger.rest
        reach = what.reach_mm() + 3.0
        near = (np.abs(s - what.s_mm) < reach * 1.5) & (np.abs(w - what.w_mm) < reach * 1.2)
        near &= (np.abs(w) < rest.width_mm / 2 + 0.6) & (s > -0.6) & (s < rest.length_mm + 0.6)
        rows, columns = np.flatnonzero(near.any(axis=1)), np.flatnonzero(near.any(axis=0))
        if not len(rows):
            return
        window = np.s_[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
        here = near[window]
        point = dent.face.point(s[window], w[window])
        here &= dent.reaches(point[..., 0], point[..., 1])
        thick = np.full(here.shape, rest.layer_mm)
        thick[here] = dent.thickness_at(s[window][here], w[window][here])
        share = self._scattered(s[window], w[window], dent) if finger.scattering else finger.layer.relative(thick)
        mm_per_px_v = float(np.median(np.abs(np.gradient(w[window], axis=0)))) if len(rows) > 1 else 0.1
        mm_per_px_u = float(np.median(np.abs(np.gradient(s[window], axis=1)))) if len(columns) > 1 else 0.1
        spread = finger.spread_mm
        grey[window] *= blurred(share, spread / max(mm_per_px_v, 1e-3), spread / max(mm_per_px_u, 1e-3))
        if depth is not None and isinstance(dent, Dent):
            part = np.zeros(here.shape)
            part[here] = dent.depth_at(point[here][:, 0], point[here][:, 1])
            depth[window] += part

    def _untouched(self, sideways: bool) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Brightness over that of an endless layer where nothing presses: places along and across, and the map."""
        rest, scattering = self.finger.rest, self.finger.scattering
        assert scattering is not None
        if sideways not in self._even:
            along, across = _grid(-0.2, rest.length_mm + 0.2), _grid(-rest.width_mm / 2 - 0.2, rest.width_mm / 2 + 0.2)
            thick = _framed(np.full((len(across), len(along)), rest.layer_mm), along, across, rest)
            shares = scattering.relative(along, across, thick, sideways)
            self._even[sideways] = along, across, _to_the_border(shares, along, across, rest)
        return self._even[sideways]

    def _borders(self, s: np.ndarray, w: np.ndarray) -> np.ndarray:
        """What scattered light loses beside the face's borders, as a share of an endless layer's. A line of sight that
        leans to a side meets the side face at some 70 degrees from its normal and is reflected back into the layer
        (silicone reflects all beyond 45 degrees): it does not leave there."""
        return _looked_up(*self._untouched(sideways=False), s, w)

    def _scattered(self, s: np.ndarray, w: np.ndarray, dent: Dent | PairDent) -> np.ndarray:
        """Brightness of the pressed face over the untouched one."""
        rest, scattering = self.finger.rest, self.finger.scattering
        assert scattering is not None
        along, across = _grid(s.min() - 1, s.max() + 1), _grid(w.min() - 1, w.max() + 1)
        s_grid, w_grid = np.meshgrid(along, across)
        thick = np.full(s_grid.shape, rest.layer_mm)
        point = dent.face.point(s_grid, w_grid)
        here = dent.reaches(point[..., 0], point[..., 1])
        thick[here] = dent.thickness_at(s_grid[here], w_grid[here])
        pressed = scattering.relative(along, across, _framed(thick, along, across, rest), sideways=True)
        all_along, all_across, untouched = self._untouched(sideways=True)
        columns = np.clip(np.rint((along - all_along[0]) / CELL_MM).astype(int), 0, len(all_along) - 1)
        rows = np.clip(np.rint((across - all_across[0]) / CELL_MM).astype(int), 0, len(all_across) - 1)
        before = np.maximum(untouched[np.ix_(rows, columns)], 1e-3)
        return _looked_up(along, across, _to_the_border(pressed / before, along, across, rest), s, w)

    def _truth(
        self,
        face: Face,
        bodies: Sequence[Body],
        hidden: frozenset[int],
        s: np.ndarray,
        w: np.ndarray,
        cover: np.ndarray,
        depth: np.ndarray,
        s_knots: np.ndarray,
        w_knots: np.ndarray,
    ) -> Truth:
        finger, rest = self.finger, self.finger.rest
        border = np.minimum(np.minimum(rest.width_mm / 2 - np.abs(w), rest.length_mm - s), s)
        on_face = cover >= 0.5
        off_knots = (np.abs(w_knots) > rest.width_mm / 2) | (s_knots < 0) | (s_knots > rest.length_mm)
        knot_z = np.where(off_knots, np.nan, face.point(s_knots, w_knots)[..., 2])
        dots = [(i, dot) for i, dot in enumerate(finger.dots) if dot.engraved]
        dots.sort(key=lambda entry: (entry[1].side, entry[1].s_mm))
        places = np.array([dot.pixel(finger.camera, face) for _, dot in dots]).reshape(-1, 2)
        shown = [i not in hidden and _is_inside(finger, place) for (i, _), place in zip(dots, places)]
        return Truth(
            np.where(on_face, depth, np.nan).astype(np.float32),
            np.where(on_face, border, np.nan).astype(np.float32),
            self._u,
            self._v,
            knot_z,
            face.normal_at(s_knots)[..., 2],
            places,
            np.array(shown, bool),
            _regions(face, depth, on_face, s, w) if bodies else [],
        )


def _regions(
    face: Face, depth: np.ndarray, on_face: np.ndarray, s: np.ndarray, w: np.ndarray
) -> list[dict[str, object]]:
    """What is pressed by more than REGION_MM, in one piece each: centre of the displaced volume on the pressed face."""
    pressed = (on_face & (depth > REGION_MM)).astype(np.uint8)
    count, labels = cv2.connectedComponents(pressed, connectivity=8)
    ground = face.point(s, w)
    (xv, xu), (yv, yu) = np.gradient(ground[..., 0]), np.gradient(ground[..., 1])
    area = np.abs(xu * yv - xv * yu)  # of a pixel, seen along z
    regions: list[dict[str, object]] = []
    for label in range(1, count):
        here = labels == label
        point = ground[here]
        point[:, 2] += face.rest.layer_mm / face.normal_at(s[here])[:, 2] - depth[here]
        regions.append(
            {
                "place_mm": np.average(point, axis=0, weights=(depth * area)[here]).tolist(),
                "deepest_mm": float(depth[here].max()),
                "pixels": int(here.sum()),
            }
        )
    return regions


def _is_inside(finger: Finger, place: np.ndarray) -> bool:
    return bool(2 < place[0] < finger.camera.width_px - 3 and 2 < place[1] < finger.camera.height_px - 3)


def _grid(low: float, high: float) -> np.ndarray:
    return np.arange(np.floor(low / CELL_MM), np.ceil(high / CELL_MM) + 1) * CELL_MM


def _framed(thick: np.ndarray, along: np.ndarray, across: np.ndarray, rest: RestShape) -> np.ndarray:
    """No layer beyond the borders: light is lost there."""
    on_face = (np.abs(across) <= rest.width_mm / 2)[:, None] & ((along >= 0) & (along <= rest.length_mm))[None, :]
    return np.where(on_face, thick, 0.0)


def _to_the_border(table: np.ndarray, along: np.ndarray, across: np.ndarray, rest: RestShape) -> np.ndarray:
    """Beyond the borders the last cell of the face, so that what is looked up between cells goes on up to the border."""
    columns = np.clip(np.arange(len(along)), *_first_and_last((along >= 0) & (along <= rest.length_mm)))
    rows = np.clip(np.arange(len(across)), *_first_and_last(np.abs(across) <= rest.width_mm / 2))
    return table[np.ix_(rows, columns)]


def _first_and_last(inside: np.ndarray) -> tuple[int, int]:
    where = np.flatnonzero(inside)
    return (int(where[0]), int(where[-1])) if len(where) else (0, len(inside) - 1)


def _looked_up(along: np.ndarray, across: np.ndarray, table: np.ndarray, s: np.ndarray, w: np.ndarray) -> np.ndarray:
    column, row = (s - along[0]) / CELL_MM, (w - across[0]) / CELL_MM
    return cv2.remap(
        table.astype(np.float32),
        column.astype(np.float32),
        row.astype(np.float32),
        cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_REPLICATE,
    )


def _knots(count: int, every: int) -> np.ndarray:
    knots = np.arange(0, count, every)
    return knots if knots[-1] == count - 1 else np.append(knots, count - 1)


def _cover(inside_mm: np.ndarray, mm_per_px: np.ndarray) -> np.ndarray:
    """Part of each pixel on the inner side of an edge, from the signed distance in mm."""
    return np.minimum(np.maximum(inside_mm / mm_per_px + 0.5, 0), 1)


def _mm_per_px(values: np.ndarray) -> np.ndarray:
    down, right = np.gradient(values)
    return np.maximum(np.sqrt(down * down + right * right), 1e-6)


def _blemish(grey: np.ndarray, s: np.ndarray, w: np.ndarray, blemish: Blemish) -> None:
    reach = 1.5 * max(blemish.half_length_mm, blemish.half_width_mm) + 0.2
    near = (np.abs(s - blemish.s_mm) < reach) & (np.abs(w - blemish.w_mm) < reach)
    cosine, sine = np.cos(blemish.turn_rad), np.sin(blemish.turn_rad)
    along, across = s[near] - blemish.s_mm, w[near] - blemish.w_mm
    first = (cosine * along + sine * across) / blemish.half_length_mm
    second = (cosine * across - sine * along) / blemish.half_width_mm
    grey[near] *= 1 + blemish.strength * np.exp(-((first**2 + second**2) ** 2))
