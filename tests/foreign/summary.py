"""Many fingers in one table: distributions, limits that must be kept, classes, and who failed with what words."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np

TWISTED = ("twist", "twisted-start")
Finger = dict[str, Any]  # the figures of one


def values(fingers: list[Finger], key: str) -> np.ndarray:
    return np.array([f[key] for f in fingers if f.get(key) is not None and np.isfinite(f[key])])


def _share_within(fingers: list[Finger], key: str, low: float, high: float) -> float:
    """Of all fingers: one without a figure is not within."""
    found = values(fingers, key)
    return float(((found >= low) & (found <= high)).sum() / max(len(fingers), 1))


def must_reach(fingers: list[Finger]) -> list[tuple[str, bool, str]]:
    """(what, kept, how it is) for every line that must hold."""
    rows: list[tuple[str, bool, str]] = []

    def add(what: str, kept: bool, how: str) -> None:
        rows.append((what, bool(kept), how))

    def quantile(what: str, key: str, percent: float, limit: float, chosen: list[Finger]) -> None:
        found = values(chosen, key)
        if len(found):
            value = float(np.percentile(found, percent))
            add(f"{what}, {percent:g} % of fingers, <= {limit}", value <= limit, f"{value:.4f}")

    count = len(fingers)
    measured = sum(f["measured"] for f in fingers)
    add("measured without help, 199 of 200", measured >= np.floor(count * 0.995), f"{measured} of {count}")
    quantile("contact error mm", "contact_mm", 50, 0.015, fingers)
    quantile("contact error mm", "contact_mm", 95, 0.04, fingers)
    # Where the limit is said of no share of fingers, nineteen in twenty must keep it.
    quantile("error within 2 mm of the border, mm", "rim_mm", 95, 0.06, fingers)
    covered = values(fingers, "rim_coverage")
    if len(covered):
        add("coverage within 2 mm of the border, mean >= 0.95", covered.mean() >= 0.95, f"{covered.mean():.3f}")
    quantile("false depth mm", "false_mm", 95, 0.012, fingers)
    for limit, share in ((0.01, 0.68), (0.02, 0.95)):
        within = _share_within(fingers, "scale", 1 - limit, 1 + limit)
        add(f"scale within {limit:.0%}, {share:.0%} of fingers", within >= share, f"{within:.2f}")
    twisted = [f for f in fingers if f["class"] in TWISTED]
    quantile("shape mm", "shape_mm", 95, 0.05, [f for f in fingers if f["class"] not in TWISTED])
    quantile("shape mm, twisted", "shape_mm", 95, 0.1, twisted)
    quantile("markers px", "marker_px", 95, 0.1, fingers)
    right, frames = (sum(f.get(key, 0) for f in fingers) for key in ("regions_right", "regions_frames"))
    frames += sum(f["shots"] for f in fingers if "regions_frames" not in f)
    add("regions right, 98 % of frames", right >= 0.98 * frames, f"{right} of {frames}")
    within = _share_within(fingers, "promise_ratio", 0.7, 1.5)
    add("promised over measured within 0.7 to 1.5, 90 % of fingers", within >= 0.9, f"{within:.2f}")
    squared = values(fingers, "z_squared")
    if len(squared):
        add("z squared 0.8 to 1.3 on average", 0.8 <= squared.mean() <= 1.3, f"{squared.mean():.2f}")
        of_class = {f["class"]: values([g for g in fingers if g["class"] == f["class"]], "z_squared") for f in fingers}
        worst, name = max((found.mean(), kind) for kind, found in of_class.items() if len(found))
        add("z squared below 2.5 for each class", worst < 2.5, f"{worst:.2f} ({name})")
    bands = values(fingers, "band")
    if len(bands):
        add("bands of 95 % hold 92 to 98 %, mean of fingers", 0.92 <= bands.mean() <= 0.98, f"{bands.mean():.3f}")
    quantile("place mm", "place_mm", 95, 0.1, fingers)
    places = values(fingers, "place_z_squared")
    if len(places):
        add("z squared of place 0.7 to 1.5 on average", 0.7 <= places.mean() <= 1.5, f"{places.mean():.2f}")
    told = values(fingers, "resolution_ratio")
    if len(told):
        off = float(np.percentile(np.abs(told - 1), 50))
        add("told resolution within 15 % of the measured, median of fingers", off <= 0.15, f"{off:.2f}")
    return rows


COLUMNS = (
    ("contact_mm", "contact mm"),
    ("contact_bias_mm", "bias mm"),
    ("scale", "scale"),
    ("rim_mm", "rim mm"),
    ("rim_coverage", "rim cover"),
    ("contact_coverage", "cover"),
    ("free_coverage", "free cover"),
    ("false_mm", "false mm"),
    ("off_face_px", "off face px"),
    ("steep_mm", "steep mm"),
    ("shape_mm", "shape mm"),
    ("shape_p95_mm", "shape p95"),
    ("tilt_deg", "tilt deg"),
    ("marker_px", "marker px"),
    ("markers_found", "dots found"),
    ("promise_ratio", "promise"),
    ("z_squared", "z squared"),
    ("band", "95 % band"),
    ("halo_mm", "halo mm"),
    ("place_mm", "place mm"),
    ("along_mm", "along mm"),
    ("place_z_squared", "place z2"),
    ("two_points_mm", "two points"),
    ("resolution_ratio", "told / it"),
)


def distribution(fingers: list[Finger]) -> list[str]:
    lines = [f"{'':<12}{'n':>5}" + "".join(f"{name:>10}" for name in ("min", "median", "p68", "p95", "max"))]
    for key, name in COLUMNS:
        found = values(fingers, key)
        if len(found):
            at = np.percentile(found, [0, 50, 68, 95, 100])
            lines.append(f"{name:<12}{len(found):>5}" + "".join(f"{value:>10.4f}" for value in at))
    return lines


def by_class(fingers: list[Finger]) -> list[str]:
    keys = ("contact_mm", "scale", "rim_mm", "rim_coverage", "false_mm", "shape_mm", "marker_px", "promise_ratio",
            "z_squared")
    names = dict(COLUMNS)
    lines = [f"{'class (medians)':<18}{'measured':>9}" + "".join(f"{names[k]:>11}" for k in keys) + f"{'regions':>9}"]
    for kind in dict.fromkeys(f["class"] for f in fingers):
        chosen = [f for f in fingers if f["class"] == kind]
        text = f"{kind:<18}{sum(f['measured'] for f in chosen):>5}/{len(chosen):<3}"
        for key in keys:
            found = values(chosen, key)
            text += f"{np.median(found):>11.4f}" if len(found) else f"{'-':>11}"
        right, frames = (sum(f.get(key, 0) for f in chosen) for key in ("regions_right", "regions_frames"))
        lines.append(text + f"{right:>5}/{frames:<3}")
    return lines


def report(fingers: list[Finger]) -> str:
    lines = ["", *distribution(fingers), "", *by_class(fingers)]
    failing = [f for f in fingers if not f["measured"]]
    if failing:
        lines += ["", "not measured:"]
        lines += [f"  {f['name']}: {f['failed'] or 'depth in too few pictures'}: {f['said']}" for f in failing]
    for f in fingers:
        if f.get("unnamed"):
            lines += ["", f"{f['name']}: no problem named for {', '.join(f['unnamed'])}"]
    wrong = Counter(
        frame["regions"].split(",")[0] for f in fingers for frame in f.get("frames", []) if not frame["regions_right"]
    )
    if wrong:
        lines += ["", "regions wrong, most frequent: " + "; ".join(f"{n} x {what}" for what, n in wrong.most_common(6))]
    return "\n".join(lines)
