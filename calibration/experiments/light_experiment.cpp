// Influence of the room's light on the measurements.
#include "calibration/experiments/experiments.h"
#include "calibration/experiments/force_experiments.h"
#include "calibration/study/evaluate.h"

#include <array>
#include <cmath>
#include <optional>

namespace alltact {
namespace {

constexpr std::array kRooms_lux{300, 1100, 2500};
constexpr std::size_t kRooms = kRooms_lux.size();
constexpr double kGreyPer1000Lux = 4;
constexpr double kAimChange_percent = 10;

/// In one room, of all fingers.
struct RoomErrors {
  ErrorSamples position_mm, force_N;
};
using ErrorsOfRooms = std::array<RoomErrors, kRooms>;

/// The greatest change between rooms relative to the least, %.
template <class Of>
double change_percent(const ErrorsOfRooms& rooms, Of of) {
  double least = of(rooms[0]), most = least;
  for (const RoomErrors& room : rooms) {
    least = std::min(least, of(room));
    most = std::max(most, of(room));
  }
  return 100 * (most - least) / least;
}

double position_of_room(const RoomErrors& room) { return room.position_mm.mean(); }
double force_of_room(const RoomErrors& room) { return room.force_N.mean(); }

double level_of_room(std::size_t room) { return kGreyPer1000Lux * kRooms_lux[room] / 1000.0; }

/// The frames of a finger in all rooms.
Result<int> measure_rooms(const ExperimentBench& bench, ErrorsOfRooms& rooms) {
  int frames = 0;
  for (std::size_t i = 0; i < kRooms; ++i) {
    ExperimentBench::Measuring room;
    room.room_level = level_of_room(i);
    const auto contact_frames =
        bench.measure("experiment_room_light", room,
                      [&](std::size_t, const Truth& truth, const FrameResult& result) {
                        if (!result.regions.empty())
                          rooms[i].position_mm.add(
                              position_error_mm(result.regions.front(), truth.contacts.front()));
                      });
    if (!contact_frames) return contact_frames.error();
    const auto pushed = bench.measure(
        "experiment_room_force", room,
        [&](std::size_t, const Truth& truth, const FrameResult& result) {
          if (!result.force) return;
          const Eigen::Vector3d truly_N = truth.contacts.front().force_N.value();
          for (Eigen::Index axis = 0; axis < 2; ++axis)
            rooms[i].force_N.add(std::abs(result.force->force_N[axis] - truly_N[axis]));
        });
    if (!pushed) return pushed.error();
    frames += *contact_frames + *pushed;
  }
  return frames;
}

/// Mean error of the depth in the last room.
Result<double> depth_error_mm(const ExperimentBench& bench, bool correct_light) {
  ExperimentBench::Measuring measuring{
      {PipelineSettings{}}, TruthDetail::kAll, level_of_room(kRooms - 1)};
  measuring.settings.front().correct_light = correct_light;
  Evaluator errors(bench.finger().camera);
  const auto frames =
      bench.measure("experiment_room_light", measuring,
                    [&](std::size_t, const Truth& truth, const FrameResult& result) {
                      if (!result.depth) return errors.add_missing();
                      errors.add(truth, result.depth->depth_mm,
                                 contact_face_points_mm(result, bench.finger().finger.face),
                                 result.markers.value_or(Markers{}));
                    });
  if (!frames) return frames.error();
  const auto mean = errors.evaluation().contact_depth_mm;
  if (!mean) return no_result("experiment_room_light");
  return *mean;
}

std::vector<ExperimentPlot> light_plots(const ErrorsOfRooms& rooms) {
  std::vector<Message> names;
  std::vector<double> position_mm, force_N;
  for (std::size_t i = 0; i < kRooms; ++i) {
    names.push_back(en::say("{} lux", kRooms_lux[i]));
    position_mm.push_back(position_of_room(rooms[i]));
    force_N.push_back(force_of_room(rooms[i]));
  }
  return {
      compared_bars(
          en::say("position error in rooms of different light; the paper gives no figure by room"),
          en::say("mean position error (mm)"), names, position_mm, {}),
      compared_bars(
          en::say("force error in rooms of different light, with a model trained in the dark"),
          en::say("mean error of Fx and Fy (N)"), names, force_N, {})};
}

}  // namespace

Result<ExperimentOutcome> run_room_light(const ExperimentBench& bench) {
  ErrorsOfRooms rooms;
  ExperimentOutcome outcome;
  for (int number = 1; number <= kFingerVariants; ++number) {
    const auto variant = bench.variant(number);
    if (!variant) return variant.error();
    const auto frames = measure_rooms((*variant)->bench, rooms);
    if (!frames) return frames.error();
    outcome.frames += *frames;
  }
  for (std::size_t i = 0; i < kRooms; ++i) {
    if (rooms[i].position_mm.count == 0 || rooms[i].force_N.count == 0)
      return no_result("experiment_room_light");
    outcome.figures.push_back({en::say("position, mean error at {} lux", kRooms_lux[i]),
                               "mm",
                               position_of_room(rooms[i]),
                               {},
                               {}});
    outcome.figures.push_back({en::say("force, mean error at {} lux", kRooms_lux[i]),
                               "N",
                               force_of_room(rooms[i]),
                               {},
                               {}});
  }
  const auto corrected = depth_error_mm(bench, true);
  if (!corrected) return corrected.error();
  const auto ignored = depth_error_mm(bench, false);
  if (!ignored) return ignored.error();
  outcome.figures.push_back({en::say("position, greatest change between rooms"),
                             "%",
                             change_percent(rooms, position_of_room),
                             {},
                             kAimChange_percent});
  outcome.figures.push_back({en::say("force, greatest change between rooms"),
                             "%",
                             change_percent(rooms, force_of_room),
                             {},
                             kAimChange_percent});
  outcome.figures.push_back(
      {en::say("depth inside contacts, mean error at {} lux", kRooms_lux.back()),
       "mm",
       *corrected,
       {},
       {}});
  outcome.figures.push_back(
      {en::say("the same without correction of the light"), "mm", *ignored, {}, {}});
  outcome.remarks = {
      en::say("The scene assumes how much of a room's light enters a finger: 4 grey levels of a "
              "white surface per 1000 lux; every room shows the same frames")};
  outcome.plots = light_plots(rooms);
  return outcome;
}

}  // namespace alltact
