#include "calibration/joint/skin_profile.h"

#include "calibration/joint/contact_model.h"
#include "core/sensing/depth/light_spread.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

/// Form of a swelling, at most 1, at its own distance from the contact's edge.
double swelling_at(double outside_mm, double distance_mm) {
  const double q = outside_mm / distance_mm;
  return q * q * std::exp(1.0 - q * q);
}

/// All swellings together at a depth of one layer thickness, as a part of the thickness.
double swellings_at(double outside_mm, const SkinForm& form, double layer_mm) {
  constexpr std::array kDistances{0.5, 1.0, 2.0};  // thicknesses
  double sum = 0;
  for (std::size_t i = 0; i < kDistances.size(); ++i)
    sum += form.rise[i] * swelling_at(outside_mm, kDistances[i] * layer_mm);
  return sum;
}

}  // namespace

double RadialProfile::at(double r_mm) const {
  const double index = r_mm / step_mm_ - 0.5;
  if (index <= 0) return values_.front();
  if (index >= kCount - 1) return values_.back();
  const int i = static_cast<int>(index);
  return (*this)[i] + (index - i) * ((*this)[i + 1] - (*this)[i]);
}

template <class SquaredWidth>
RadialProfile RadialProfile::diffused(double width_mm, const SquaredWidth& squared_width) const {
  // Rings of finite volumes give one tridiagonal system; Thomas' elimination.
  RadialProfile q = *this;
  std::array<double, kCount> above{};
  for (int i = 0; i < kCount; ++i) {
    const double middle = i + 0.5, w2 = squared_width((*this)[i]) / (step_mm_ * step_mm_);
    const double in = w2 * i / middle;
    const double out = w2 * (i + 1 < kCount ? (i + 1) / middle : step_mm_ / width_mm);
    const double diagonal =
        1.0 + in + out - (i > 0 ? in * above[static_cast<std::size_t>(i) - 1] : 0.0);
    above[static_cast<std::size_t>(i)] = (i + 1 < kCount ? out : 0.0) / diagonal;
    q[i] = ((*this)[i] + (i > 0 ? in * q[i - 1] : 0.0)) / diagonal;
  }
  for (int i = kCount - 2; i >= 0; --i) q[i] += above[static_cast<std::size_t>(i)] * q[i + 1];
  return q;
}

RadialProfile RadialProfile::skirt_lost(double width_mm) const {
  const double width2 = width_mm * width_mm;
  return diffused(width_mm, [&](double even) { return width2 * skirt_narrowing(even); });
}

RadialProfile RadialProfile::blurred(double sd_mm) const {
  const double width2 = 0.5 * sd_mm * sd_mm;
  return diffused(std::sqrt(width2), [&](double) { return width2; });
}

RadialProfile skin_profile(const RoundContact& contact, const SkinForm& form, double reach_mm) {
  // A face that bulges outward meets the ball as an even one meets a smaller ball.
  const double outer =
      contact.curvature_per_mm / (1.0 + contact.layer_mm * contact.curvature_per_mm);
  const double radius = 1.0 / (1.0 / contact.radius_mm + 0.5 * outer);
  const double depth = std::min(contact.depth_mm, 0.95 * radius);
  const auto ball = [&](double r) {
    return depth - r * r / (radius + std::sqrt(std::max(0.0, (radius - r) * (radius + r))));
  };
  const bool is_half_space = form.bed == Bed::kHalfSpace;
  const double lift =
      form.lift_mm * std::pow(std::sqrt(radius * depth) / contact.layer_mm, form.lift_power);
  const double edge = is_half_space ? std::min(std::sqrt(radius * depth), radius)
                                    : contact_radius_mm(depth * (2.0 * radius - depth), lift);
  const double at_edge = std::max(0.0, ball(edge));
  const double risen = contact.layer_mm * std::pow(depth / contact.layer_mm, form.rise_power);
  RadialProfile skin(reach_mm);
  for (int i = 0; i < RadialProfile::kCount; ++i) {
    const double r = skin.radius_mm(i), outside = r - edge;
    if (outside <= 0) {
      skin[i] = ball(r);
      continue;
    }
    const double returning = is_half_space
                                 ? half_space_tail(r / edge) * std::exp(-outside / form.fade_mm)
                                 : std::exp(-outside / lift);
    skin[i] = at_edge * returning - risen * swellings_at(outside, form, contact.layer_mm);
  }
  return skin;
}

}  // namespace alltact
