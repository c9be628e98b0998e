#!/usr/bin/python3
"""The source paper's formulas as one would write them with NumPy and OpenCV: what speed and error are compared with.
    alltact export FINGER --to zip -o out
    paper_formulas.py out/finger.zip FRAMES [--truth DIR] [--ours DIR] [--repeat N]
FRAMES: a folder of grey pictures; DIR: NAME.depth.tiff of each (mm along z, NaN off the face), of `alltact simulate` and of
`alltact reconstruct`. Prints JSON: milliseconds of a frame by step on one thread (the best of N runs, median over frames); errors over what truly is pressed
and over the whole face. Lengths in mm in the camera's frame; arrays are [v, u] in pixels."""
import argparse, glob, json, os, sys, tempfile, time, zipfile

try:
    import cv2
    import numpy as np
except ImportError as missing:
    sys.exit(f"{missing}: install python3-numpy and python3-opencv")

DEGREE = 7  # of the profile
LEAST_WIDTH_PX, LEAST_DOT_PX = 8, 12
PRESSED_MM = 0.05


class PaperFinger:
    def __init__(self, exported: str) -> None:
        with tempfile.TemporaryDirectory() as folder, zipfile.ZipFile(exported) as archive:
            archive.extractall(folder)
            told = json.load(open(f"{folder}/calibration.json"))
            video = cv2.VideoCapture(f"{folder}/finger/{told['reference']['video']}")
            frames = []
            while (frame := video.read()[1]) is not None:
                frames.append(np.ascontiguousarray(frame[..., 0]))
        self.camera, self.face, self.mapping = told["camera"], told["face"], told["mapping"]
        assert self.camera["model"] == "pinhole" and self.camera["orientation"] == "none", "a pinhole camera as it stands"
        self.per_row = told["markers"]["per_row"]
        # Only frames in which both rows are whole can be told apart by number.
        numbered = [(frame, rows) for frame in frames if (rows := self.markers(frame, *self.edges(frame))) is not None]
        assert numbered, "no recorded frame shows all of its markers"
        self.frames, markers = zip(*numbered)
        self.frame_markers = np.array(markers)

    def edges(self, grey):
        """Rows of both edges by column of the binarised picture's largest part."""
        level, _ = cv2.threshold(grey, 0, 255, cv2.THRESH_OTSU)
        binary = np.uint8(grey > level / 2)  # the tip is darker than the base
        _, labels, stats, _ = cv2.connectedComponentsWithStats(binary)
        face = labels == 1 + np.argmax(stats[1:, cv2.CC_STAT_AREA])
        upper, lower = face.argmax(0), face.shape[0] - 1 - face[::-1].argmax(0)
        return np.flatnonzero(face.any(0) & (lower - upper > LEAST_WIDTH_PX)), upper, lower

    def shape(self, columns, upper, lower):
        """z(u) of the view face, and 1 / cos of its incline: z = f W / (v2 - v1), a polynomial along the finger."""
        c, width = self.camera, len(upper)
        z = c["fy_px"] * self.face["width_mm"] / (lower - upper)[columns]
        scaled = 2 * np.arange(width) / (width - 1) - 1
        z = np.polyval(np.polyfit(scaled[columns], z, DEGREE), scaled)
        x = (np.arange(width) - c["cx_px"]) / c["fx_px"] * z
        return z, np.hypot(1, np.gradient(z) / np.gradient(x))

    def markers(self, grey, columns, upper, lower):
        """Spots beside the face, brighter than what lies around them, each row from left to right; None where some are
        missing. (The paper's network finds them; it takes longer.)"""
        row, seen = np.arange(grey.shape[0])[:, None], np.isin(np.arange(grey.shape[1]), columns)
        on_face = (row > upper - 4) & (row < lower + 4) & seen
        side = np.where(on_face, 0, grey).astype(np.uint8)
        bright = cv2.adaptiveThreshold(side, 1, cv2.ADAPTIVE_THRESH_MEAN_C, cv2.THRESH_BINARY, 61, -6)
        _, _, stats, centres = cv2.connectedComponentsWithStats(bright)
        area, filled = stats[:, cv2.CC_STAT_AREA], stats[:, 2] * stats[:, 3]
        spots = np.flatnonzero((area >= LEAST_DOT_PX) & (area > 0.45 * filled) & (area < 0.1 * grey.size))
        rows = []
        for half in (centres[spots, 1] < grey.shape[0] / 2, centres[spots, 1] >= grey.shape[0] / 2):
            row = spots[half][np.argsort(-area[spots[half]], kind="stable")[: self.per_row]]
            rows.append(centres[row[np.argsort(centres[row, 0])]])
        return np.concatenate(rows) if all(len(row) == self.per_row for row in rows) else None

    def nearest(self, markers, grey):
        """The recorded frame whose markers are nearest; the most alike one where they cannot be numbered."""
        if markers is None:
            away = [cv2.absdiff(frame[::8, ::8], grey[::8, ::8]).mean() for frame in self.frames]
        else:
            away = np.linalg.norm(self.frame_markers - markers, axis=2).sum(1)
        return self.frames[int(np.argmin(away))]

    def depth(self, grey, reference, face, along_z):
        """d = M(x), x = (I_ref - I) / I_ref, along z."""
        m = self.mapping
        untouched = np.maximum(reference, 1).astype(np.float32)
        x = np.clip((untouched - grey) / untouched, 0, m["domain"][1])
        depth = m["a_mm"] * x / (1 + m["b"] * x) if m["kind"] == "moebius" else np.polyval(m["powers_mm"][::-1], x)
        if m["along"] == "normal":
            depth = depth * along_z
        return np.where(face, depth, np.nan).astype(np.float32)

    def points(self, z, along_z, depth):
        """p_CF = p_LUF - (0, 0, d), all rays of a column as long."""
        c = self.camera
        u, v = np.arange(depth.shape[1]), np.arange(depth.shape[0])[:, None]
        layer = self.face["layer_mm"] * along_z
        x = np.broadcast_to((u - c["cx_px"]) / c["fx_px"] * z, depth.shape)
        return np.dstack([x, (v - c["cy_px"]) / c["fy_px"] * z, z + layer - depth]).astype(np.float32)

    def __call__(self, grey):
        laps, took = [("begin", time.process_time())], {}
        lap = lambda step: laps.append((step, time.process_time()))
        columns, upper, lower = self.edges(grey)
        lap("edges")
        z, along_z = self.shape(columns, upper, lower)
        lap("shape")
        markers = self.markers(grey, columns, upper, lower)
        lap("markers")
        reference = self.nearest(markers, grey)
        lap("reference")
        row, seen = np.arange(grey.shape[0])[:, None], np.isin(np.arange(grey.shape[1]), columns)
        depth = self.depth(grey, reference, (row > upper) & (row < lower) & seen, along_z)
        lap("depth")
        self.points(z, along_z, depth)
        lap("points")
        for (_, before), (step, now) in zip(laps, laps[1:]):
            took[step] = 1e3 * (now - before)
        took["total"] = 1e3 * (laps[-1][1] - laps[0][1])
        return depth, took


