#!/usr/bin/env python3
"""Renders foreign fingers and judges what a program makes of them.

Fingers are rendered once into a folder (--keep) and judged as often as wanted. The seed and every finger's name are
printed: SEED-NUMBER-CLASS, which --only and --seed repeat alone. Exit status 0 when all that must be reached is.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack
from pathlib import Path
from typing import Any

for variable in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"):  # many fingers at once instead; and the same sums
    os.environ.setdefault(variable, "1")

from dataset import folder_of, make_finger  # noqa: E402
from finger import CLASSES  # noqa: E402
from measure import measure  # noqa: E402
from program import run_program  # noqa: E402
from summary import must_reach, report  # noqa: E402


def judge_one(
    program: Path, made: Path, results: Path | None, settings: list[str], with_rods: bool = False
) -> dict[str, Any]:
    """Figures of one rendered finger; results: where to keep what the program wrote; with_rods: see run_program."""
    facts = json.loads((made / "finger.json").read_text())
    with ExitStack() as stack:
        if results is None:
            scratch = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="foreign-")))
        else:
            scratch = results / made.name
            scratch.mkdir(parents=True)
        run = run_program(program, made, facts, scratch, settings, with_rods)
        figures: dict[str, Any] = {
            "name": made.name,
            "class": facts["class"],
            "size": facts["size"],
            "shots": len(facts["shots"]),
            "failed": run.failed,
            "said": run.said,
            "seconds": run.seconds,
            "unnamed": run.unnamed,
        }
        if run.lines:
            figures |= measure(run, made, facts)
        enough = 0.8 * len(facts["shots"])
        # Of a finger that is measured some pictures may have no depth; reconstruct says so by its exit status.
        figures["measured"] = run.failed in ("", "reconstruct") and figures.get("depth_frames", 0) >= enough
    return figures


def one_line(figures: dict[str, Any]) -> str:
    if not figures["measured"]:
        return f"{figures['name']:<28} NOT MEASURED: {figures['failed']}: {figures['said'][:160]}"
    keys = ("contact_mm", "rim_mm", "false_mm", "scale", "shape_mm", "marker_px", "promise_ratio", "z_squared")
    shown = " ".join(f"{key.removesuffix('_mm')} {figures[key]:.4f}" for key in keys if figures.get(key) is not None)
    return f"{figures['name']:<28} {shown} regions {figures['regions_right']}/{figures['regions_frames']}"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, help="the alltact to judge")
    parser.add_argument("--fingers", type=int, default=len(CLASSES), help="how many; classes take turns")
    parser.add_argument("--first", type=int, default=0, help="number of the first one")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=CLASSES, action="append", help="judge this class alone; may be repeated")
    parser.add_argument("--keep", type=Path, help="folder where rendered fingers stay, and are taken from")
    parser.add_argument("--render-only", action="store_true", help="do not judge")
    parser.add_argument("--cached-only", action="store_true", help="judge what is rendered already, nothing else")
    parser.add_argument("--results", type=Path, help="new folder to keep what the program wrote")
    parser.add_argument(
        "--measured-only", action="store_true", help="exit status 0 when every finger is measured, however well"
    )
    parser.add_argument(
        "--settings", default="", help='flags to calibrate and measure with: --settings="--marker-method network"'
    )
    parser.add_argument("--rods", action="store_true", help="calibrate with presses of a rod of known shape as well")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--json", type=Path, help="file for all figures")
    options = parser.parse_args()
    if not options.render_only and options.program is None:
        parser.error("--program is needed to judge")
    numbers = [(i, CLASSES[i % len(CLASSES)]) for i in range(options.first, options.first + options.fingers)]
    if options.only:
        numbers = [(i, kind) for i, kind in numbers if kind in options.only]
    with ExitStack() as stack:
        cache = options.keep or Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="foreign-")))
        print(f"seed {options.seed}, {len(numbers)} fingers in {cache}", flush=True)
        if options.cached_only:
            numbers = [n for n in numbers if (folder_of(cache, options.seed, *n) / "finger.json").exists()]
        with ProcessPoolExecutor(options.jobs) as pool:
            made = [pool.submit(make_finger, cache, options.seed, i, kind) for i, kind in numbers]
            if options.render_only:
                for folder in made:
                    print(folder.result(), flush=True)
                return 0
            settings = options.settings.split()
            judged = [
                pool.submit(judge_one, options.program, folder.result(), options.results, settings, options.rods)
                for folder in made
            ]
            fingers = []
            for figures in judged:
                fingers.append(figures.result())
                print(one_line(fingers[-1]), flush=True)
    return conclude(fingers, options)


def conclude(fingers: list[dict[str, Any]], options: argparse.Namespace) -> int:
    rows = must_reach(fingers)
    print(report(fingers))
    print()
    for what, kept, how in rows:
        print(f"{'passed' if kept else 'FAILED'}: foreign fingers, {what}: {how}")
    if options.json:
        kept = [{"what": what, "kept": is_kept, "how": how} for what, is_kept, how in rows]
        options.json.write_text(json.dumps({"seed": options.seed, "must": kept, "fingers": fingers}, indent=1))
    if options.measured_only:
        return 0 if all(figures["measured"] for figures in fingers) else 1
    return 0 if all(kept for _, kept, _ in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
