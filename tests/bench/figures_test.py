"""The statistics by which builds are compared, against what can be counted by hand and against chance itself."""
import itertools, json, random, statistics, unittest

import figures


class RatioWithInterval(unittest.TestCase):
    def test_three_runs_are_as_counted(self):
        # Of the 27 ways to draw three of three ratios the median is the least in 7, the middle one in 13, the greatest in 7.
        ratios = [1.0, 1.1, 1.3]
        medians = sorted(statistics.median(draw) for draw in itertools.product(ratios, repeat=3))
        self.assertEqual([medians.count(r) for r in ratios], [7, 13, 7])
        self.assertEqual(figures.ratio_with_interval([2, 2, 2], [2 * r for r in ratios]), (1.1, 1.0, 1.3))

    def test_pairs_take_out_what_disturbs_both(self):
        draw = random.Random(3)
        load = [draw.uniform(1, 5) for _ in range(15)]
        middle, low, high = figures.ratio_with_interval(load, [1.08 * value for value in load])
        for value in (middle, low, high):
            self.assertAlmostEqual(value, 1.08)

    def test_the_interval_holds_the_truth_as_often_as_it_says(self):
        draw, hits, worlds = random.Random(5), 0, 400
        for _ in range(worlds):
            before = [draw.lognormvariate(0, 0.05) for _ in range(15)]
            now = [1.02 * draw.lognormvariate(0, 0.05) for _ in range(15)]
            _, low, high = figures.ratio_with_interval(before, now, draws=400)
            hits += low <= 1.02 <= high
        self.assertGreater(hits / worlds, 0.90)
        self.assertLess(hits / worlds, 0.99)

    def test_growth_is_told_where_it_is_sure(self):
        def told(growth, noise):
            draw = random.Random(7)
            before = [draw.lognormvariate(0, noise) for _ in range(15)]
            return figures.has_grown(figures.ratio_with_interval(before, [growth * draw.lognormvariate(0, noise) for _ in before]))

        self.assertFalse(told(1.00, 0.02))
        self.assertFalse(told(1.03, 0.01))
        self.assertTrue(told(1.10, 0.02))
        self.assertFalse(told(1.10, 0.30), "that may be chance")
        self.assertFalse(told(0.50, 0.02))


class Tables(unittest.TestCase):
    def test_what_grew_is_named_and_what_is_new_is_not(self):
        runs = [1.0, 1.01, 0.99, 1.0, 1.02]
        lines, grown = figures.compared({"a": runs, "b": runs}, {"a": [1.2 * r for r in runs], "b": runs, "c": runs})
        self.assertEqual(grown, ["a"])
        self.assertEqual(len(lines), 5)
        self.assertIn("| c | | 1 | new | |", lines)

    def test_readme_shows_the_figures(self):
        told = json.loads(figures.FIGURES.read_text(encoding="utf-8"))
        text = figures.README.read_text(encoding="utf-8")
        self.assertEqual(figures.with_tables(text, told), text, "run tests/bench/figures.py readme")
        told["steps"]["edges"]["ms"] = 9.99
        self.assertIn("| edges | 9.99 |", figures.with_tables(text, told))
        told["accuracy"][0]["measured"] = 7.77
        self.assertIn("| 7.77 mm |", figures.with_tables(text, told))


if __name__ == "__main__":
    unittest.main()
