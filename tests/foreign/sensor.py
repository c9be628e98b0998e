"""From light to numbers: defocus, fixed pattern, shot and read noise, gain, whole grey levels, JPEG."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from contact import blurred


@dataclass(frozen=True)
class Sensor:
    defocus_px: float
    read_sd: float  # grey levels
    shot: float  # variance per grey level
    pattern: np.ndarray  # of each pixel's gain, about 1
    jpeg_quality: int | None

    def expose(self, light: np.ndarray, rng: np.random.Generator, gain: float = 1.0) -> np.ndarray:
        sharp = light.astype(np.float32) * np.float32(gain)
        grey = blurred(sharp, self.defocus_px, self.defocus_px) * self.pattern
        variance = self.read_sd**2 + self.shot * np.maximum(grey, 0)
        grey = grey + np.sqrt(variance) * rng.standard_normal(grey.shape, dtype=np.float32)
        picture = np.clip(np.rint(grey), 0, 255).astype(np.uint8)
        if self.jpeg_quality is None:
            return picture
        _, packet = cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, self.jpeg_quality])
        return cv2.imdecode(packet, cv2.IMREAD_GRAYSCALE)
