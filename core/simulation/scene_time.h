// Times in a scene: points in time, and the frames in which an effect is present.
#pragma once

#include "core/yaml/yaml_reader.h"

#include <string>

namespace alltact {

/// The frames of a scene, from the top of its file (`frames`, `frames_per_s`). A source that plays
/// without end restarts after the last one.
struct SceneTime {
  int frames = 1;
  double frames_per_s = 30;

  /// For YamlFile::read(); `part` is any section of the scene.
  static SceneTime of(const YamlSection& part);

  /// A point in time as a number of frames: a plain number counts frames (`60`), and seconds have
  /// their unit (`2 s`). Not negative.
  [[nodiscard]] double point(YamlSection& section, const std::string& key) const;
};

/// The frames [first, end) of a scene. `from:` and `until:` give them as points in time: `from` is
/// the first frame with the effect, `until` the first one without it. An effect until 2 s and one
/// from 2 s thus follow each other. Defaults: the beginning and the end.
struct Presence {
  int first = 0, end = 1;

  /// For YamlFile::read(). An empty presence is refused.
  static Presence read(YamlSection& effect, const SceneTime& time);

  [[nodiscard]] bool holds(int frame) const { return frame >= first && frame < end; }
  [[nodiscard]] bool overlaps(const Presence& other) const {
    return first < other.end && other.first < end;
  }
};

}  // namespace alltact
