#include "widgets/live/touch_history.h"

#include "widgets/language.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

namespace alltact {

void TouchHistory::add(const FrameResult& result, double time_s) {
  if (now_s_ && time_s < *now_s_) forget();
  const bool is_after_gap = now_s_ && time_s > *now_s_ + kMaxGap_s;
  now_s_ = time_s;
  add_force(result.force, is_after_gap);
  add_contact(result.contact, is_after_gap);
  while (!forces_.empty() && forces_.front().time_s < time_s - kLength_s) forces_.pop_front();
  while (!slips_.empty() && slips_.front().to_s < time_s - kLength_s) slips_.pop_front();
  while (!contacts_.empty() && contacts_.front().to_s < time_s - kLength_s) contacts_.pop_front();
}

void TouchHistory::add_force(const std::optional<Force>& force, bool is_after_gap) {
  if (is_after_gap && !forces_.empty()) forces_.push_back({*now_s_, std::nullopt});
  const auto slot = [](double time_s) { return std::floor(time_s / kSlot_s); };
  const bool is_same_slot = !forces_.empty() && slot(forces_.back().time_s) == slot(*now_s_);
  if (is_same_slot && forces_.back().force && force)
    forces_.back() = {*now_s_, force};
  else if (!is_same_slot || force)  // a frame without a force does not replace one in the same slot
    forces_.push_back({*now_s_, force});
}

void TouchHistory::add_contact(const std::optional<FingerContact>& contact, bool is_after_gap) {
  const bool was_on = !contacts_.empty() && !contacts_.back().has_ended;
  const bool has_duration = contact && contact->held_s;
  const double began_s = *now_s_ - (has_duration ? *contact->held_s : 0.0);
  // Between two views one contact may have ended and the next begun.
  const bool is_another =
      contact && was_on &&
      (contact->is_new || contact->face != contacts_.back().face ||
       (has_duration ? began_s > contacts_.back().to_s + kSlot_s : is_after_gap));
  if (was_on && (!contact || is_another)) contacts_.back().has_ended = true;
  if (!contact) return;
  if (!was_on || is_another) contacts_.push_back({began_s, *now_s_, contact->face});
  Contact& now = contacts_.back();
  now.to_s = *now_s_;
  if (contact->is_slipping.value_or(false)) add_slip();
}

void TouchHistory::add_slip() {
  if (slips_.empty() || *now_s_ - slips_.back().to_s > kSlipMerge_s) slips_.push_back({*now_s_, 0});
  slips_.back().to_s = *now_s_;
}

bool TouchHistory::has_slipped(const Contact& contact) const {
  return std::any_of(slips_.begin(), slips_.end(), [&](const Slip& slip) {
    return slip.from_s >= contact.from_s && slip.from_s <= contact.to_s;
  });
}

bool TouchHistory::has_forces() const {
  return std::any_of(forces_.begin(), forces_.end(),
                     [](const auto& reading) { return reading.force.has_value(); });
}

std::optional<ForceZero> present_zero(const TouchHistory& history) {
  if (!history.now_s()) return std::nullopt;
  ForceZero zero;
  int count = 0;
  for (auto reading = history.forces().rbegin(); reading != history.forces().rend(); ++reading) {
    if (reading->time_s < *history.now_s() - kZeroSpan_s) break;
    if (!reading->force) continue;
    const Force& force = *reading->force;
    if (!force.in_range) return std::nullopt;
    ++count;
    zero.force_N += force.force_N;
    zero.sd_N += force.sd_N;
    zero.half_90_N += force.half_90_N;
    zero.half_95_N += force.half_95_N;
  }
  if (count == 0) return std::nullopt;
  for (Eigen::Vector3d* sum : {&zero.force_N, &zero.sd_N, &zero.half_90_N, &zero.half_95_N})
    *sum /= count;
  zero.has_contact = !history.contacts().empty() && !history.contacts().back().has_ended;
  return zero;
}

Force zeroed(Force force, const std::optional<ForceZero>& zero) {
  if (!zero) return force;
  const auto both = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return Eigen::Vector3d((a.array().square() + b.array().square()).sqrt());
  };
  force.force_N -= zero->force_N;
  force.sd_N = both(force.sd_N, zero->sd_N);
  force.half_90_N = both(force.half_90_N, zero->half_90_N);
  force.half_95_N = both(force.half_95_N, zero->half_95_N);
  return force;
}

