// Prints an HTML file on A4 pages with numbers: manual_pdf IN.html OUT.pdf (see packaging/manual).
#include <QFile>
#include <QGuiApplication>
#include <QPageLayout>
#include <QPdfWriter>
#include <QTextDocument>

int main(int argc, char* argv[]) {
  const QGuiApplication application(argc, argv);
  QFile source(argc == 3 ? QString::fromLocal8Bit(argv[1]) : QString());
  if (!source.open(QIODevice::ReadOnly)) return 1;
  QTextDocument document;
  document.setHtml(QString::fromUtf8(source.readAll()));
  QPdfWriter writer(QString::fromLocal8Bit(argv[2]));
  writer.setTitle(document.metaInformation(QTextDocument::DocumentTitle));
  writer.setCreator(QStringLiteral("AllTact Studio"));
  writer.setResolution(300);
  writer.setPageLayout(
      QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)));
  document.print(&writer);
  return 0;
}
