#include "core/sensing/reference/marker_table.h"

#include "core/base/atomic_file.h"
#include "core/base/message.h"
#include "core/camera/camera.h"

#include <charconv>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr std::string_view kColumns = "frame,number,u,v,seen,radius,contrast";
constexpr double kMarkerSdPx = 0.1;  // of recorded markers, as measured

Message advice() { return en::say("create the reference again from the recording"); }

struct Line {
  int frame = 0, number = 0, seen = 0;
  double u = 0, v = 0, radius = 0, contrast = 0;
};

template <class T>
bool take(std::string_view& text, T& value, bool last) {
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (last) return text.empty();
  if (text.empty() || text.front() != ',') return false;
  text.remove_prefix(1);
  return true;
}

bool parse(std::string_view text, Line& line) {
  constexpr double kMaxValue = 1e6;
  return take(text, line.frame, false) && take(text, line.number, false) &&
         take(text, line.u, false) && take(text, line.v, false) && take(text, line.seen, false) &&
         take(text, line.radius, false) && take(text, line.contrast, true) && line.frame >= 0 &&
         std::abs(line.u) < kMaxValue && std::abs(line.v) < kMaxValue &&
         (line.seen == 0 || line.seen == 1) && line.radius > 0 && line.radius < kMaxValue &&
         std::abs(line.contrast) < kMaxValue && line.contrast != 0;
}

// Splits a text into lines; every line must end with a newline.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  std::optional<std::string_view> next() {
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    ++number_;
    return line;
  }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  [[nodiscard]] int number() const { return number_; }

 private:
  std::string_view rest_;
  int number_ = 0;
};

void set_typical_positions(MarkerTable& table) {
  for (std::size_t m = 0; m < table.typical.size(); ++m) {
    const auto k = static_cast<Eigen::Index>(2 * m);
    table.typical[m].u = table.layouts.col(k).mean();
    table.typical[m].v = table.layouts.col(k + 1).mean();
    table.typical[m].upper = 2 * m < table.typical.size();
  }
}

}  // namespace

Result<MarkerTable> MarkerTable::load(const std::filesystem::path& file, int marker_count) {
  if (marker_count <= 0)
    return Error{en::say("the finger has no markers, so it has no marker table"), file.string(),
                 en::say("set markers.per_row")};
  const auto content = read_file(file);
  if (!content) return content.error();
  Lines lines(*content);
  const auto wrong = [&](Message what) {
    return Error{std::move(what), en::say("{}, line {}", file.string(), lines.number()), advice()};
  };
  const auto first = lines.next();
  if (!first || *first != kColumns)
    return Error{en::say("not a marker table; its first line must be '{}'", std::string(kColumns)),
                 file.string(), advice()};
  MarkerTable table;
  std::vector<double> positions;
  const auto count = static_cast<std::size_t>(marker_count);
  std::size_t inside = 0;  // markers of the current frame read so far
  for (;;) {
    const auto text = lines.next();
    if (!text) return wrong(en::say("the table ends too early"));
    if (text->starts_with("end,")) {
      std::size_t frames = 0;
      std::string_view rest = text->substr(4);
      if (!take(rest, frames, true) || frames != table.frames.size() || inside != 0 ||
          !lines.at_end())
        return wrong(en::say("'{}' is not the last line of a table with {} frames",
                             printable(*text), table.frames.size()));
      break;
    }
    Line line;
    if (!parse(*text, line))
      return wrong(en::say("'{}' does not hold valid values of '{}'", printable(*text),
                           std::string(kColumns)));
    if (line.number != static_cast<int>(inside))
      return wrong(en::say("marker {} stands where marker {} of {} is expected", line.number,
                           inside, marker_count));
    if (inside == 0) {
      if (!table.frames.empty() && line.frame <= table.frames.back())
        return wrong(en::say("frame {} comes after frame {}", line.frame, table.frames.back()));
      table.frames.push_back(line.frame);
      table.seen.emplace_back(count, 0);
    } else if (line.frame != table.frames.back()) {
      return wrong(en::say("frame {} has {} markers instead of {}", table.frames.back(), inside,
                           marker_count));
    }
    if (table.typical.size() <= inside) {
      table.typical.push_back({0, 0, line.radius, line.contrast, 0, false});
    } else if (table.typical[inside].radius_px != line.radius ||
               table.typical[inside].contrast != line.contrast) {
      return wrong(
          en::say("marker {} has a different radius or contrast than before", line.number));
    }
    table.seen.back()[inside] = static_cast<char>(line.seen);
    positions.push_back(line.u);
    positions.push_back(line.v);
    inside = (inside + 1) % count;
  }
  if (table.frames.empty()) return wrong(en::say("the table contains no frames"));
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  table.layouts =
      Eigen::Map<const Rows>(positions.data(), static_cast<Eigen::Index>(table.frames.size()),
                             Eigen::Index{2} * marker_count);
  set_typical_positions(table);
  return table;
}

Status MarkerTable::save(const std::filesystem::path& file) const {
  std::string text(kColumns);
  text += '\n';
  for (std::size_t i = 0; i < frames.size(); ++i)
    for (std::size_t m = 0; m < typical.size(); ++m) {
      const auto row = static_cast<Eigen::Index>(i), k = static_cast<Eigen::Index>(2 * m);
      text +=
          fmt::format("{},{},{},{},{},{},{}\n", frames[i], m, layouts(row, k), layouts(row, k + 1),
                      static_cast<int>(seen[i][m]), typical[m].radius_px, typical[m].contrast);
    }
  text += fmt::format("end,{}\n", frames.size());
  return write_file_atomically(file, text);
}

MarkerTable rows_of(const MarkerTable& table, const std::vector<std::size_t>& rows) {
  MarkerTable part;
  part.typical = table.typical;
  part.layouts.resize(static_cast<Eigen::Index>(rows.size()), table.layouts.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    part.frames.push_back(table.frames[rows[i]]);
    part.seen.push_back(table.seen[rows[i]]);
    part.layouts.row(static_cast<Eigen::Index>(i)) =
        table.layouts.row(static_cast<Eigen::Index>(rows[i]));
  }
  return part;
}

MarkerTable reduced_table(MarkerTable table, int by) {
  if (by == 1) return table;
  table.layouts = table.layouts.unaryExpr([by](double px) { return reduced_px(px, by); });
  for (Dot& dot : table.typical) {
    dot.u = reduced_px(dot.u, by);
    dot.v = reduced_px(dot.v, by);
    dot.radius_px /= by;
  }
  return table;
}

Markers markers_of(const Eigen::MatrixXd& layouts, Eigen::Index row,
                   const std::vector<char>& seen) {
  Markers markers(static_cast<std::size_t>(layouts.cols() / 2));
  for (std::size_t m = 0; m < markers.size(); ++m) {
    const auto k = static_cast<Eigen::Index>(2 * m);
    markers[m] = {layouts(row, k), layouts(row, k + 1), seen[m] != 0, kMarkerSdPx};
  }
  return markers;
}

}  // namespace alltact
