#!/usr/bin/python3
"""The project's figures: the tables of tests/bench/README.md are made from them, and two builds are compared by them.
    figures.py readme [--check]                 writes these tables anew from figures.json, or fails where they differ
    figures.py renew BUILD                      measures the steps of a frame and the demonstration, and keeps them in figures.json
    figures.py against COMMIT [--runs N]        builds COMMIT beside, runs both builds turn by turn, and fails where a watched
                                                figure grew by more than 5 % beyond its interval
Times are of the processor, so that other programs disturb them little. A figure's ratio is the median over the runs of (this build /
COMMIT), both of the same turn; its interval holds 95 % of the medians of runs drawn anew from these (percentile bootstrap: Efron and
Tibshirani, An Introduction to the Bootstrap, 1993, chapter 13)."""
import argparse, json, os, random, re, statistics, subprocess, sys, tempfile
from pathlib import Path

import frame_costs

HERE = Path(__file__).resolve().parent
TOP = HERE.parent.parent
FIGURES = HERE / "figures.json"
README = HERE / "README.md"
MOST_GROWTH = 1.05


def ratio_with_interval(before, now, draws=4000, seed=1):
    """Median of now[i] / before[i], and the interval that holds 95 % of what it would be on runs drawn anew."""
    ratios = [b / a for a, b in zip(before, now, strict=True)]
    draw = random.Random(seed)
    medians = sorted(statistics.median(draw.choices(ratios, k=len(ratios))) for _ in range(draws))
    return statistics.median(ratios), medians[int(0.025 * draws)], medians[int(0.975 * draws) - 1]


def has_grown(interval):
    """Even the interval's lower end is above what a figure may grow."""
    return interval[1] > MOST_GROWTH


def number(value):
    """A ratio as in README.md: whole from ten on."""
    return f"{value:.0f}" if value >= 10 else f"{value:.1f}"


def accuracy_table(told):
    lines = ["| | measured | must be |", "| --- | --- | --- |"]
    for row in told["accuracy"]:
        lines.append(f"| {row['what']} | {row['measured']:g} {row['unit']} | {row['must_be']:g} {row['unit']} |")
    return lines


def steps_table(told):
    lines = ["| step | ms | MB moved | of a copy of them | formulas, ms | times faster |", "| --- | --- | --- | --- | --- | --- |"]
    for name, step in told["steps"].items():
        copy = number(step["of_a_copy"]) if "of_a_copy" in step else ""
        peer = step.get("formulas_ms")
        faster = f"{peer:.1f} | {peer / step['ms']:.0f}" if peer else "|"
        cells = [name, f"{step['ms']:.2f}", f"{step['bytes'] / 1e6:.2f}", copy, faster]
        lines.append(re.sub(r"\|  +\|", "| |", f"| {' | '.join(cells)} |"))
    return lines


def with_tables(readme, told):
    """README.md with its tables replaced, each found by its first line."""
    lines = readme.split("\n")
    for table in (accuracy_table(told), steps_table(told)):
        begin = lines.index(table[0])
        end = next(i for i in range(begin, len(lines)) if not lines[i].startswith("|"))
        lines[begin:end] = table
    return "\n".join(lines)


def readme(is_check):
    text = README.read_text(encoding="utf-8")
    new = with_tables(text, json.loads(FIGURES.read_text(encoding="utf-8")))
    if is_check and new != text:
        sys.exit("The tables of tests/bench/README.md are not those of figures.json. Run tests/bench/figures.py readme.")
    if new != text:
        README.write_text(new, encoding="utf-8")


def rounded(value, digits=3):
    return float(f"{value:.{digits}g}")


def text_of(told):
    """One figure a line, so that a change of one is seen as such."""
    def row(value):
        return json.dumps(value)
    lines = [f' "about": {row(told["about"])}', ' "accuracy": [\n  ' + ",\n  ".join(map(row, told["accuracy"])) + "\n ]"]
    for part in ("steps", "watched"):
        rows = ",\n".join(f"  {row(name)}: {row(value)}" for name, value in told[part].items())
        lines.append(f' "{part}": {{\n{rows}\n }}')
    return "{\n" + ",\n".join(lines) + "\n}\n"


