"""Lenses: points in mm to pixels and pixels to lines of sight.

The camera looks along z, x runs with the picture's u and y with its v, the middle of the top-left pixel is (0, 0).
A lens may look through a flat window into the clear silicone; lines of sight then no longer meet in one point.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np


@dataclass(frozen=True)
class Port:
    """Air, a plate, then the silicone; the window stands at right angles to the optical axis."""

    gap_mm: float
    plate_mm: float
    plate_index: float
    medium_index: float


@dataclass(frozen=True)
class Camera:
    """model: pinhole, brown (k1 k2 p1 p2 k3) or fisheye (k1 k2 k3 k4), coefficients as OpenCV names them."""

    model: str
    width_px: int
    height_px: int
    f_px: tuple[float, float]
    centre_px: tuple[float, float]
    distortion: tuple[float, ...] = field(default_factory=tuple)
    port: Port | None = None
    sd_px: tuple[float, ...] = field(default_factory=tuple)  # of fx, fy, cx, cy, where they are estimates

    def project(self, points_mm: np.ndarray) -> np.ndarray:
        """(..., 3) points before the camera to (..., 2) pixels."""
        points = np.asarray(points_mm, float)
        if self.port is None:
            flat = points[..., :2] / points[..., 2:]
        else:
            flat = _air_slopes(self.port, points)
        return self._distorted(flat) * self.f_px + self.centre_px

    def sight_lines(self, pixels: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(..., 2) pixels to origins and directions (z = 1) of their lines of sight in the silicone, (..., 3) each."""
        wanted = (np.asarray(pixels, float) - self.centre_px) / self.f_px
        flat = self._undistorted(wanted)
        directions = np.concatenate([flat, np.ones_like(flat[..., :1])], axis=-1)
        origins = np.zeros_like(directions)
        if self.port is not None:
            origins, directions = _behind_port(self.port, flat)
        return origins, directions

    def folds(self) -> bool:
        """True when two directions would be seen in one pixel of the picture, or a little beyond its corners."""
        corners = np.array([[0, 0], [0, self.height_px], [self.width_px, 0], [self.width_px, self.height_px]], float)
        reach = 1.04 * np.linalg.norm((corners - self.centre_px) / self.f_px, axis=1).max()
        slope = np.linspace(0, 6, 6000)
        seen = np.linalg.norm(self._distorted(np.stack([slope, 0 * slope], axis=-1)), axis=-1)
        far = np.argmax(seen > reach)  # 0: never
        return bool(far == 0 or np.any(np.diff(seen[: far + 1]) <= 0))

    def _distorted(self, flat: np.ndarray) -> np.ndarray:
        if self.model == "pinhole":
            return flat
        x, y = flat[..., 0], flat[..., 1]
        squared = x * x + y * y
        if self.model == "brown":
            k1, k2, p1, p2, k3 = self.distortion
            radial = 1 + squared * (k1 + squared * (k2 + squared * k3))
            return np.stack(
                [
                    x * radial + 2 * p1 * x * y + p2 * (squared + 2 * x * x),
                    y * radial + p1 * (squared + 2 * y * y) + 2 * p2 * x * y,
                ],
                axis=-1,
            )
        radius = np.sqrt(squared)
        angle = np.arctan(radius)
        bent = angle * _fisheye_factor(angle, self.distortion)
        scale = np.where(radius > 1e-9, bent / np.maximum(radius, 1e-9), 1.0)
        return flat * scale[..., None]

    def _undistorted(self, wanted: np.ndarray) -> np.ndarray:
        if self.model == "pinhole":
            return wanted
        if self.model == "fisheye":
            bent = np.linalg.norm(wanted, axis=-1)
            angle = bent.copy()
            for _ in range(30):
                step = 1e-6
                value = angle * _fisheye_factor(angle, self.distortion) - bent
                slope = ((angle + step) * _fisheye_factor(angle + step, self.distortion) - bent - value) / step
                angle = np.clip(angle - value / slope, 0.0, 1.5)
            scale = np.where(bent > 1e-9, np.tan(angle) / np.maximum(bent, 1e-9), 1.0)
            return wanted * scale[..., None]
        flat = wanted.copy()
        for _ in range(60):
            flat = flat + 0.9 * (wanted - self._distorted(flat))
        return flat

    def yaml(self) -> str:
        """What the program's CAMERA.yaml must say."""
        lines = [
            f"model: {self.model}",
            f"size: [{self.width_px}, {self.height_px}]",
            f"fx: {self.f_px[0]:.9g}",
            f"fy: {self.f_px[1]:.9g}",
            f"cx: {self.centre_px[0]:.9g}",
            f"cy: {self.centre_px[1]:.9g}",
            *(["sd_px: [" + ", ".join(f"{sd:.4g}" for sd in self.sd_px) + "]"] if self.sd_px else []),
            "distortion: [" + ", ".join(f"{k:.9g}" for k in self.distortion) + "]",
            "orientation: none",
        ]
        if self.port is not None:
            lines.append(
                f"port: {{gap_mm: {self.port.gap_mm:.9g}, plate_mm: {self.port.plate_mm:.9g}, "
                f"plate_index: {self.port.plate_index:.9g}, medium_index: {self.port.medium_index:.9g}}}"
            )
        return "\n".join(lines) + "\n"


def _fisheye_factor(angle: np.ndarray, k: tuple[float, ...]) -> np.ndarray:
    squared = angle * angle
    return 1 + squared * (k[0] + squared * (k[1] + squared * (k[2] + squared * k[3])))


def _slopes_after(port: Port, air_slope: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Tangents of the angle to the axis in the plate and in the medium, by Snell's law."""
    sine = air_slope / np.sqrt(1 + air_slope**2)
    in_plate, in_medium = sine / port.plate_index, sine / port.medium_index
    return in_plate / np.sqrt(1 - in_plate**2), in_medium / np.sqrt(1 - in_medium**2)


def _behind_port(port: Port, flat: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    slope = np.linalg.norm(flat, axis=-1)
    plate, medium = _slopes_after(port, slope)
    unit = flat / np.maximum(slope, 1e-12)[..., None]
    depth = port.gap_mm + port.plate_mm
    radius = port.gap_mm * slope + port.plate_mm * plate
    directions = np.concatenate([unit * medium[..., None], np.ones_like(flat[..., :1])], axis=-1)
    origins = np.concatenate([unit * (radius - depth * medium)[..., None], np.zeros_like(flat[..., :1])], axis=-1)
    return origins, directions


def _air_slopes(port: Port, points: np.ndarray) -> np.ndarray:
    radius = np.linalg.norm(points[..., :2], axis=-1)
    beyond = points[..., 2] - port.gap_mm - port.plate_mm
    low, high = np.zeros_like(radius), np.full_like(radius, 50.0)
    for _ in range(60):
        middle = 0.5 * (low + high)
        plate, medium = _slopes_after(port, middle)
        reached = port.gap_mm * middle + port.plate_mm * plate + beyond * medium
        low, high = np.where(reached < radius, middle, low), np.where(reached < radius, high, middle)
    return points[..., :2] / np.maximum(radius, 1e-12)[..., None] * (0.5 * (low + high))[..., None]
