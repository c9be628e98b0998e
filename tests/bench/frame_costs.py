#!/usr/bin/python3
"""What the steps of a frame cost and how far off its depth is, beside the source paper's formulas in NumPy and OpenCV on the same
pictures of the demonstration's finger.
    frame_costs.py BUILD [--demo DIR] [--repeat N] [--json]
BUILD: where app/alltact and tests/frame_costs were built (build/release); DIR: what `alltact demo` left there, or shall leave. Prints a
table in Markdown: milliseconds of one thread's processor time, the bytes that a step cannot do without, and both beside what a copy of
these bytes and what the formulas take."""
import argparse, json, os, subprocess, sys, tempfile

PEERS = {"edges": "edges", "shape": "shape", "markers": "markers", "reference": "reference", "depth": "depth", "total": "total"}


def told_by(command):
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{' '.join(command)}: {run.stderr.strip() or run.stdout.strip()}")
    return run.stdout


def keep_nothing_of_the_user(scratch):
    """Programs that are started from here keep what they keep for the next time in this folder."""
    os.environ["XDG_CACHE_HOME"] = f"{scratch}/cache"


def measure(build, demo, repeat):
    program, bench = f"{build}/app/alltact", os.path.dirname(os.path.abspath(__file__))
    if not os.path.exists(f"{demo}/finger/finger.yaml"):
        told_by([program, "demo", "-o", demo])
    ours = json.loads(told_by([f"{build}/tests/frame_costs", f"{demo}/finger", f"{demo}/objects", str(repeat)]))
    with tempfile.TemporaryDirectory() as out:
        told_by([program, "export", f"{demo}/finger", "--to", "zip", "-o", out])
        pictures = [f"{demo}/objects", "--truth", f"{demo}/objects", "--ours", f"{demo}/results", "--repeat", str(repeat)]
        formulas = json.loads(told_by(["/usr/bin/python3", f"{bench}/paper_formulas.py", f"{out}/finger.zip", *pictures]))
    # Points are made on request only: the frame's total is compared without.
    formulas["ms"]["total"] -= formulas["ms"]["points"]
    return {"ours": ours, "formulas": formulas}


def table(told):
    ours, formulas = told["ours"], told["formulas"]["ms"]
    lines = ["| step | ms | MB moved | of a copy of them | formulas, ms | times faster |", "| --- | --- | --- | --- | --- | --- |"]
    for name, step in ours["steps"].items():
        peer = formulas.get(PEERS.get(name, ""))
        copy = f"{step['ms'] / step['copy_ms']:.1f}" if step["bytes"] > 1e5 else ""
        faster = f"{peer:.1f} | {peer / step['ms']:.0f}" if peer else " | "
        lines.append(f"| {name} | {step['ms']:.2f} | {step['bytes'] / 1e6:.2f} | {copy} | {faster} |")
    for where, title in (("pressed", "where it is pressed"), ("face", "over the whole face")):
        mine, theirs = told["formulas"]["our_error"][where], told["formulas"]["error"][where]
        lines.append(f"\n{title}: rms error {mine['rms_mm']:.4f} mm, the formulas' {theirs['rms_mm']:.4f} mm; "
                     f"95 % within {mine['p95_mm']:.4f} and {theirs['p95_mm']:.4f} mm")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build"), parser.add_argument("--demo"), parser.add_argument("--repeat", type=int, default=9)
    parser.add_argument("--json", action="store_true")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        keep_nothing_of_the_user(scratch)
        told = measure(args.build, args.demo or f"{scratch}/demo", args.repeat)
    print(json.dumps(told, indent=1) if args.json else table(told))


if __name__ == "__main__":
    main()
