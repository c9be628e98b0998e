"""The program as a user runs it on one finger: new, reference, calibrate, reconstruct."""

from __future__ import annotations

import json
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
    seconds: dict[str, float] = field(default_factory=dict)


def run_program(program: Path, made: Path, facts: dict[str, Any], scratch: Path) -> Run:
    """made: the folder of a rendered finger; scratch: an empty folder for what the program writes."""
    finger = scratch / "finger"
    run = Run(results=scratch / "results")
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
            ["calibrate", finger, made / "presses", "--ball-radius-mm", f"{facts['ball_radius_mm']:.4f}", "--json"],
        ),
        (
            "reconstruct",
            ["reconstruct", finger, made / "tests", "-o", run.results, "--format", "depth,depth_sd,points", "--json"],
        ),
    )
    for name, arguments in steps:
        begin = time.monotonic()
        try:
            done = subprocess.run(
                [str(program), *map(str, arguments)], capture_output=True, text=True, timeout=COMMAND_S, check=False
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
            run.said = said[-1] if said else str(answer.get("error", output[-300:]))
            if name != "reconstruct":
                return run
    lines = run.results / "results.jsonl"
    if lines.exists():
        for text in lines.read_text().splitlines():
            line = json.loads(text)
            run.lines[line["frame"]] = line
    return run


def _answer(output: str) -> dict[str, Any]:
    try:
        answer = json.loads(output)
        return answer if isinstance(answer, dict) else {}
    except json.JSONDecodeError:
        return {}
