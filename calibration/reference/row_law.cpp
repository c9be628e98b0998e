#include "calibration/reference/row_law.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace alltact {
namespace {

constexpr int kMaxMissing = 2;  // in a row
constexpr int kSlots = kMaxMissing + 1;
constexpr int kReach = 8;         // dots further apart in the order are no neighbours
constexpr double kGain = 4.0;     // of a dot that is in every frame
constexpr double kMissing = 2.5;  // cost of a missing dot
constexpr double kStepSd = 0.12;  // of a step's logarithm against the law
constexpr double kSizeSd = 0.3, kContrastSd = 0.6, kOffSd = 0.06;  // from one dot to the next
constexpr double kGrowthSd = 0.4;  // of a step against the one before
constexpr double kUnlikeSd = 0.2;  // of one side's growth against the other's
constexpr double kMinStepMm = 0.2;
constexpr double kNone = -std::numeric_limits<double>::infinity();

double square(double x) {
  return x * x;
}

/// One row: its tracks by slot, counted from its first dot.
struct Row {
  std::vector<int> track_of;
  double worth = 0;
};

/// Rows of one side for one law.
class RowSearch {
 public:
  RowSearch(const std::vector<DotTrack>& tracks, const std::vector<int>& side, int per_row)
      : tracks_(tracks), side_(side), per_row_(per_row) {
    best_.resize(side.size() * kReach * kSlots * static_cast<std::size_t>(per_row));
  }

  /// growth: of the logarithm of the step, from one to the next.
  Row operator()(double growth) {
    std::fill(best_.begin(), best_.end(), State{});
    Row row = best_single();
    std::size_t end = best_.size();
    for (int j = 0; j < count(); ++j)
      for (int back = 1; back <= std::min(kReach, j); ++back)
        for (int slots = 1; slots <= kSlots; ++slots) {
          const double pair = pair_worth(j - back, j, slots);
          if (pair == kNone) continue;
          start(j, back, slots, pair);
          extend(j, back, slots, pair, growth);
          for (int slot = slots; slot < per_row_; ++slot) {
            const std::size_t at = index(j, back, slots, slot);
            if (best_[at].worth > row.worth) row.worth = best_[at].worth, end = at;
          }
        }
    if (end < best_.size()) row.track_of = trace(end);
    return row;
  }

 private:
  struct State {
    double worth = kNone;
    std::size_t before = SIZE_MAX;
  };

  [[nodiscard]] int count() const { return static_cast<int>(side_.size()); }
  [[nodiscard]] const DotTrack& track(int i) const {
    return tracks_[static_cast<std::size_t>(side_[static_cast<std::size_t>(i)])];
  }
  [[nodiscard]] std::size_t index(int j, int back, int slots, int slot) const {
    const auto pair = static_cast<std::size_t>((j * kReach + back - 1) * kSlots + slots - 1);
    return pair * static_cast<std::size_t>(per_row_) + static_cast<std::size_t>(slot);
  }

  [[nodiscard]] Row best_single() const {
    Row row;
    for (int i = 0; i < count(); ++i)
      if (kGain * track(i).support > row.worth)
        row = {{side_[static_cast<std::size_t>(i)]}, kGain * track(i).support};
    return row;
  }

  /// Score of the second dot of a pair, `slots` after the first.
  [[nodiscard]] double pair_worth(int i, int j, int slots) const {
    const DotTrack &a = track(i), &b = track(j);
    if (b.along_mm - a.along_mm < kMinStepMm) return kNone;
    const double unlike = square((b.log_size - a.log_size) / kSizeSd) +
                          square((b.log_contrast - a.log_contrast) / kContrastSd) +
                          square((b.off_face - a.off_face) / kOffSd);
    return kGain * b.support - kMissing * (slots - 1) - 0.5 * unlike / slots;
  }

  void start(int j, int back, int slots, double pair) {
    if (slots < per_row_)
      best_[index(j, back, slots, slots)].worth = kGain * track(j - back).support + pair;
  }

  void extend(int j, int back, int slots, double pair, double growth) {
    const int i = j - back;
    const double step = (track(j).along_mm - track(i).along_mm) / slots;
    for (int earlier = 1; earlier <= std::min(kReach, i); ++earlier)
      for (int skipped = 1; skipped <= kSlots; ++skipped) {
        const double before = (track(i).along_mm - track(i - earlier).along_mm) / skipped;
        if (before < kMinStepMm / kSlots) continue;
        const double off = std::log(step / before) - 0.5 * growth * (slots + skipped);
        const double added = pair - 0.5 * square(off / kStepSd);
        for (int slot = skipped; slot + slots < per_row_; ++slot) {
          const std::size_t from = index(i, earlier, skipped, slot);
          State& state = best_[index(j, back, slots, slot + slots)];
          if (best_[from].worth + added > state.worth) state = {best_[from].worth + added, from};
        }
      }
  }

