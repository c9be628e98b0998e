// Light that does not come straight from the lamps, but from what they light.
#pragma once

#include "core/simulation/row_view.h"

#include <functional>
#include <memory>

namespace alltact {

/// One frame's. Made while the geometry is, asked by the effect that has the lamps.
class IndirectLight {
 public:
  IndirectLight() = default;
  IndirectLight(const IndirectLight&) = delete;
  IndirectLight& operator=(const IndirectLight&) = delete;
  virtual ~IndirectLight() = default;

  /// Sets irradiance[first, last) to what falls on a surface straight from lamps and room.
  using Direct = std::function<void(const Surface& surface, float* irradiance)>;

  /// Used by several threads at once.
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