def renew(build):
    told = json.loads(FIGURES.read_text(encoding="utf-8"))
    run(["cmake", "--build", build, "--target", "frame_costs", "alltact"])
    with tempfile.TemporaryDirectory() as scratch:
        frame_costs.keep_nothing_of_the_user(scratch)
        costs = frame_costs.measure(build, f"{scratch}/demo", 9)
        report = json.loads(Path(scratch, "demo/report.json").read_text())
    for name, step in costs["ours"]["steps"].items():
        row = told["steps"][name] = {"ms": rounded(step["ms"]), "bytes": int(step["bytes"])}
        if step["bytes"] > 1e5:
            row["of_a_copy"] = rounded(step["ms"] / step["copy_ms"])
        if name in frame_costs.PEERS:
            row["formulas_ms"] = rounded(costs["formulas"]["ms"][frame_costs.PEERS[name]])
    joint = next(entry for entry in report.values() if isinstance(entry, dict))
    for row in told["accuracy"]:
        row["measured"] = rounded(joint[row["key"]], 2)
    FIGURES.write_text(text_of(told), encoding="utf-8")


def run(command, **rest):
    done = subprocess.run(command, capture_output=True, text=True, **rest)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: {done.stderr.strip() or done.stdout.strip()}")
    return done.stdout


def build_of(commit):
    """A release build of a commit in a work tree beside the others', with what is measured."""
    name = run(["git", "-C", TOP, "rev-parse", "--short=12", "--verify", f"{commit}^{{commit}}"]).strip()
    tree = TOP / "build" / "against" / name
    if not tree.exists():
        run(["git", "-C", TOP, "worktree", "add", "--detach", tree, name])
    print(f"Building {name}", flush=True)
    run([tree / "packaging/build", "release", "alltact_bench", "frame_costs"])
    return tree / "build" / "release"


def measured(build, demo, watched):
    """Every watched figure, once: milliseconds of the processor."""
    steps = json.loads(run([build / "tests/frame_costs", f"{demo}/finger", f"{demo}/objects", "3"]))["steps"]
    names = [one["benchmark"] for one in watched.values() if "benchmark" in one]
    text = run([build / "tests/alltact_bench", "--benchmark_format=json", f"--benchmark_filter=^({'|'.join(names)})$"])
    benches = {one["name"]: one["cpu_time"] for one in json.loads(text)["benchmarks"]}
    values = {}
    for name, one in watched.items():
        value = steps.get(one["step"], {}).get("ms") if "step" in one else benches.get(one["benchmark"])
        if value is not None:
            values[name] = value
    return values


def compared(before, now):
    """Lines of a table and the names of what grew, from the runs of both builds, each a list by figure."""
    lines, grown = ["| figure | before, ms | now, ms | ratio | 95 % |", "| --- | --- | --- | --- | --- |"], []
    for name, values in now.items():
        if len(before.get(name, [])) != len(values):
            lines.append(f"| {name} | | {statistics.median(values):.3g} | new | |")
            continue
        interval = ratio_with_interval(before[name], values)
        if has_grown(interval):
            grown.append(name)
        medians = f"{statistics.median(before[name]):.3g} | {statistics.median(values):.3g}"
        lines.append(f"| {name} | {medians} | {interval[0]:.3f} | {interval[1]:.3f} to {interval[2]:.3f} |")
    return lines, grown


def against(commit, runs):
    watched = json.loads(FIGURES.read_text(encoding="utf-8"))["watched"]
    builds = [build_of(commit), TOP / "build" / "release"]
    run([TOP / "packaging/build", "release", "alltact_bench", "frame_costs", "alltact"])
    told = [{}, {}]
    with tempfile.TemporaryDirectory() as scratch:
        frame_costs.keep_nothing_of_the_user(scratch)
        demo = f"{scratch}/demo"
        run([builds[1] / "app/alltact", "demo", "-o", demo])
        for turn in range(runs):
            for which in ((0, 1), (1, 0))[turn % 2]:
                for name, value in measured(builds[which], demo, watched).items():
                    told[which].setdefault(name, []).append(value)
            print(f"turn {turn + 1} of {runs}", file=sys.stderr, flush=True)
    lines, grown = compared(*told)
    print("\n".join(lines))
    for name in grown:
        print(f"FAILED: {name} takes more than {100 * (MOST_GROWTH - 1):.0f} % longer than at {commit}")
    if not grown:
        print(f"passed: none of {len(told[1])} figures grew by more than {100 * (MOST_GROWTH - 1):.0f} % since {commit}")
    sys.exit(bool(grown))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ways = parser.add_subparsers(dest="way", required=True)
    ways.add_parser("readme").add_argument("--check", action="store_true")
    ways.add_parser("renew").add_argument("build")
    beside = ways.add_parser("against")
    beside.add_argument("commit"), beside.add_argument("--runs", type=int, default=15)
    args = parser.parse_args()
    if args.way == "readme":
        readme(args.check)
    elif args.way == "renew":
        renew(args.build)
    else:
        against(args.commit, args.runs)


if __name__ == "__main__":
    main()
