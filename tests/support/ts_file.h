// The translations as they are written down, for tests.
#pragma once

#include <QCoreApplication>
#include <QFile>
#include <QHash>
#include <QStringList>
#include <QTranslator>
#include <QXmlStreamReader>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace alltact::test {

struct Message {
  QString context, source;
  QStringList translations;
  bool is_finished = true;
};

inline std::filesystem::path ts_file(const std::string& language) {
  return std::filesystem::path(ALLTACT_SOURCE_DIR) / "translations" /
         ("alltact_" + language + ".ts");
}

inline std::vector<Message> messages_of(const std::filesystem::path& file) {
  QFile text(QString::fromStdString(file.string()));
  EXPECT_TRUE(text.open(QIODevice::ReadOnly)) << file;
  QXmlStreamReader xml(&text);
  std::vector<Message> messages;
  QString context;
  while (!xml.atEnd()) {
    xml.readNext();
    if (!xml.isStartElement()) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() == QLatin1String("message")) messages.emplace_back().context = context;
    if (xml.name() == QLatin1String("source")) messages.back().source = xml.readElementText();
    if (xml.name() == QLatin1String("numerusform"))
      messages.back().translations << xml.readElementText();
    if (xml.name() == QLatin1String("translation")) {
      messages.back().is_finished = !xml.attributes().hasAttribute(QStringLiteral("type"));
      const QString plain = xml.readElementText(QXmlStreamReader::IncludeChildElements);
      if (!plain.trimmed().isEmpty()) messages.back().translations << plain;
    }
  }
  EXPECT_FALSE(xml.hasError()) << file << xml.errorString().toStdString();
  return messages;
}

/// Speaks one context of a language as its file has it, for as long as it lives.
class TsTranslator : public QTranslator {
 public:
  TsTranslator(const std::string& language, QString context) : context_(std::move(context)) {
    for (const Message& message : messages_of(ts_file(language)))
      if (message.context == context_) words_[message.source] = message.translations.value(0);
    QCoreApplication::installTranslator(this);
  }
  ~TsTranslator() override { QCoreApplication::removeTranslator(this); }
  TsTranslator(const TsTranslator&) = delete;
  TsTranslator& operator=(const TsTranslator&) = delete;

  [[nodiscard]] bool isEmpty() const override { return words_.isEmpty(); }
  [[nodiscard]] QString translate(const char* context,
                                  const char* source,
                                  const char* /*disambiguation*/,
                                  int /*n*/) const override {
    if (context_ != QLatin1String(context)) return {};
    return words_.value(QString::fromUtf8(source));
  }

 private:
  QString context_;
  QHash<QString, QString> words_;
};

}  // namespace alltact::test
