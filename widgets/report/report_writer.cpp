#include "widgets/report/report_writer.h"

#include "core/io/atomic_file.h"
#include "widgets/language.h"
#include "widgets/report/calibration_pages.h"
#include "widgets/report/report_pages.h"

#include <QTimer>
#include <mutex>

namespace alltact {

struct ReportWriter::Pages {
  std::shared_ptr<const FingerCalibration> done;
  std::filesystem::path folder;
  std::optional<ReportPages> pages = {};
  std::mutex writing = {};
  bool is_stopped = false;  ///< nothing may be written any more
};

ReportWriter::ReportWriter(QObject* parent) : QObject(parent) {}
ReportWriter::~ReportWriter() {
  stop();
}

void ReportWriter::start(std::shared_ptr<const FingerCalibration> done,
                         const std::filesystem::path& folder) {
  stop();
  problem_.reset();
  pages_ = std::make_shared<Pages>();
  pages_->done = std::move(done);
  pages_->folder = folder;
  prepare(pages_);
}

void ReportWriter::stop() {
  if (pages_) {
    const std::lock_guard lock(pages_->writing);
    pages_->is_stopped = true;
  }
  pages_.reset();
  work_.reset();
}

void ReportWriter::prepare(const std::shared_ptr<Pages>& pages) {
  work_ = std::make_unique<BackgroundWork>();  // this requests the replaced one to stop
  work_->start([this, pages](const Job& job) {
    using Faults = Result<std::vector<SimulatedCalibration>>;
    const auto faults = std::make_shared<Faults>(simulate_typical_faults(job));
    return std::function<void()>([this, pages, faults] {
      if (pages != pages_) return;
      if (!*faults) return end(faults->error());
      pages->pages.emplace(pages->done, pages->folder, std::move(**faults));
      draw(pages);
    });
  });
}

void ReportWriter::draw(const std::shared_ptr<Pages>& pages) {
  if (pages != pages_) return;
  bool is_drawn = false;
  {
    const EnglishScope as_for_the_lab_book;
    is_drawn = !pages->pages->write_next();
  }
  QTimer::singleShot(0, this, [this, pages, is_drawn] { is_drawn ? write(pages) : draw(pages); });
}

void ReportWriter::write(const std::shared_ptr<Pages>& pages) {
  if (pages != pages_) return;
  work_ = std::make_unique<BackgroundWork>();
  work_->start([this, pages](const Job& job) {
    const auto written = std::make_shared<Status>();
    const auto files = files_of(pages->pages->document(), pages->done->inputs.date, job);
    if (!files) *written = files.error();
    const std::lock_guard lock(pages->writing);
    for (std::size_t i = 0; files && i < files->size() && *written && !pages->is_stopped; ++i)
      *written = write_file_atomically(pages->folder / (*files)[i].name, (*files)[i].content);
    return std::function<void()>([this, pages, written] {
      if (pages == pages_) end(*written);
    });
  });
}

void ReportWriter::end(const Status& how) {
  pages_.reset();
  if (!how) problem_ = how.error();
  Q_EMIT finished();
}

}  // namespace alltact
