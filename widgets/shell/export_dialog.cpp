#include "widgets/shell/export_dialog.h"

#include "core/base/utc_time.h"
#include "core/finger/finger.h"
#include "widgets/language.h"
#include "widgets/shell/finger_card.h"
#include "widgets/theme.h"
#include "widgets/widget_base.h"

#include <QClipboard>
#include <QDesktopServices>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QUrl>
#include <QVBoxLayout>
#include <cmath>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr int kWorthSymbol = 16;
constexpr int kIndent = 26;  // a format's description starts below its text, not below the box

QString text_of(const fs::path& path) { return QString::fromStdString(path.string()); }

}  // namespace

ExportDialog::ExportDialog(const fs::path& finger, QWidget* parent)
    : FittedDialog(parent),
      finger_((finger / "").parent_path()),
      intro_(wrapped_label()),
      verdict_symbol_(new QLabel),
      verdict_(wrapped_label()),
      folder_label_(new QLabel),
      folder_(new QLineEdit),
      command_(new QLineEdit),
      choose_(new QPushButton),
      copy_(new QPushButton),
      write_(new QPushButton),
      stop_(new QPushButton),
      progress_(new QProgressBar),
      outcome_(new ProblemList),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Close)) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(intro_);
  auto* worth = new QHBoxLayout;
  worth->addWidget(verdict_symbol_, 0, Qt::AlignTop);
  worth->addWidget(verdict_, 1);
  column->addLayout(worth);
  column->addLayout(make_forms());
  column->addLayout(make_folder_row());
  column->addLayout(make_command_row());
  column->addWidget(outcome_);
  column->addStretch(1);
  auto* row = new QHBoxLayout;
  buttons_->addButton(write_, QDialogButtonBox::ActionRole);
  // Return exports, wherever the focus is.
  for (QPushButton* button : {choose_, copy_, stop_, buttons_->button(QDialogButtonBox::Close)})
    button->setAutoDefault(false);
  write_->setDefault(true);
  row->addWidget(progress_, 1);
  row->addWidget(stop_);
  row->addStretch();
  row->addWidget(buttons_);
  column->addLayout(row);
  for (QLineEdit* line : {folder_, command_}) show_text_as_tip(*line);
  folder_->setText(text_of(finger_.parent_path() / (finger_.filename().string() + "-export")));
  connect(folder_, &QLineEdit::textChanged, this, &ExportDialog::show_command);
  connect(choose_, &QPushButton::clicked, this, [this] {
    ask_for_folder(
        this, FilesOf::kExports, tr("Folder for the files"),
        [this](const QString& folder) { folder_->setText(folder); }, folder_->text());
  });
  connect(write_, &QPushButton::clicked, this, &ExportDialog::write);
  connect(stop_, &QPushButton::clicked, &work_, &BackgroundWork::stop);
  connect(copy_, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(command_line()); });
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(&work_, &BackgroundWork::progressed, this,
          [this] { progress_->setValue(static_cast<int>(std::lround(100 * work_.fraction()))); });
  say([this] {
    setWindowTitle(tr("Export finger"));
    intro_->setText(tr("Data of finger %1, for other programs.").arg(text_of(finger_.filename())));
    show_verdict();
    name_forms();
    folder_label_->setText(tr("&Folder for the files"));
    folder_->setAccessibleName(tr("Folder for the files"));
    choose_->setText(tr("Choose…"));
    choose_->setToolTip(tr("Chooses the folder to write to"));
    choose_->setAccessibleName(tr("Choose the folder"));
    command_->setAccessibleName(tr("The same as a command line"));
    copy_->setText(tr("Copy as command &line"));
    copy_->setToolTip(tr("Copies the command that does the same in a terminal"));
    progress_->setAccessibleName(tr("Progress of the export"));
    stop_->setText(tr("&Stop"));
    stop_->setToolTip(tr("Ends the export; no unfinished file is left"));
    write_->setText(tr("&Export"));
    write_->setToolTip(tr("Writes the ticked files"));
    buttons_->button(QDialogButtonBox::Close)->setText(tr("&Close"));
    buttons_->button(QDialogButtonBox::Close)->setToolTip(tr("Closes this window (Esc)"));
  });
  show_command();
  show_running(false);
  resize(620, 460);
  reading_.start([this, folder = finger_](const Job&) {
    auto card = read_finger_card(folder, utc_now());
    return std::function<void()>([this, card = std::move(card)] {
      card_ = card;
      show_verdict();
    });
  });
}

/// Shows the verdict, which every user of the exported figures needs.
void ExportDialog::show_verdict() {
  const bool is_good = card_ && card_->grade == Grade::kGood && card_->findings.empty();
  for (QLabel* label : {verdict_symbol_, verdict_}) label->setVisible(card_ && !is_good);
  if (!card_ || is_good) return;
  const Headline headline = headline_of(*card_);
  verdict_symbol_->setPixmap(symbol(meaning_symbol(headline.meaning),
                                    meaning_colour(headline.meaning, palette()), kWorthSymbol,
                                    devicePixelRatioF()));
  QStringList sentences{as_sentence(headline.text)};
  if (!card_->findings.empty()) sentences << window_sentence(card_->findings.front());
  verdict_->setText(sentences.join(QLatin1Char(' ')));
}