  [[nodiscard]] std::vector<int> trace(std::size_t at) const {
    const auto rows = static_cast<std::size_t>(per_row_);
    std::vector<int> track_of(at % rows + 1, -1);
    for (;;) {
      const std::size_t slot = at % rows, pair = at / rows;
      const auto slots = pair % kSlots + 1, back = pair / kSlots % kReach + 1;
      const std::size_t j = pair / kSlots / kReach;
      track_of[slot] = side_[j];
      if (best_[at].before == SIZE_MAX) {
        track_of[slot - slots] = side_[j - back];
        return track_of;
      }
      at = best_[at].before;
    }
  }

  const std::vector<DotTrack>& tracks_;
  const std::vector<int>& side_;
  int per_row_;
  std::vector<State> best_;
};

constexpr double kLawStep = 0.04;
constexpr int kLaws = 12;  // to each side of the even one

double growth_of(int law) {
  return kLawStep * (law - kLaws);
}

/// The best row of one side for each law.
std::vector<Row> rows_by_law(const std::vector<DotTrack>& tracks, bool upper, int per_row) {
  std::vector<int> side;
  for (std::size_t t = 0; t < tracks.size(); ++t)
    if (tracks[t].upper == upper) side.push_back(static_cast<int>(t));
  std::vector<Row> rows(2 * kLaws + 1);
  if (side.empty()) return rows;
  RowSearch search(tracks, side, per_row);
  for (int law = 0; law <= 2 * kLaws; ++law) {
    Row& row = rows[static_cast<std::size_t>(law)];
    row = search(growth_of(law));
    row.worth -= 0.5 * square(growth_of(law) / kGrowthSd);
  }
  return rows;
}

/// The best rows of both sides under nearly the same law. Where one side has so many missing dots
/// that several laws fit, the other side decides. Of equals the law nearest to the even one wins.
std::pair<Row, Row> best_rows(const std::vector<DotTrack>& tracks, int per_row) {
  auto upper = rows_by_law(tracks, true, per_row), lower = rows_by_law(tracks, false, per_row);
  std::pair<std::size_t, std::size_t> best(kLaws, kLaws);
  double most = kNone;
  const auto by_law = [](int n) {  // from the even law outwards
    return kLaws + (n % 2 == 0 ? -n / 2 : (n + 1) / 2);
  };
  for (int n = 0; n <= 2 * kLaws; ++n)
    for (int m = 0; m <= 2 * kLaws; ++m) {
      const auto a = static_cast<std::size_t>(by_law(n)), b = static_cast<std::size_t>(by_law(m));
      const double unlike = (growth_of(by_law(n)) - growth_of(by_law(m))) / kUnlikeSd;
      const double worth = upper[a].worth + lower[b].worth - 0.5 * square(unlike);
      if (worth > most) most = worth, best = {a, b};
    }
  return {std::move(upper[best.first]), std::move(lower[best.second])};
}

/// Score of the alignment of both rows when they begin at these numbers.
double symmetry(const std::vector<DotTrack>& tracks,
                const Row& upper,
                int first_upper,
                const Row& lower,
                int first_lower) {
  const auto& a = upper.track_of;
  const auto& b = lower.track_of;
  const auto along = [&](int track) { return tracks[static_cast<std::size_t>(track)].along_mm; };
  const double length = std::abs(along(a.back()) - along(a.front()));
  const double spacing = a.size() > 1 ? length / (static_cast<double>(a.size()) - 1.0) : 1.0;
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int other = static_cast<int>(i) + first_upper - first_lower;
    if (other < 0 || other >= static_cast<int>(b.size()) || a[i] < 0) continue;
    const int track = b[static_cast<std::size_t>(other)];
    // Rows of different steps never align: the number of bad pairs is meaningless there.
    if (track >= 0)
      sum += std::max(0.0, 0.3 - std::abs(along(a[i]) - along(track)) / std::max(spacing, 1e-3));
  }
  return sum;
}

}  // namespace

NumberedRows choose_rows(const std::vector<DotTrack>& tracks, int per_row) {
  NumberedRows rows;
  rows.track_of.assign(static_cast<std::size_t>(2 * per_row), -1);
  const auto [upper, lower] = best_rows(tracks, per_row);
  int first_upper = 0, first_lower = 0;
  if (!upper.track_of.empty() && !lower.track_of.empty()) {
    double best = kNone;
    for (int a = 0; a + static_cast<int>(upper.track_of.size()) <= per_row; ++a)
      for (int b = 0; b + static_cast<int>(lower.track_of.size()) <= per_row; ++b) {
        const double worth = symmetry(tracks, upper, a, lower, b) - 1e-6 * (a + b);
        if (worth > best) best = worth, first_upper = a, first_lower = b;
      }
  }
  const auto number = [&](const Row& row, int first) {
    for (std::size_t slot = 0; slot < row.track_of.size(); ++slot)
      rows.track_of[slot + static_cast<std::size_t>(first)] = row.track_of[slot];
  };
  number(upper, first_upper);
  number(lower, per_row + first_lower);
  rows.worth = upper.worth + lower.worth;
  return rows;
}

}  // namespace alltact
