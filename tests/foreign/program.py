"""The program as a user runs it on one finger: new, reference, calibrate, reconstruct."""

from __future__ import annotations

import json
import os
import subprocess
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

COMMAND_S = 900


@dataclass
class Run:
    """What came of it. failed: the command that did not exit with 0, and why in its own words."""

    failed: str = ""
    said: str = ""
    reference: dict[str, Any] = field(default_factory=dict)
    calibration: dict[str, Any] = field(default_factory=dict)
    lines: dict[str, dict[str, Any]] = field(default_factory=dict)
    results: Path = Path()
    points: Path = Path()  # results of pairs of points, where there are any
    seconds: dict[str, float] = field(default_factory=dict)
    unnamed: list[str] = field(default_factory=list)  # pictures that cannot be measured rightly, yet no problem is told


def run_program(
    program: Path, made: Path, facts: dict[str, Any], scratch: Path, settings: list[str], with_rods: bool = False
) -> Run:
    """made: the folder of a rendered finger; scratch: an empty folder for what the program writes; settings: flags to
    calibrate and measure with; with_rods: calibrate with the presses of rods as well."""
    rods = sorted((made / "bodies").glob("*.png")) if with_rods else []
    bodies = [word for rod in rods for word in ("--body", f"{rod.stem}={made.absolute() / 'bodies' / 'rod.stl'}")]
    finger = scratch / "finger"
    run = Run(results=scratch / "results", points=scratch / "points")
    steps = (
        (
            "new",
            [
                *("new", finger, "--camera", made / "camera.yaml"),
                *("--width-mm", f"{facts['width_mm']:.3f}", "--layer-mm", f"{facts['layer_mm']:.3f}"),
                *("--per-row", facts["per_row"], "--polarity", facts["polarity"]),
            ],
        ),
        ("reference", ["reference", finger, made / "recording", "--json"]),
        (
            "calibrate",
            [
                *("calibrate", finger, made / "presses", *rods, *bodies),
                *("--ball-radius-mm", f"{facts['ball_radius_mm']:.4f}", "--json", *settings),
            ],
        ),
        (
            "reconstruct",
            [
                *("reconstruct", finger, made / "tests", "-o", run.results),
                *("--format", "depth,depth_sd,points", "--json", *settings),
            ],
        ),
    )
    environment = os.environ | {"XDG_CACHE_HOME": str(scratch.absolute() / "cache")}  # not the user's
    for name, arguments in steps:
        begin = time.monotonic()
        try:
            done = subprocess.run(
                [str(program), *map(str, arguments)],
                capture_output=True,
                text=True,
                timeout=COMMAND_S,
                check=False,
                env=environment,
            )
            status, output, errors = done.returncode, done.stdout, done.stderr
        except subprocess.TimeoutExpired:
            status, output, errors = -1, "", f"no end after {COMMAND_S} s"
        run.seconds[name] = time.monotonic() - begin
        answer = _answer(output)
        if name == "reference":
            run.reference = answer
        if name == "calibrate":
            run.calibration = answer
        if status != 0:
            run.failed = name
            said = [line for line in errors.splitlines() if line.strip() and not line.startswith("Warning")]
            run.said = said[0] if said else str(answer.get("error", output[-300:]))
            if name != "reconstruct":
                return run
    run.lines = _lines(run.results)
    if (made / "points").exists():
        command = [program, "reconstruct", scratch / "finger", made / "points", "-o", run.points, "--format", "depth"]
        subprocess.run([*map(str, command), *settings], capture_output=True, timeout=COMMAND_S, check=False, env=environment)
    if (made / "degraded").exists():
        run.unnamed = _unnamed(program, made, scratch)
    return run


def _lines(results: Path) -> dict[str, dict[str, Any]]:
    file = results / "results.jsonl"
    if not file.exists():
        return {}
    return {line["frame"]: line for line in map(json.loads, file.read_text().splitlines())}


def _unnamed(program: Path, made: Path, scratch: Path) -> list[str]:
    unnamed = []
    for part in ("degraded", "frozen"):
        results = scratch / part
        command = [program, "reconstruct", scratch / "finger", made / part, "-o", results, "--format", "depth"]
        subprocess.run([str(word) for word in command], capture_output=True, timeout=COMMAND_S, check=False)
        lines = _lines(results)
        if part == "degraded":
            unnamed += [p.stem for p in (made / part).iterdir() if not lines.get(p.stem, {}).get("problems")]
        elif not any(line.get("problems") for line in lines.values()):
            unnamed.append(part)
    return sorted(unnamed)


def _answer(output: str) -> dict[str, Any]:
    try:
        answer = json.loads(output)
        return answer if isinstance(answer, dict) else {}
    except json.JSONDecodeError:
        return {}
