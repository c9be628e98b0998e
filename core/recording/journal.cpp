#include "core/recording/journal.h"

#include "core/base/atomic_file.h"
#include "core/base/result.h"
#include "core/base/slow_disk.h"
#include "core/recording/durable_file.h"

#include <cerrno>
#include <charconv>

#include <fcntl.h>
#include <unistd.h>

namespace alltact {
namespace {

constexpr std::string_view kFormat = "# alltact-frames/1\n";
constexpr std::string_view kColumns = "frame,time_ns,sequence,controls\n";

Message writing() { return en::say("could not write the recording's journal"); }

/// Removes the first line from the text and returns it; empty where no complete line is left.
std::optional<std::string_view> take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return line;
}

/// Removes the number and its comma from the line.
template <class T>
bool take_number(std::string_view& line, T& number) {
  const auto [end, status] = std::from_chars(line.data(), line.data() + line.size(), number);
  if (status != std::errc{} || end == line.data() + line.size() || *end != ',') return false;
  line.remove_prefix(static_cast<std::size_t>(end - line.data()) + 1);
  return true;
}

/// The same, which may be missing.
template <class T>
bool take_number(std::string_view& line, std::optional<T>& number) {
  if (line.starts_with(',')) {
    line.remove_prefix(1);
    return true;
  }
  return take_number(line, number.emplace());
}

/// A field of a CSV line: quoted where necessary (RFC 4180), never with a line break.
std::string field(std::string_view text) {
  std::string clean;
  bool needs_quotes = false;
  for (const char c : text) {
    needs_quotes = needs_quotes || c == ',' || c == '"';
    if (c == '"') clean.push_back('"');
    clean.push_back(c == '\n' || c == '\r' ? ' ' : c);
  }
  return needs_quotes ? fmt::format("\"{}\"", clean) : clean;
}

std::string text_of(std::string_view field) {
  if (field.size() < 2 || field.front() != '"') return std::string(field);
  std::string text;
  for (std::size_t i = 1; i + 1 < field.size(); ++i) {
    if (field[i] == '"') ++i;
    text.push_back(field[i]);
  }
  return text;
}

std::string remark_line(std::string_view sentence) {
  std::string line = "# ";
  for (const char c : sentence) line.push_back(c == '\n' ? ' ' : c);
  return line + "\n";
}

}  // namespace

std::filesystem::path journal_of(const std::filesystem::path& video) {
  std::filesystem::path file = video;
  return file.replace_extension(".frames.csv");
}

Result<JournalWriter> JournalWriter::create(const std::filesystem::path& file,
                                            std::string_view source) {
  JournalWriter journal;
  journal.file_ = file;
  journal.descriptor_ =
      Descriptor(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666));
  if (!journal.descriptor_.is_open()) return system_error(writing(), file, errno);
  std::string head(kFormat);
  head.append("# source: ").append(field(source)).append("\n").append(kColumns);
  if (Status status = journal.write(head); !status) return status.error();
  return journal;
}

Status JournalWriter::write(std::string_view text) {
  std::string_view rest = text;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor(), rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const Error error = system_error(writing(), file_, errno);
      // Should this fail, a reader ignores the incomplete line.
      [[maybe_unused]] const int ignored = ::ftruncate(descriptor(), static_cast<off_t>(bytes_));
      return error;
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  bytes_ += text.size();
  return {};
}

Status JournalWriter::add(const Frame& frame) {
  const std::string line =
      fmt::format("{},{},{},{}\n", frames_, frame.time_ns ? fmt::format("{}", *frame.time_ns) : "",
                  frame.sequence, frame.controls ? field(*frame.controls) : std::string());
  if (Status status = write(line); !status) return status;
  ++frames_;
  return {};
}

Status JournalWriter::remark(std::string_view sentence) { return write(remark_line(sentence)); }

Status JournalWriter::finish() {
  const DiskWait waiting(file_);
  if (!is_removed(descriptor()) && ::fsync(descriptor()) != 0)
    return system_error(writing(), file_, errno);
  return {};
}

Result<std::vector<JournalEntry>> read_journal(const std::filesystem::path& file) {
  std::vector<JournalEntry> entries;
  const auto content = read_file(file);
  if (!content) return entries;
  std::string_view text = *content;
  if (!text.starts_with(kFormat)) return entries;
  while (auto line = take_line(text)) {
    if (line->starts_with('#') || kColumns.starts_with(*line)) continue;
    std::uint64_t number = 0;
    JournalEntry entry;
    if (!take_number(*line, number) || number != entries.size() ||
        !take_number(*line, entry.time_ns) || !take_number(*line, entry.sequence))
      break;
    if (!entries.empty() && entry.time_ns && entries.back().time_ns &&
        *entry.time_ns < *entries.back().time_ns)
      return Error{en::say("frame {} is older than frame {}", number, number - 1), file.string(),
                   en::say("move this file away to use the video's own times")};
    if (!line->empty()) {
      // Usually equal from frame to frame: stored once.
      std::string controls = text_of(*line);
      const bool is_same =
          !entries.empty() && entries.back().controls && *entries.back().controls == controls;
      entry.controls = is_same ? entries.back().controls
                               : std::make_shared<const std::string>(std::move(controls));
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

Status remark_in_journal(const std::filesystem::path& file, std::string_view sentence) {
  auto content = read_file(file);
  if (!content) return content.error();
  content->resize(content->rfind('\n') + 1);  // empty where there is none
  return write_file_atomically(file, *content + remark_line(sentence));
}

}  // namespace alltact
