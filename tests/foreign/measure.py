"""What the program measured on one finger, held against the truth."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import cv2
import numpy as np

from points import dip, parted_from_mm
from program import Run

PRESSED_MM = 0.1  # what counts as inside a contact
UNTOUCHED_MM = 0.004
BORDER_MM = 2.0
NEEDED_REGION_MM = 0.2  # shallower or smaller regions may be found or not
NEEDED_REGION_PX = 40
REGION_MM = 1.0
MARKER_PX = 4.0
BAND_SDS = 1.96
HALO_PX = 30.0  # of an image 960 px wide: some 2 mm


def measure(run: Run, made: Path, facts: dict[str, Any]) -> dict[str, Any]:
    """Figures of one finger; absent where there is nothing to tell them from."""
    sums = _Sums()
    frames = []
    for shot in facts["shots"]:
        frames.append(_measure_shot(run, made, shot, facts, sums))
    figures = sums.figures()
    figures |= _resolution(run, facts)
    figures["frames"] = frames
    figures["depth_frames"] = sum(frame["has_depth"] for frame in frames)
    judged = [frame for frame in frames if frame["what"] != "steep"]
    figures["regions_right"] = sum(frame["regions_right"] for frame in judged)
    figures["regions_frames"] = len(judged)
    promised = run.calibration.get("expected_error_mm")
    if promised is not None:
        figures["promised_mm"] = promised
        if figures.get("contact_mm"):
            figures["promise_ratio"] = promised / figures["contact_mm"]
    return figures


class _Sums:
    """Pixels of all pictures of a finger, pooled."""

    def __init__(self) -> None:
        self.inner: list[np.ndarray] = []  # rows: measured, true, sd
        self.rim: list[np.ndarray] = []
        self.steep: list[np.ndarray] = []
        self.rim_pixels = self.inner_pixels = 0
        self.off_face: list[int] = []
        self.free: list[np.ndarray] = []
        self.halo: list[np.ndarray] = []
        self.places: list[tuple[float, float, float]] = []
        self.free_share: list[float] = []
        self.shape: list[np.ndarray] = []
        self.tilt: list[np.ndarray] = []
        self.markers: list[float] = []
        self.markers_true = self.markers_found = self.markers_wrong = 0

    def figures(self) -> dict[str, Any]:
        figures: dict[str, Any] = {}
        inner, rim, steep = (_joined(parts) for parts in (self.inner, self.rim, self.steep))
        if inner.shape[1]:
            off = inner[0] - inner[1]
            figures["contact_mm"] = float(np.abs(off).mean())
            figures["contact_bias_mm"] = float(off.mean())
            figures["scale"] = float((inner[0] * inner[1]).sum() / (inner[1] ** 2).sum())
            sure = np.isfinite(inner[2]) & (inner[2] > 0)
            if sure.any():
                parts = np.abs(off[sure] / inner[2][sure])
                figures["z_squared"] = float((parts**2).mean())
                figures["band"] = float((parts <= BAND_SDS).mean())
        if self.inner_pixels:
            figures["contact_coverage"] = inner.shape[1] / self.inner_pixels
        if rim.shape[1]:
            figures["rim_mm"] = float(np.abs(rim[0] - rim[1]).mean())
        if self.rim_pixels:
            figures["rim_coverage"] = rim.shape[1] / self.rim_pixels
        if steep.shape[1]:
            figures["steep_mm"] = float(np.abs(steep[0] - steep[1]).mean())
        if self.free:
            figures["false_mm"] = float(np.abs(np.concatenate(self.free)).mean())
        if self.halo:
            halo = np.concatenate(self.halo)
            if len(halo):
                figures["halo_mm"] = float(halo.mean())
        if self.places:
            along, across, squared = np.array(self.places).T
            figures["place_mm"] = float(np.hypot(along, across).mean())
            figures["along_mm"] = float(along.mean())
            figures["place_z_squared"] = float(squared.mean())
        if self.off_face:
            figures["off_face_px"] = float(np.mean(self.off_face))
        if self.free_share:
            figures["free_coverage"] = float(np.mean(self.free_share))
        if self.shape:
            off = np.abs(np.concatenate(self.shape))
            figures["shape_mm"] = float(off.mean())
            figures["shape_p95_mm"] = float(np.percentile(off, 95))
        if self.tilt:
            figures["tilt_deg"] = float(np.abs(np.concatenate(self.tilt)).mean())
        if self.markers:
            figures["marker_px"] = float(np.mean(self.markers))
        if self.markers_true:
            figures["markers_found"] = self.markers_found / self.markers_true
            figures["markers_wrong"] = self.markers_wrong
        return figures


def _joined(parts: list[np.ndarray]) -> np.ndarray:
    return np.concatenate(parts, axis=1) if parts else np.zeros((3, 0))


def _measure_shot(
    run: Run, made: Path, shot: dict[str, Any], facts: dict[str, Any], sums: _Sums
) -> dict[str, Any]:
    name, what = shot["name"], shot["what"]
    truth = np.load(made / "truth" / f"{name}.npz")
    line = run.lines.get(name, {})
    depth = _picture(run.results / f"{name}.depth.tiff")
    frame: dict[str, Any] = {"name": name, "what": what, "has_depth": depth is not None}
    frame["problems"] = line.get("problems", [])
    true_depth = truth["depth_mm"]
    if depth is None:
        depth = np.full_like(true_depth, np.nan)
    if "markers" in line:
        _add_markers(line["markers"], truth, facts, sums)
    sd = _picture(run.results / f"{name}.depth_sd.tiff")
    _add_depth(depth, sd, true_depth, truth["border_mm20"] / 20.0, what, sums, frame)
    points = _picture(run.results / f"{name}.points.tiff")
    if points is not None:
        _add_shape(points, depth, truth, facts["layer_mm"], sums, frame)
    frame["regions_right"], frame["regions"] = _regions_right(line, shot["regions"], _shape_of(shot))
    if frame["regions_right"] and what == "inside" and _shape_of(shot) != "thread":
        _add_places(line, shot["regions"], sums)
    return frame


def _shape_of(shot: dict[str, Any]) -> str:
    return shot["bodies"][0]["shape"] if shot["bodies"] else ""


def _add_places(line: dict[str, Any], regions: list[dict[str, Any]], sums: _Sums) -> None:
    """Off the true place in the face: what lies along its normal is shape and depth. Along is what is not across, and
    positive away from the camera."""
    for region in regions:
        found = [r for r in line["regions"] if np.linalg.norm(np.subtract(r["place_mm"], region["place_mm"])) < REGION_MM]
        if len(found) != 1 or "normal" not in found[0] or "place_covariance_mm2" not in found[0]:
            continue
        normal = np.array(found[0]["normal"])
        along = np.array([0.0, 0.0, 1.0]) - normal[2] * normal
        along /= np.linalg.norm(along)
        face = np.stack([along, np.cross(normal, along)])
        off = face @ np.subtract(found[0]["place_mm"], region["place_mm"])
        xx, xy, xz, yy, yz, zz = found[0]["place_covariance_mm2"]
        covariance = face @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ face.T
        sums.places.append((*off, float(off @ np.linalg.solve(covariance, off)) / 2))


def _resolution(run: Run, facts: dict[str, Any]) -> dict[str, Any]:
    """Told over measured distance of two points seen apart, at the worst direction of each press."""
    told = {p["press"]: p["two_points_mm"] for p in (run.calibration.get("resolution") or {}).get("presses", [])}
    quotients, measured = [], []
    for press in dict.fromkeys(pair["press"] for pair in facts.get("pairs", [])):
        name = next((name for name in told if Path(name).stem == press), None)
        parted = []
        for is_along in (True, False):
            chosen = [p for p in facts["pairs"] if p["press"] == press and p["is_along"] == is_along]
            dips = []
            for pair in chosen:
                depth = _picture(run.points / f"{pair['name']}.depth.tiff")
                dips.append(float("nan") if depth is None else dip(depth, *np.array(pair["places_px"])))
            parted.append(parted_from_mm(np.array([p["distance_mm"] for p in chosen]), np.array(dips)))
        if name is not None and np.isfinite(parted).all():
            quotients.append(told[name] / max(parted))
            measured.append(max(parted))
    if not quotients:
        return {}
    return {"resolution_ratio": float(np.mean(quotients)), "two_points_mm": float(np.mean(measured))}


def _picture(path: Path) -> np.ndarray | None:
    if not path.exists():
        return None
    picture = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    return picture


def _add_depth(
    depth: np.ndarray,
    sd: np.ndarray | None,
    true_depth: np.ndarray,
    border: np.ndarray,
    what: str,
    sums: _Sums,
    frame: dict[str, Any],
) -> None:
    if sd is None:
        sd = np.full_like(depth, np.nan)
    measured = np.isfinite(depth)
    on_face = np.isfinite(true_depth)
    pressed = on_face & (np.nan_to_num(true_depth) > PRESSED_MM)
    inner, rim = pressed & (border >= BORDER_MM), pressed & (border < BORDER_MM)
    both = lambda where: np.stack([depth[where], true_depth[where], sd[where]]).astype(float)  # noqa: E731
    if what == "steep":
        sums.steep.append(both(inner & measured))
    else:
        sums.inner.append(both(inner & measured))
        sums.rim.append(both(rim & measured))
        sums.inner_pixels += int(inner.sum())
        sums.rim_pixels += int(rim.sum())
    free = on_face & (np.nan_to_num(true_depth, nan=1.0) < UNTOUCHED_MM)
    if pressed.any():
        sums.halo.append(depth[free & measured & _near(pressed)].astype(float))
    sums.free.append(depth[free & measured].astype(float))
    if free.any():
        sums.free_share.append(float((free & measured).sum() / free.sum()))
    if (pressed & measured).any():
        frame["error_mm"] = float(np.abs(depth - true_depth)[pressed & measured].mean())
        frame["coverage"] = float((pressed & measured).sum() / pressed.sum())
    if (free & measured).any():
        frame["false_mm"] = float(np.abs(depth[free & measured]).mean())
    sums.off_face.append(int((measured & ~on_face).sum()))


def _near(pressed: np.ndarray) -> np.ndarray:
    """Within HALO_PX of what is pressed."""
    away = cv2.distanceTransform((~pressed).astype(np.uint8), cv2.DIST_L2, 5)
    return away <= HALO_PX * pressed.shape[1] / 960


def _add_shape(
    points: np.ndarray,
    depth: np.ndarray,
    truth: Any,
    layer_mm: float,
    sums: _Sums,
    frame: dict[str, Any],
) -> None:
    """The untouched outer side under each knot, along z: of a point, its view face plus the layer along z."""
    u, v = np.meshgrid(truth["knots_u"], truth["knots_v"])
    true_z = truth["knot_z_mm"] + layer_mm / truth["knot_normal_z"]
    z = points[v, u, 2] + depth[v, u]
    known = np.isfinite(z) & np.isfinite(true_z)
    if not known.any():
        return
    sums.shape.append((z - true_z)[known].astype(float))
    frame["shape_mm"] = float(np.abs(z - true_z)[known].mean())
    # Tilt across the face: z against y, by columns of knots.
    y = points[v, u, 1]
    tilts = []
    for column in range(z.shape[1]):
        here = known[:, column]
        if here.sum() >= 6:
            across = y[here, column]
            off = np.polyfit(across, (z - true_z)[here, column], 1)[0]
            tilts.append(np.degrees(np.arctan(off)))
    if tilts:
        sums.tilt.append(np.array(tilts))


def _add_markers(markers: list[dict[str, Any]], truth: Any, facts: dict[str, Any], sums: _Sums) -> None:
    """A dot that the program says it sees must be where one is; one that is covered need not be found."""
    places, shown = truth["markers_px"], truth["markers_shown"]
    sums.markers_true += int(shown.sum())
    taken: set[int] = set()
    for marker in markers:
        if not marker.get("seen") or "u" not in marker or not len(places):
            continue
        off = np.hypot(places[:, 0] - marker["u"], places[:, 1] - marker["v"])
        nearest = int(np.argmin(off))
        if off[nearest] > MARKER_PX * max(1.0, facts["size"][0] / 960) or nearest in taken or not shown[nearest]:
            sums.markers_wrong += 1
            continue
        taken.add(nearest)
        sums.markers.append(float(off[nearest]))
    sums.markers_found += len(taken)


def _thread_right(found: list[dict[str, Any]], crests: list[dict[str, Any]]) -> tuple[bool, str]:
    """Crests are nearer than what is told apart: something is found, and nothing away from them."""
    if not found:
        return False, "no thread found"
    away = [min(np.linalg.norm(np.subtract(f["place_mm"], c["place_mm"])) for c in crests) for f in found]
    wrong = sum(bool(mm > REGION_MM) for mm in away)
    return wrong == 0, f"{wrong} away from the thread" if wrong else ""


def _regions_right(line: dict[str, Any], regions: list[dict[str, Any]], what: str) -> tuple[bool, str]:
    """Every true region found once and near, nothing else found; slight ones may be missed."""
    if "regions" not in line:
        return False, "no regions"
    if what == "thread":
        return _thread_right(line["regions"], regions)
    found = [np.array(region["place_mm"]) for region in line["regions"]]
    unmatched = set(range(len(found)))
    for region in regions:
        needed = region["deepest_mm"] >= NEEDED_REGION_MM and region["pixels"] >= NEEDED_REGION_PX
        near = [i for i in unmatched if np.linalg.norm(found[i] - region["place_mm"]) <= REGION_MM]
        if near:
            unmatched.discard(near[0])
        elif needed:
            return False, f"{region['deepest_mm']:.2f} mm deep not found"
    if unmatched:
        deepest = max(line["regions"][i]["deepest_mm"] for i in unmatched)
        return False, f"{len(unmatched)} that are none, to {deepest:.2f} mm"
    return True, ""