namespace {

struct ContactWords {
  Q_DECLARE_TR_FUNCTIONS(alltact::ContactWords)
};

QString contact_text(const FingerContact& contact) {
  switch (contact.face) {
    case PushedFace::kContact:
      return contact.position ? ContactWords::tr("Contact on the contact face")
                              : ContactWords::tr("Pushed from the contact face");
    case PushedFace::kBack:
      return ContactWords::tr("Pushed from the back");
    case PushedFace::kUpper:
      return ContactWords::tr("Pushed from the upper side");
    case PushedFace::kLower:
      break;
  }
  return ContactWords::tr("Pushed from the lower side");
}

QString seconds_text(double value) {
  return ContactWords::tr("%1 s")
      .arg(plain_number(value, 1))
      .replace(QLatin1Char(' '), QChar(QChar::Nbsp));
}

QString contact_head(const FingerContact& contact, const TouchHistory* history) {
  QString text = QStringLiteral("<b>%1</b>").arg(contact_text(contact));
  if (history == nullptr || contact.held_s.value_or(0.0) <= 0) return text;
  return text + QStringLiteral(" ") + ContactWords::tr("for %1").arg(seconds_text(*contact.held_s));
}

QString contact_row(const QString& name, const QString& value) {
  return QStringLiteral("<tr><td>%1&nbsp;</td><td>%2</td></tr>").arg(name, value);
}

QString mm_and_sd(double value, const std::optional<double>& sd, int digits) {
  return ContactWords::tr("%1 mm").arg(number_and_sd(value, sd, digits));
}

QString contact_rows(const FingerContact& contact) {
  QString rows;
  if (contact.position) {
    const PositionOnFinger& at = *contact.position;
    rows += contact_row(ContactWords::tr("Along"), mm_and_sd(at.along_mm, at.along_sd_mm, 2));
    if (at.across_mm)
      rows += contact_row(ContactWords::tr("Across"), mm_and_sd(*at.across_mm, at.across_sd_mm, 2));
    if (at.depth_mm)
      rows += contact_row(
          ContactWords::tr("Depth"),
          (at.limits & kLayerLimit) != 0
              ? ContactWords::tr("%1 mm").arg(limit_and_sd(*at.depth_mm, at.depth_sd_mm, 2))
              : mm_and_sd(*at.depth_mm, at.depth_sd_mm, 2));
  }
  if (!contact.direction) return rows;
  const Eigen::Vector3d& direction = *contact.direction;
  const QString turned =
      contact.direction_sd_deg
          ? ContactWords::tr("± %1°").arg(sd_number(*contact.direction_sd_deg, 1))
          : ContactWords::tr("(normal to the face)");
  const QString components =
      ContactWords::tr("x %1, y %2, z %3")
          .arg(plain_number(direction.x(), 2), plain_number(direction.y(), 2),
               plain_number(direction.z(), 2));
  return rows +
         contact_row(ContactWords::tr("Direction"), components + QStringLiteral(" ") + turned);
}

QString extent_text(const std::vector<ContactRegion>& regions) {
  if (regions.empty()) return {};
  const ContactRegion& first = regions.front();
  QString text = ContactWords::tr("Area %1 mm², volume %2 mm³.")
                     .arg(plain_number(first.area_mm2, 1), plain_number(first.volume_mm3, 1));
  if (regions.size() > 1)
    text += QStringLiteral(" ") + ContactWords::tr("%n contact(s) on the face.", nullptr,
                                                   static_cast<int>(regions.size()));
  return text;
}

QString contact_details(const FrameResult& result, const TouchHistory* history) {
  const FingerContact& contact = *result.contact;
  QStringList parts{contact_head(contact, history)};
  if (contact.is_slipping.value_or(false))
    parts << QStringLiteral("<b>%1 %2</b>")
                 .arg(QChar(0x25b2), ContactWords::tr("It slips or rolls over the skin."));
  QString text = parts.join(QStringLiteral("<br>"));
  text += QStringLiteral("<table>%1</table>").arg(contact_rows(contact));
  parts.clear();
  if (!contact.position && !contact.no_position.empty())
    parts << window_sentence(contact.no_position);
  parts << extent_text(result.regions);
  parts.removeAll(QString());
  return text + parts.join(QStringLiteral("<br>"));
}

QString no_contact_text(const FrameResult& result, const TouchHistory* history) {
  if (!result.reference) return ContactWords::tr("Unknown without a reference recording.");
  QString text = ContactWords::tr("Nothing touches the finger.");
  if (history == nullptr || history->contacts().empty()) return text;
  const auto& last = history->contacts().back();
  if (!last.has_ended) return text;
  text += QStringLiteral("<br>") + ContactWords::tr("The last contact lasted %1 and ended %2 ago.")
                                       .arg(seconds_text(last.to_s - last.from_s),
                                            seconds_text(*history->now_s() - last.to_s));
  if (history->has_slipped(last)) text += QStringLiteral(" ") + ContactWords::tr("It slipped.");
  return text;
}

}  // namespace

