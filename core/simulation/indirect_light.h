// Light that arrives not directly from the lamps but from lit surfaces.
#pragma once

#include "core/simulation/row_view.h"

#include <functional>
#include <memory>

namespace alltact {

/// Of one frame. Built with the geometry; the effect that owns the lamps evaluates it.
class IndirectLight {
 public:
  IndirectLight() = default;
  IndirectLight(const IndirectLight&) = delete;
  IndirectLight& operator=(const IndirectLight&) = delete;
  virtual ~IndirectLight() = default;

  /// Sets irradiance[first, last) to the irradiance of a surface directly from lamps and room.
  using Direct = std::function<void(const Surface& surface, float* irradiance)>;

  /// Several threads use it at once.
  class Rows {
   public:
    Rows() = default;
    Rows(const Rows&) = delete;
    Rows& operator=(const Rows&) = delete;
    virtual ~Rows() = default;
    /// Sets irradiance[first, last) of a surface of this row.
    virtual void row(const RowView& row, const Surface& surface, float* irradiance) const = 0;
  };
  [[nodiscard]] virtual std::unique_ptr<const Rows> lit_by(const Direct& direct) const = 0;
};

}  // namespace alltact
