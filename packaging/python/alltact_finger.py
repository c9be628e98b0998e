"""Measures with a finger that AllTact Studio calibrated: a picture in, millimetres out. Needs numpy and OpenCV.
    alltact export FINGER --to zip -o out && python3 alltact_finger.py out/finger.zip PICTURE... # PICTURE.depth.tiff
Lengths in mm, in the camera's frame: x along u, y along v, z away from it. Arrays are [v, u] in pixels."""
import json, sys, tempfile, zipfile
import cv2
import numpy as np
from numpy.polynomial import Chebyshev

TURNS = {"none": lambda p: p, "flip_u": np.fliplr, "flip_v": np.flipud, "rotate_180": lambda p: np.rot90(p, 2),
         "rotate_90": lambda p: np.rot90(p, -1), "rotate_270": np.rot90}
FRAMES, DARKEST, CLIPPED = 8, 8, 250  # how many are mixed; grey levels between which a pixel tells something


class Finger:
    def __init__(self, exported: str) -> None:  # finger.zip: calibration.json, and the finger's folder
        with tempfile.TemporaryDirectory() as folder, zipfile.ZipFile(exported) as archive:
            archive.extractall(folder)
            told = json.loads(archive.read("calibration.json"))
            self.camera, self.layer, self.mapping = (told[what] for what in ("camera", "face", "mapping"))
            assert "port" not in self.camera and "varies" not in self.mapping, "for this finger use alltact reconstruct"
            frames = self._untouched({what: f"{folder}/finger/{name}" for what, name in told["reference"].items()})
        self.turned = lambda picture: np.ascontiguousarray(TURNS[self.camera["orientation"]](picture))
        self.shrunk = lambda picture: cv2.blur(np.float32(picture), (4, 4))[2::4, 2::4].astype(float)
        self.frames = np.array([self.turned(frame) for frame in frames])
        self.small, self.rays = np.array([self.shrunk(frame) for frame in self.frames]), self._rays()

    def _untouched(self, files: dict) -> list:
        if "image" in files:
            return [cv2.imread(files["image"], cv2.IMREAD_GRAYSCALE)]
        used = {int(row.split(",")[0]) for row in open(files["markers"]).read().splitlines()[1:-1]}
        video = cv2.VideoCapture(files["video"])
        return [frame[..., 0] for n in range(max(used) + 1) if (frame := video.read()[1]) is not None and n in used]

    def _rays(self) -> np.ndarray:
        """x / z and y / z of every pixel [v, u, 2]; of an orthographic camera x and y in mm."""
        c, (width, height) = self.camera, self.camera["size_px"]
        pixels = np.stack(np.meshgrid(np.arange(width), np.arange(height)), -1).astype(float)
        if c["model"] == "orthographic":
            return (pixels - [c["cx_px"], c["cy_px"]]) * c["mm_per_px"]
        lens = np.array([[c["fx_px"], 0, c["cx_px"]], [0, c["fy_px"], c["cy_px"]], [0, 0, 1]])
        undistort, counts = (cv2.fisheye.undistortPoints, [4]) if c["model"] == "fisheye" else (cv2.undistortPoints, [5, 8, 12])
        terms = next(count for count in counts if count >= len(c["distortion"]))
        bent = np.pad(np.float64(c["distortion"]), (0, terms - len(c["distortion"])))
        return undistort(pixels.reshape(-1, 1, 2), lens, bent).reshape(height, width, 2)

    def reference(self, grey: np.ndarray) -> np.ndarray:
        """Grey levels if nothing touched: the frames most alike, mixed as fits where no contact stands out."""
        live, count = self.shrunk(grey), min(FRAMES, len(self.frames))
        away = np.minimum(abs(np.sqrt(self.small + 4) - np.sqrt(live + 4)), 0.5).mean((1, 2))
        near, weights = np.argsort(away)[:count], np.full(count, 1 / count)
        bright = (untouched := self.small[near].reshape(count, -1).T).min(1) > DARKEST
        for _ in range(15 if count > 1 else 0):
            off = abs(live.ravel() - untouched @ weights)
            odd = (off > 3 * max(1.48 * np.median(off[bright]), 0.3)).reshape(live.shape).astype(np.uint8)
            odd = cv2.dilate(cv2.morphologyEx(odd, cv2.MORPH_OPEN, np.ones((3, 3))), np.ones((5, 5)))
            used = bright & (odd.ravel() == 0)
            a, pull = untouched[used], 1e-6 * (untouched[used] ** 2).sum()  # to equal weights, where all are alike
            weights = np.linalg.solve(a.T @ a + pull * np.eye(count), a.T @ live.ravel()[used] + pull / count)
        return np.tensordot(weights, self.frames[near], 1).astype(np.float32)

    def face(self, grey: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Which pixels show the view face, its points [v, u, 3], and the cosine of its incline."""
        x, ones = self.rays[..., 0], np.ones(grey.shape)
        if self.layer["kind"] == "flat":
            scale = 1 if self.camera["model"] == "orthographic" else self.layer["plane_z_mm"]
            return ones > 0, np.dstack([self.rays * scale, self.layer["plane_z_mm"] * ones]), ones
        bright = np.uint8(grey > 0.45 * np.maximum(grey.max(0), 2 * DARKEST))
        _, parts, sizes, _ = cv2.connectedComponentsWithStats(bright)
        part, join = parts == 1 + sizes[1:, 4].argmax(), np.logical_or.accumulate
        on_face = join(part) & join(part[::-1])[::-1]  # with the contacts inside
        u = np.flatnonzero(on_face.sum(0) > 5)[8:-8]
        top, bottom = on_face.argmax(0)[u], len(on_face) - 1 - on_face[::-1].argmax(0)[u]
        across = (self.rays[bottom, u, 1] - self.rays[top, u, 1]) * (1 + 1 / (bottom - top))
        middle, inverse_z, kept = x[(top + bottom) // 2, u], across / self.layer["width_mm"], np.full(len(u), True)
        for _ in range(4):  # dots that touch the edge, and the face's own ends, stand out
            curve = Chebyshev.fit(middle[kept], inverse_z[kept], 3)
            kept = (off := abs(inverse_z - curve(middle))) <= 6 * np.median(off)
        z, slope = 1 / np.maximum(curve(x), 1e-6), curve.deriv()(x)
        return on_face, np.dstack([self.rays * z[..., None], z]), 1 / np.hypot(1, slope / (1 / z - x * slope))

    def depth(self, picture: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """A camera's grey picture -> how deep the contact face is pressed in along z (< 0: bulges), and its points, NaN off."""
        reference = self.reference(grey := self.turned(picture))
        on_face, points, cosine = self.face(cv2.blur(grey, (3, 3)))
        m, most, kernel = self.mapping, self.mapping["domain"][1], np.array(self.mapping["smoothing"])
        smooth = lambda p: cv2.sepFilter2D(np.float32(np.where(on_face, p, 0)), -1, kernel, kernel)
        x = 1 - smooth(grey) / np.maximum(smooth(reference), 1)  # < 0: brighter, a bulge
        curve = lambda x: x * (m["a_mm"] / (1 + m["b"] * x) if "b" in m else Chebyshev(m["chebyshev_mm"], [0, most])(x))
        least = -min(1, 0.5 / max(m["b"], 0.5)) if "b" in m else 0  # of the curve; beyond, on along its ends
        slope = lambda x, step: (curve(x + step) - curve(x)) / step
        beyond, before = np.maximum(0, x - most), np.minimum(0, x - least)
        depth = curve(x - beyond - before) + beyond * slope(most, -1e-4) + before * slope(least, 1e-4)
        depth /= cosine if m["along"] != "z" else 1
        depth[cv2.erode(np.uint8(on_face), np.ones((7, 1)), borderValue=1) == 0] = np.nan
        depth[(reference < DARKEST) | (np.maximum(reference, grey) >= CLIPPED)] = np.nan
        points[..., 2] += self.layer["layer_mm"] / cosine - depth
        return depth, points


if __name__ == "__main__":
    finger = Finger(sys.argv[1])
    for file in sys.argv[2:]:
        cv2.imwrite(f"{file}.depth.tiff", np.float32(finger.depth(cv2.imread(file, cv2.IMREAD_GRAYSCALE))[0]))
