#include "widgets/words/library_words.h"

#include "widgets/words/catalogue.h"
#include "widgets/words/sentence_reader.h"

#include <QCoreApplication>
#include <QStringList>
#include <string>
#include <unordered_map>

namespace alltact {
namespace {

/// Readings say nothing of the language, so they outlive a change of it.
const Reading& reading_of(std::string_view text) {
  constexpr std::size_t kMostKept = 512;
  static const SentenceReader reader(library_patterns());
  static std::unordered_map<std::string, Reading> kept;
  if (kept.size() >= kMostKept) kept.clear();
  const auto [place, is_new] = kept.try_emplace(std::string(text));
  if (is_new) place->second = reader.read(text);
  return place->second;
}

QString spoken(const Reading& reading) {
  if (reading.pattern == nullptr) return QString::fromStdString(reading.text);
  const QString words = QCoreApplication::translate(kLibraryContext, reading.pattern);
  QString text;
  for (qsizetype i = 0; i < words.size(); ++i) {
    const int number =
        words[i] == QLatin1Char('%') && i + 1 < words.size() ? words[i + 1].digitValue() : -1;
    if (number < 1 || number > static_cast<int>(reading.parts.size())) {
      text += words[i];
    } else {
      text += spoken(reading.parts[static_cast<std::size_t>(number - 1)]);
      ++i;
    }
  }
  return text;
}

}  // namespace

QString in_window_language(std::string_view text) {
  QStringList lines;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines << spoken(reading_of(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return lines.join(QLatin1Char('\n'));
}

QString window_sentence(std::string_view text) {
  while (text.ends_with('.')) text.remove_suffix(1);
  if (text.empty()) return {};
  const bool is_closed = text.ends_with('?') || text.ends_with('!');
  QString line = in_window_language(is_closed ? std::string(text) : std::string(text) + '.');
  line[0] = line[0].toUpper();
  return line;
}

}  // namespace alltact