QString contact_words(const FrameResult& result, const TouchHistory* history) {
  return result.contact ? contact_details(result, history) : no_contact_text(result, history);
}

QString brief_contact_words(const FrameResult& result) {
  QStringList parts;
  if (result.contact) parts << contact_text(*result.contact);
  if (result.force && result.force->in_range) {
    const Force& force = *result.force;
    const std::array names{QStringLiteral("Fx %1"), QStringLiteral("Fy %1"),
                           QStringLiteral("Fz %1")};
    for (Eigen::Index axis = 0; axis < force.axes; ++axis)
      parts << names[static_cast<std::size_t>(axis)].arg(ContactWords::tr("%1 N").arg(
          number_and_sd(force.force_N[axis], force.half_95_N[axis], 2)));
  }
  return joined(parts);
}

QString contact_words_help() {
  return ContactWords::tr(
      "Along: over the face from its base. Across: from its centre line towards +y. Direction: "
      "displacement of the finger in the camera's frame; its standard deviation applies within "
      "the finger's cross-section.");
}

namespace {

QString no_model_text(const std::filesystem::path& folder) {
  const QString name = folder.empty() ? QStringLiteral("FINGER")
                                      : QString::fromStdString(folder.filename().string());
  return ContactWords::tr(
             "This finger has no force model yet. Train one with a table of its markers and a "
             "gauge's forces:") +
         QStringLiteral("<br><code>alltact force %1 TABLE.csv</code>").arg(name.toHtmlEscaped());
}

}  // namespace

bool has_force_model(const FingerStatus& status) {
  return status.finger && !status.finger->force_model.empty();
}

QString no_force_reason(const FingerStatus& status) {
  if (status.state == FingerState::kLoading) return ContactWords::tr("The finger is being loaded.");
  if (!status.finger) return ContactWords::tr("Open a finger to see its forces.");
  const Finger& finger = *status.finger;
  if (finger.markers.per_row == 0) return ContactWords::tr("Forces need a finger with markers.");
  if (status.force_problem) return window_sentence(status.force_problem->message()).toHtmlEscaped();
  if (finger.force_model.empty()) return no_model_text(status.folder);
  if (!status.has_reference)
    return ContactWords::tr("Forces need a reference recording: record one.");
  return ContactWords::tr("No force is estimated for this image.");
}

}  // namespace alltact
