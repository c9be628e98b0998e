// The translations as they are written down, for tests.
#pragma once

#include <QFile>
#include <QStringList>
#include <QXmlStreamReader>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace alltact::test {

/// Of what the libraries say.
inline constexpr const char* kSaidContext = "alltact::en";

struct TsMessage {
  QString context, source, comment;
  QStringList translations;
  bool is_finished = true, is_counted = false;
};

inline std::filesystem::path ts_file(const std::string& language) {
  return std::filesystem::path(ALLTACT_SOURCE_DIR) / "translations" /
         ("alltact_" + language + ".ts");
}

inline std::vector<TsMessage> messages_of(const std::filesystem::path& file) {
  QFile text(QString::fromStdString(file.string()));
  EXPECT_TRUE(text.open(QIODevice::ReadOnly)) << file;
  QXmlStreamReader xml(&text);
  std::vector<TsMessage> messages;
  QString context;
  while (!xml.atEnd()) {
    xml.readNext();
    if (!xml.isStartElement()) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() == QLatin1String("message")) {
      messages.emplace_back().context = context;
      messages.back().is_counted = xml.attributes().hasAttribute(QStringLiteral("numerus"));
    }
    if (xml.name() == QLatin1String("source")) messages.back().source = xml.readElementText();
    if (xml.name() == QLatin1String("comment")) messages.back().comment = xml.readElementText();
    if (xml.name() == QLatin1String("numerusform"))
      messages.back().translations << xml.readElementText();
    if (xml.name() == QLatin1String("translation")) {
      messages.back().is_finished = !xml.attributes().hasAttribute(QStringLiteral("type"));
      if (messages.back().is_counted) continue;
      if (const QString plain = xml.readElementText(); !plain.trimmed().isEmpty())
        messages.back().translations << plain;
    }
  }
  EXPECT_FALSE(xml.hasError()) << file << xml.errorString().toStdString();
  return messages;
}

}  // namespace alltact::test
