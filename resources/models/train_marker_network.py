#!/usr/bin/python3
"""Trains the marker network on simulated fingers and writes it beside this file.

    nice /usr/bin/python3 resources/models/train_marker_network.py --program build/release/app/alltact

needs Debian's python3-torch, python3-onnx and python3-opencv (none of them is needed to build, test or run the program).
Writes marker_network.onnx and marker_network.yaml: what goes in, what comes out, and what must come out of a picture
that the program makes for itself when it loads the network.

In: the square root of grey / 255, [1, 1, height, width]. Out: [1, 3, height / 4, width / 4], of the cell (x, y) about
the pixel (4 x, 4 y): how surely a dot's middle lies there (a logit), and the logarithms of its half width and height.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from pathlib import Path

import cv2
import numpy as np
import torch
from torch import nn
from torch.nn import functional as F

from marker_scenes import HEIGHT, WIDTH, Example, render

STRIDE = 4
FIRST_TRAINING_SEED, FIRST_JUDGING_SEED = 1000, 900000


def block(inside: int, outside: int, kernel: int = 3, stride: int = 1, dilation: int = 1) -> nn.Sequential:
    return nn.Sequential(
        nn.Conv2d(inside, outside, kernel, stride, dilation * (kernel // 2), dilation, bias=False),
        nn.BatchNorm2d(outside),
        nn.ReLU(),
    )


class MarkerNetwork(nn.Module):
    """About 24 thousand parameters; a cell of the output sees 73 pixels across."""

    def __init__(self) -> None:
        super().__init__()
        self.body = nn.Sequential(
            block(1, 12, kernel=5, stride=2),
            block(12, 24, stride=2),
            block(24, 24),
            block(24, 24, dilation=2),
            block(24, 24, dilation=3),
            block(24, 24),
        )
        self.head = nn.Conv2d(24, 3, 3, 1, 1)
        nn.init.constant_(self.head.bias, 0.0)
        self.head.bias.data[0] = -4.0

    def forward(self, grey: torch.Tensor) -> torch.Tensor:
        return self.head(self.body(grey))


def prepared(grey: np.ndarray) -> np.ndarray:
    return np.sqrt(grey.astype(np.float32) / 255.0)


def changed(example: Example, draw: np.random.Generator, size: tuple[int, int]) -> Example:
    """Turned over, of another size and light, and cut out."""
    grey, dots = example.grey, example.dots.copy()
    if draw.random() < 0.5:
        grey, dots[:, 1] = grey[::-1], HEIGHT - 1 - dots[:, 1]
    if draw.random() < 0.5:
        grey, dots[:, 0] = grey[:, ::-1], WIDTH - 1 - dots[:, 0]
    scale = float(np.exp(draw.uniform(np.log(0.55), np.log(1.3))))
    height, width = size
    u, v = (dots[draw.integers(len(dots)), :2] if len(dots) else (WIDTH / 2, HEIGHT / 2))
    corner_u = u * scale - draw.uniform(0.1, 0.9) * width
    corner_v = v * scale - draw.uniform(0.1, 0.9) * height
    matrix = np.array([[scale, 0, -corner_u], [0, scale, -corner_v]], np.float32)
    sharp = grey if scale > 0.9 else cv2.GaussianBlur(grey, (0, 0), 0.35 / scale)
    cut = cv2.warpAffine(np.ascontiguousarray(sharp), matrix, (width, height), flags=cv2.INTER_LINEAR).astype(np.float32)
    dots = dots * scale
    dots[:, 0] -= corner_u
    dots[:, 1] -= corner_v
    if draw.random() < 0.4:
        cut = cv2.GaussianBlur(cut, (0, 0), draw.uniform(0.3, 2.0))
    cut = cut * np.exp(draw.uniform(-0.6, 0.4)) + draw.uniform(0, 6)
    cut += draw.normal(0, draw.uniform(0.2, 3.0), cut.shape)
    inside = (dots[:, 0] > 1) & (dots[:, 1] > 1) & (dots[:, 0] < width - 2) & (dots[:, 1] < height - 2)
    return Example(np.clip(np.rint(cut), 0, 255).astype(np.uint8), dots[inside])


def targets(example: Example) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """How surely (1 at a middle, falling off around it), the logarithms of half extents, and where they count."""
    height, width = (-(-n // STRIDE) for n in example.grey.shape)
    sure = np.zeros((height, width), np.float32)
    halves = np.zeros((2, height, width), np.float32)
    counts = np.zeros((height, width), np.float32)
    y, x = np.mgrid[0:height, 0:width] * float(STRIDE)
    for u, v, half_u, half_v in example.dots:
        spread = 2.5
        near = np.exp(-0.5 * (((x - u) / spread) ** 2 + ((y - v) / spread) ** 2))
        cell_x, cell_y = int(min(width - 1, round(u / STRIDE))), int(min(height - 1, round(v / STRIDE)))
        near[cell_y, cell_x] = 1.0
        sure = np.maximum(sure, near)
        around = np.s_[max(0, cell_y - 1) : cell_y + 2, max(0, cell_x - 1) : cell_x + 2]
        halves[0][around], halves[1][around] = np.log(max(half_u, 0.5)), np.log(max(half_v, 0.5))
        counts[around] = 1.0
    return sure, halves, counts


def loss_of(out: torch.Tensor, sure: torch.Tensor, halves: torch.Tensor, counts: torch.Tensor) -> torch.Tensor:
    logit = out[:, 0]
    p = torch.sigmoid(logit).clamp(1e-5, 1 - 1e-5)
    is_middle = (sure == 1.0).float()
    found = -is_middle * (1 - p) ** 2 * torch.log(p)
    false = -(1 - is_middle) * (1 - sure) ** 4 * p**2 * torch.log(1 - p)
    middles = is_middle.sum().clamp(min=1)
    extents = (counts[:, None] * F.smooth_l1_loss(out[:, 1:], halves, reduction="none")).sum() / counts.sum().clamp(min=1)
    return (found.sum() + false.sum()) / middles + 0.2 * extents


def peaks(logit: np.ndarray, least: float) -> np.ndarray:
    """(u, v) of the cells that are surer than all around them."""
    highest = cv2.dilate(logit, np.ones((3, 3), np.uint8))
    y, x = np.nonzero((logit == highest) & (logit > least))
    return np.stack([x, y], axis=1) * float(STRIDE)


def judge(network: nn.Module, examples: list[Example]) -> str:
    network.eval()
    lines = []
    for least in (-2.0, -1.0, 0.0):
        dots = found = false = 0
        for example in examples:
            with torch.no_grad():
                out = network(torch.from_numpy(prepared(example.grey))[None, None])[0, 0].numpy()
            places = peaks(out, least)
            dots += len(example.dots)
            near = np.zeros(len(places), bool)
            for u, v, half_u, half_v in example.dots:
                hit = (np.abs(places[:, 0] - u) < half_u + 4) & (np.abs(places[:, 1] - v) < half_v + 4)
                found += bool(hit.any())
                near |= hit
            false += int((~near).sum())
        lines.append(f"above {least}: found {found} of {dots}, false {false} in {len(examples)} pictures")
    network.train()
    return "\n".join(lines)


def rendered(program: Path, first: int, fingers: int, frames: int, keep: Path | None) -> list[Example]:
    kept = keep / f"examples_{first}_{fingers}_{frames}.npz" if keep else None
    if kept and kept.exists():
        stored = np.load(kept, allow_pickle=True)
        return [Example(grey, dots) for grey, dots in zip(stored["grey"], stored["dots"])]
    examples: list[Example] = []
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(first, first + fingers):
            examples += render(program, Path(folder), seed, frames)
    if kept:
        kept.parent.mkdir(parents=True, exist_ok=True)
        dots = np.empty(len(examples), object)
        dots[:] = [example.dots for example in examples]
        np.savez(kept, grey=np.stack([example.grey for example in examples]), dots=dots)
    return examples


def check_picture(width: int, height: int) -> np.ndarray:
    """What the program makes for itself: ramps, and discs of four sizes, bright and dark."""
    y, x = np.mgrid[0:height, 0:width]
    grey = 40 + (x * 3 + y * 5) % 64
    for k in range(8):
        radius = 2 + k // 2
        inside = (x - (12 + 11 * k)) ** 2 + (y - (16 + 6 * k)) ** 2 <= radius * radius
        grey = np.where(inside, 200 if k % 2 == 0 else 5, grey)
    return grey.astype(np.uint8)


def write(network: MarkerNetwork, folder: Path) -> None:
    network.eval()
    file = folder / "marker_network.onnx"
    torch.onnx.export(
        network,
        torch.zeros(1, 1, HEIGHT, WIDTH),
        str(file),
        opset_version=11,
        input_names=["grey"],
        output_names=["dots"],
    )
    width, height = 104, 72
    with torch.no_grad():
        out = network(torch.from_numpy(prepared(check_picture(width, height)))[None, None])[0].numpy()
    every = 13
    numbers = ", ".join(f"{value:.5f}" for value in out.ravel()[::every])
    (folder / "marker_network.yaml").write_text(
        "# Written by train_marker_network.py with the network beside it: what comes out of a picture that the program makes\n"
        "# for itself (its size in px), every so many numbers of the output.\n"
        f"picture: [{width}, {height}]\n"
        f"every: {every}\n"
        "tolerance: 0.001\n"
        f"output: [{numbers}]\n"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, required=True, help="alltact, which renders the pictures")
    parser.add_argument("--fingers", type=int, default=110, help="to train on (default 110)")
    parser.add_argument("--minutes", type=float, default=14, help="of training (default 14)")
    parser.add_argument("--keep", type=Path, help="folder in which rendered pictures are kept for the next time")
    parser.add_argument("-o", "--output", type=Path, default=Path(__file__).parent, help="folder (default: this one)")
    arguments = parser.parse_args()
    torch.set_num_threads(1)
    cv2.setNumThreads(1)
    torch.manual_seed(1)
    draw = np.random.default_rng(1)
    training = rendered(arguments.program, FIRST_TRAINING_SEED, arguments.fingers, 3, arguments.keep)
    judging = rendered(arguments.program, FIRST_JUDGING_SEED, 16, 2, arguments.keep)
    print(f"{len(training)} pictures to train on, {len(judging)} of other fingers to judge by", flush=True)
    network = MarkerNetwork()
    print(f"{sum(p.numel() for p in network.parameters())} parameters", flush=True)
    optimiser = torch.optim.AdamW(network.parameters(), lr=4e-3, weight_decay=1e-4)
    start, step, last_report, mean = time.monotonic(), 0, 0.0, None
    while (done := (time.monotonic() - start) / (60 * arguments.minutes)) < 1:
        for group in optimiser.param_groups:
            group["lr"] = 5e-3 * min(1.0, (step + 1) / 50) * (0.02 + 0.98 * 0.5 * (1 + np.cos(np.pi * done)))
        batch = [changed(training[draw.integers(len(training))], draw, (192, 256)) for _ in range(6)]
        wanted = [targets(example) for example in batch]
        grey = torch.from_numpy(np.stack([prepared(example.grey) for example in batch])[:, None])
        sure, halves, counts = (torch.from_numpy(np.stack([w[k] for w in wanted])) for k in range(3))
        loss = loss_of(network(grey), sure, halves, counts)
        optimiser.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(network.parameters(), 5.0)
        optimiser.step()
        mean = float(loss) if mean is None else 0.98 * mean + 0.02 * float(loss)
        step += 1
        if done - last_report > 0.2:
            last_report = done
            print(f"{100 * done:.0f} %: step {step}, loss {mean:.3f}\n{judge(network, judging)}", flush=True)
    print(f"step {step}, loss {mean:.3f}\n{judge(network, judging)}")
    write(network, arguments.output)


if __name__ == "__main__":
    main()