def errors(pairs):
    """Of (depth, truth) pictures, mm; a pixel that has no depth counts as untouched."""
    off = [(np.abs(np.nan_to_num(depth) - truth)[ok], truth[ok]) for depth, truth in pairs if (ok := np.isfinite(truth)).any()]
    error, truth = (np.concatenate(all_of) for all_of in zip(*off))
    told = {}
    for name, where in (("pressed", truth > PRESSED_MM), ("face", np.ones(len(truth), bool))):
        some = error[where]
        told[name] = {"median_mm": float(np.median(some)), "p95_mm": float(np.percentile(some, 95)),
                      "rms_mm": float(np.sqrt((some**2).mean())), "pixels": len(some)}
    return told


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("exported"), parser.add_argument("frames")
    parser.add_argument("--truth"), parser.add_argument("--ours"), parser.add_argument("--repeat", type=int, default=5)
    args = parser.parse_args()
    cv2.setNumThreads(1)
    finger = PaperFinger(args.exported)
    files = [name for name in sorted(glob.glob(f"{args.frames}/*.png")) if "truth" not in os.path.basename(name)]
    told, steps, depths = {"frames": len(files)}, {}, {}
    for name in files:
        grey = cv2.imread(name, cv2.IMREAD_GRAYSCALE)
        runs = []
        for _ in range(args.repeat):
            depths[name], took = finger(grey)
            runs.append(took)
        for step in runs[0]:  # what else the computer does is no part of it
            steps.setdefault(step, []).append(min(run[step] for run in runs))
    told["ms"] = {step: float(np.median(all_ms)) for step, all_ms in steps.items()}
    picture = lambda folder, name: cv2.imread(f"{folder}/{os.path.basename(name)[:-4]}.depth.tiff", cv2.IMREAD_UNCHANGED)
    if args.truth:
        told["error"] = errors((depths[name], picture(args.truth, name)) for name in files)
    if args.truth and args.ours:
        told["our_error"] = errors((picture(args.ours, name), picture(args.truth, name)) for name in files)
    print(json.dumps(told, indent=1))


if __name__ == "__main__":
    main()
