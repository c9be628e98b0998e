"""Runs the tests of this folder; where GTEST_OUTPUT names a folder for reports (xml:FOLDER/), leaves one as Google Test does."""
import os, sys, unittest
from pathlib import Path
from xml.sax.saxutils import quoteattr


def cases(suite):
    for part in suite:
        yield from cases(part) if isinstance(part, unittest.TestSuite) else [part]


def report(all_cases: list, result: unittest.TestResult) -> str:
    failed = {str(case): text for case, text in result.failures + result.errors}
    skipped = {str(case): reason for case, reason in result.skipped}
    lines = [f'<testsuites tests="{len(all_cases)}" failures="{len(failed)}" disabled="0" errors="0" time="0" name="AllTests">']
    for case in all_cases:
        kind, _, name = case.id().rpartition(".")
        inside = f"<failure message={quoteattr(failed[str(case)])}/>" if str(case) in failed else ""
        inside += f"<skipped message={quoteattr(skipped[str(case)])}/>" if str(case) in skipped else ""
        lines.append(f'<testcase name="{name}" classname="{kind}">{inside}</testcase>')
    return "\n".join([*lines, "</testsuites>", ""])


if __name__ == "__main__":
    suite = unittest.defaultTestLoader.discover(str(Path(__file__).parent), "*_test.py")
    all_cases = list(cases(suite))
    result = unittest.TextTestRunner(verbosity=2).run(suite)
    kind, _, folder = os.environ.get("GTEST_OUTPUT", "").partition(":")
    if kind == "xml" and folder.endswith("/"):
        Path(folder, "python_tests.xml").write_text(report(all_cases, result), encoding="utf-8")
    sys.exit(not result.wasSuccessful())
