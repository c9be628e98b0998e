#include "widgets/touch/contact_words.h"

#include "widgets/joined_words.h"
#include "widgets/language.h"

#include <QCoreApplication>
#include <QLocale>
#include <array>
#include <cmath>

namespace alltact {
namespace {

struct ContactWords {
  Q_DECLARE_TR_FUNCTIONS(alltact::ContactWords)
 public:
  static QString face_text(PushedFace face) {
    switch (face) {
      case PushedFace::kContact:
        return tr("Touched on the contact face");
      case PushedFace::kBack:
        return tr("Pushed from the back");
      case PushedFace::kUpper:
        return tr("Pushed from the upper side");
      case PushedFace::kLower:
        break;
    }
    return tr("Pushed from the lower side");
  }

  static QString seconds(double value) {
    return tr("%1 s").arg(plain_number(value, 1)).replace(QLatin1Char(' '), QChar(QChar::Nbsp));
  }

  static QString head(const FingerContact& contact, const TouchHistory* history) {
    QString text = QStringLiteral("<b>%1</b>").arg(face_text(contact.face));
    if (history == nullptr || contact.held_s.value_or(0.0) <= 0) return text;
    return text + QStringLiteral(" ") + tr("for %1").arg(seconds(*contact.held_s));
  }

  static QString row(const QString& name, const QString& value) {
    return QStringLiteral("<tr><td>%1&nbsp;</td><td>%2</td></tr>").arg(name, value);
  }

  static QString millimetres(double value, const std::optional<double>& sd, int digits) {
    return tr("%1 mm").arg(number_and_sd(value, sd, digits));
  }

  static QString rows(const FingerContact& contact) {
    QString rows;
    if (contact.position) {
      const PositionOnFinger& at = *contact.position;
      rows += row(tr("Along"), millimetres(at.along_mm, at.along_sd_mm, 2));
      if (at.across_mm) rows += row(tr("Across"), millimetres(*at.across_mm, at.across_sd_mm, 2));
      if (at.depth_mm)
        rows += row(tr("Depth"),
                    (at.limits & kLayerLimit) != 0
                        ? tr("%1 mm").arg(limit_and_sd(*at.depth_mm, at.depth_sd_mm, 2))
                        : millimetres(*at.depth_mm, at.depth_sd_mm, 2));
    }
    if (!contact.direction) return rows;
    const Eigen::Vector3d& direction = *contact.direction;
    const QString turned = contact.direction_sd_deg
                               ? tr("± %1°").arg(sd_number(*contact.direction_sd_deg, 1))
                               : tr("(the face's normal)");
    const QString components = tr("x %1, y %2, z %3")
                                   .arg(plain_number(direction.x(), 2),
                                        plain_number(direction.y(), 2),
                                        plain_number(direction.z(), 2));
    return rows + row(tr("Direction"), components + QStringLiteral(" ") + turned);
  }

  static QString extent(const std::vector<ContactRegion>& regions) {
    if (regions.empty()) return {};
    const ContactRegion& first = regions.front();
    QString text = tr("Area %1 mm², volume %2 mm³.")
                       .arg(plain_number(first.area_mm2, 1), plain_number(first.volume_mm3, 1));
    if (regions.size() > 1)
      text += QStringLiteral(" ") +
              tr("%n contact(s) on the face.", nullptr, static_cast<int>(regions.size()));
    return text;
  }

  static QString touching(const FrameResult& result, const TouchHistory* history) {
    const FingerContact& contact = *result.contact;
    QStringList parts{head(contact, history)};
    if (contact.is_slipping.value_or(false))
      parts << QStringLiteral("<b>%1 %2</b>")
                   .arg(QChar(0x25b2), tr("It slips or rolls over the skin."));
    QString text = parts.join(QStringLiteral("<br>"));
    text += QStringLiteral("<table>%1</table>").arg(rows(contact));
    parts.clear();
    if (!contact.position && !contact.no_position.empty())
      parts << window_sentence(contact.no_position);
    parts << extent(result.regions);
    parts.removeAll(QString());
    return text + parts.join(QStringLiteral("<br>"));
  }

  static QString free(const FrameResult& result, const TouchHistory* history) {
    if (!result.reference) return tr("Not known without a reference recording.");
    QString text = tr("Nothing touches the finger.");
    if (history == nullptr || history->contacts().empty()) return text;
    const auto& last = history->contacts().back();
    if (!last.has_ended) return text;
    text += QStringLiteral("<br>") +
            tr("The last contact lasted %1 and ended %2 ago.")
                .arg(seconds(last.to_s - last.from_s), seconds(*history->now_s() - last.to_s));
    if (history->has_slipped(last)) text += QStringLiteral(" ") + tr("It slipped.");
    return text;
  }

  static QString brief(const FrameResult& result) {
    QStringList parts;
    if (result.contact) parts << face_text(result.contact->face);
    if (result.force && result.force->in_range) {
      const Force& force = *result.force;
      const std::array names{
          QStringLiteral("Fx %1"), QStringLiteral("Fy %1"), QStringLiteral("Fz %1")};
      for (Eigen::Index axis = 0; axis < force.axes; ++axis)
        parts << names[static_cast<std::size_t>(axis)].arg(
            tr("%1 N").arg(number_and_sd(force.force_N[axis], force.half_95_N[axis], 2)));
    }
    return joined(parts);
  }

  static QString help() {
    return tr(
        "Along: over the face from its base. Across: from its middle line towards +y. "
        "Direction: the way the finger gave, in the camera's frame; its standard deviation "
        "is that within the finger's section.");
  }
};

}  // namespace

QString contact_words(const FrameResult& result, const TouchHistory* history) {
  return result.contact ? ContactWords::touching(result, history)
                        : ContactWords::free(result, history);
}

QString brief_contact_words(const FrameResult& result) {
  return ContactWords::brief(result);
}

QString contact_words_help() {
  return ContactWords::help();
}

}  // namespace alltact
