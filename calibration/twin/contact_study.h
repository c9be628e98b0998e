// The residuals of pressed images, and their derivatives by layer, roll-off, bulge, blur and balls.
#pragma once

#include "calibration/twin/twin_contact.h"

#include <functional>
#include <optional>
#include <vector>

namespace alltact {

/// Parameters that are fitted together.
struct ContactChoice {
  bool coat = true, blur = true, light = true;
};

/// One unknown: its scaling, and how to store it in the scene.
struct ContactUnknown {
  double start, low, high;  // scaled
  int ball;                 // whose ball it is; -1: shared by all presses
  std::function<void(TwinScene&, double)> put;
  std::function<std::optional<double>*(ContactSpread&)> spread;
  std::function<double(double)> value_per_unit;  // derivative of the value by the scaled unknown
};

class ContactStudy {
 public:
  ContactStudy(const TwinScene& scene,
               const std::vector<TwinPatch>& patches,
               const std::vector<TwinPress>& presses,
               ContactChoice choice)
      : scene_(scene), patches_(patches), presses_(presses) {
    choose(choice);
    for (const TwinPatch& patch : patches) residuals_ += patch.target.size();
    for (std::size_t i = 0; i < presses.size(); ++i)
      if (presses[i].given_depth) given_depths_.push_back(i);
  }

  [[nodiscard]] Eigen::Index residuals() const {
    return residuals_ + static_cast<Eigen::Index>(given_depths_.size());
  }
  [[nodiscard]] TwinUnknowns unknowns() const {
    const auto n = static_cast<Eigen::Index>(unknowns_.size());
    TwinUnknowns u{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n)};
    for (Eigen::Index i = 0; i < n; ++i) {
      const ContactUnknown& one = unknowns_[static_cast<std::size_t>(i)];
      u.start[i] = one.start, u.low[i] = one.low, u.high[i] = one.high;
    }
    return u;
  }
  [[nodiscard]] TwinScene scene_at(const Eigen::VectorXd& x) const {
    TwinScene scene = scene_;
    for (std::size_t i = 0; i < unknowns_.size(); ++i)
      unknowns_[i].put(scene, x[static_cast<Eigen::Index>(i)]);
    // The brightness of the untouched face stays unchanged.
    const double t = scene.face.layer_mm;
    const double share = scene_.layer.reflectance(t) / scene.layer.reflectance(t);
    for (TwinLamp& lamp : scene.lamps) lamp.power *= share;
    scene.room_level *= share;
    return scene;
  }

  bool evaluate(const Eigen::VectorXd& x,
                Eigen::VectorXd& residuals,
                Eigen::MatrixXd* slopes) const;
  [[nodiscard]] std::vector<int> clusters() const;
  [[nodiscard]] ContactSpread spread_of(const TwinSolution& solution) const;

 private:
  void choose(ContactChoice choice);
  void add_log(double value,
               double low,
               double high,
               double& (*of)(TwinScene&),
               std::optional<double> ContactSpread::*sd);
  void add_linear(double value,
                  double low,
                  double high,
                  double unit,
                  double& (*of)(TwinScene&),
                  std::optional<double> ContactSpread::*sd);
  void add_ball(std::size_t ball, bool with_light);
  bool predict(const TwinScene& scene, std::size_t press, double* means) const;

  TwinScene scene_;
  const std::vector<TwinPatch>& patches_;
  const std::vector<TwinPress>& presses_;
  std::vector<ContactUnknown> unknowns_;
  std::vector<std::size_t> given_depths_;
  Eigen::Index residuals_ = 0;
};

}  // namespace alltact