QLayout* ExportDialog::make_forms() {
  auto* column = new QVBoxLayout;
  column->setSpacing(2);
  for (const ExportFormInfo& info : export_forms()) {
    const Form form{info.form, new QCheckBox, new QLabel};
    form.check_box->setObjectName(
        QString::fromUtf8(info.word.data(), static_cast<int>(info.word.size())));
    form.check_box->setChecked(info.form == ExportForm::kJson || info.form == ExportForm::kZip);
    form.what_for->setWordWrap(true);
    form.what_for->setContentsMargins(kIndent, 0, 0, 8);
    column->addWidget(form.check_box);
    column->addWidget(form.what_for);
    connect(form.check_box, &QCheckBox::toggled, this, &ExportDialog::show_command);
    forms_.push_back(form);
  }
  return column;
}

QLayout* ExportDialog::make_folder_row() {
  auto* row = new QHBoxLayout;
  folder_label_->setBuddy(folder_);
  folder_->setMinimumWidth(260);
  row->addWidget(folder_label_);
  row->addWidget(folder_, 1);
  row->addWidget(choose_);
  return row;
}

QLayout* ExportDialog::make_command_row() {
  auto* row = new QHBoxLayout;
  QFont mono(QStringLiteral("monospace"));
  mono.setStyleHint(QFont::Monospace);
  command_->setFont(mono);
  command_->setReadOnly(true);
  row->addWidget(command_, 1);
  row->addWidget(copy_);
  return row;
}

void ExportDialog::name_forms() {
  for (const Form& form : forms_) {
    QString name, what_for;
    switch (form.form) {
      case ExportForm::kOpencv:
        name = tr("&OpenCV: camera.opencv.yaml");
        what_for = tr("Camera matrix and distortion, for cv::FileStorage.");
        break;
      case ExportForm::kRos:
        name = tr("&ROS: camera_info.yaml and parameters.yaml");
        what_for =
            tr("The camera in the format of drivers and image_pipeline; face, markers and mapping "
               "as parameters of a ROS 2 node.");
        break;
      case ExportForm::kJson:
        name = tr("&JSON: calibration.json");
        what_for = tr("All values in one file, for your own programs.");
        break;
      case ExportForm::kZip:
        name = tr("E&ntire finger: finger.zip");
        what_for =
            tr("All files of the finger, with its untouched images: to archive, to send, and to "
               "measure with in Python.");
        break;
    }
    form.check_box->setText(name);
    form.check_box->setToolTip(what_for);
    form.check_box->setAccessibleDescription(what_for);
    form.what_for->setText(what_for);
  }
}

std::vector<ExportForm> ExportDialog::forms() const {
  std::vector<ExportForm> chosen;
  for (const Form& form : forms_)
    if (form.check_box->isChecked()) chosen.push_back(form.form);
  return chosen;
}

QString ExportDialog::command_line() const {
  return QString::fromStdString(
      export_command(finger_, forms(), folder_->text().trimmed().toStdString()));
}

void ExportDialog::show_command() {
  const bool is_complete = !forms().empty() && !folder_->text().trimmed().isEmpty();
  command_->setText(is_complete ? command_line() : QString());
  command_->setCursorPosition(0);
  copy_->setEnabled(is_complete);
}

void ExportDialog::show_running(bool is_running) {
  for (const Form& form : forms_) form.check_box->setEnabled(!is_running);
  for (QWidget* part : std::initializer_list<QWidget*>{folder_, choose_, write_})
    part->setEnabled(!is_running);
  for (QWidget* part : std::initializer_list<QWidget*>{progress_, stop_})
    part->setVisible(is_running);
}

void ExportDialog::write() {
  const fs::path folder = folder_->text().trimmed().toStdString();
  std::vector<Problem> problems;
  if (forms().empty()) problems.push_back({Meaning::kBad, tr("Nothing is selected.")});
  if (folder.empty()) problems.push_back({Meaning::kBad, tr("No folder is chosen.")});
  outcome_->set_problems(problems);
  if (!problems.empty()) return;
  show_running(true);
  progress_->setValue(0);
  work_.start([this, finger_folder = finger_, check_box = forms(), folder](const Job& job) {
    std::vector<fs::path> written, left_out;
    Status status;
    if (const auto finger = open_finger(finger_folder)) {
      status = export_finger(**finger, check_box, folder, job, &written);
      if (std::count(check_box.begin(), check_box.end(), ExportForm::kZip) > 0)
        left_out = unused_recordings((*finger)->finger, finger_folder);
    } else {
      status = finger.error();
    }
    return std::function<void()>([this, status, written, left_out] {
      show_running(false);
      show_outcome(status, written, left_out);
    });
  });
}

void ExportDialog::show_outcome(const Status& status, const std::vector<fs::path>& written,
                                const std::vector<fs::path>& left_out) {
  std::vector<Problem> rows;
  if (!status) rows.push_back(Problem::of(status.error()));
  if (!left_out.empty())
    rows.push_back({Meaning::kDoubtful,
                    tr("%n recording(s) that this finger does not use are left out of the zip.",
                       nullptr, static_cast<int>(left_out.size()))});
  if (!written.empty()) {
    QStringList names;
    for (const fs::path& file : written) names << text_of(file.filename());
    const fs::path folder = written.front().parent_path();
    rows.push_back({Meaning::kGood,
                    tr("Written: %1.").arg(listed(names)),
                    {},
                    tr("Open the folder"),
                    [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(text_of(folder))); }});
  }
  outcome_->set_problems(rows);
}

}  // namespace alltact
