// What a scene may not say: for every class of mistakes several texts, each with the sentence that
// it is refused with - what, file, line and key - and what to try instead.
#include "tests/core/simulation/refused_scene.h"

namespace alltact {
namespace {

TEST(RefusedScene, WhatIsNoNumberOrOutOfRange) {
  expect_refused({
      {effects({"use: read, sd: 0x10"}),
       "10: read.sd: must be a number above 0 and up to 100, not '0x10'. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: 1.5mm"}),
       "10: read.sd: must be a number above 0 and up to 100, not '1.5mm'. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: 1,5"}),
       "10: effects[0].sd: a comma separates entries here, and '5' is none. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: 1 5"}),
       "10: read.sd: must be a number above 0 and up to 100, not '1 5'. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: nan"}),
       "10: read.sd: must be a number above 0 and up to 100, not 'nan'. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: .nan"}),
       "10: read.sd: must be a number above 0 and up to 100, not '.nan'. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: inf"}),
       "10: read.sd: must be a number above 0 and up to 100, not 'inf'. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: -.inf"}),
       "10: read.sd: must be a number above 0 and up to 100, not '-.inf'. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: infinity"}),
       "10: read.sd: must be a number above 0 and up to 100, not 'infinity'. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: 1e999"}),
       "10: read.sd: must be a number above 0 and up to 100, not '1e999'. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: 1e-400"}),
       "10: read.sd: must be a number above 0 and up to 100, not '1e-400'. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: '1'"}),
       "10: read.sd: must be a number above 0 and up to 100, not '1'. Try: a number such as 24.0, "
       "with a point and without a unit."},
      {effects({"use: read, sd: 0b1"}),
       "10: read.sd: must be a number above 0 and up to 100, not '0b1'. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: 1_000"}),
       "10: read.sd: '1_000' contains a thousands separator: write 1000. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: +-1"}),
       "10: read.sd: must be a number above 0 and up to 100, not '+-1'. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: ++1"}),
       "10: read.sd: must be a number above 0 and up to 100, not '++1'. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: 1e"}),
       "10: read.sd: must be a number above 0 and up to 100, not '1e'. Try: a number such as 24.0, "
       "with a point and without a unit."},
      {effects({"use: read, sd: true"}),
       "10: read.sd: must be a number above 0 and up to 100, not 'true'. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: ~"}),
       "10: read.sd: must be a number above 0 and up to 100, not nothing. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: "}),
       "10: read.sd: must be a number above 0 and up to 100, not nothing. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: -1"}),
       "10: read.sd: must be a number above 0 and up to 100, not '-1'."},
      {effects({"use: read, sd: 101"}),
       "10: read.sd: must be a number above 0 and up to 100, not '101'."},
      {effects({"use: read, sd: [1]"}),
       "10: read.sd: must be a number above 0 and up to 100, not a list. Try: a number such as "
       "24.0, with a point and without a unit."},
      {effects({"use: read, sd: {a: 1}"}),
       "10: read.sd: must be a number above 0 and up to 100, not a block of keys. Try: a number "
       "such as 24.0, with a point and without a unit."},
  });
}

TEST(RefusedScene, WhatIsMissingUnknownOrGivenTwice) {
  expect_refused({
      {effects({"use: read, sd: 1, sd: 2"}),
       "10: effects[0].sd: is given twice. Try: delete one of the two."},
      {effects({"use: read, use: read, sd: 1"}),
       "10: effects[0].use: is given twice. Try: delete one of the two."},
      {effects({"use: Read, sd: 1"}),
       "10: effects[0].use: there is no effect 'Read'. Try: 'read', or else one of absorption"},
      {effects({"Use: read, sd: 1"}),
       "10: effects[0].use: is missing. Try: write 'use' instead of 'Use'."},
      {effects({"use: [read], sd: 1"}), "10: effects[0].use: must be text, not a list."},
      {effects({"use: , sd: 1"}), "10: effects[0].use: must be text, not nothing."},
      {effects({"use: read"}), "10: read.sd: is missing. Try: add 'sd: ...' under 'read:'."},
      {effects({"use: read, sdev: 1"}),
       "10: read.sd: is missing. Try: add 'sd: ...' under 'read:'."},
      {effects({"use: read, sd: 1, gain: 1"}),
       "10: read.gain: unknown key 'gain'. Try: one of use, from, until, sd."},
      {effects({"sd: 1"}),
       "10: effects[0].use: is missing. Try: add 'use: ...' under 'effects[0]:'."},
      {effects({"use: ball, radius: 4, s_mm: 40, y_mm: 0, depth_mm: 1"}),
       "10: ball.radius_mm: is missing. Try: write 'radius_mm' instead of 'radius'."},
      {effects({"use: read, SD: 1"}), "10: read.sd: is missing. Try: write 'sd' instead of 'SD'."},
      {effects({"use: bubble, s: 40, y_mm: 0, radius_mm: 1"}),
       "10: bubble.s_mm: is missing. Try: write 's_mm' instead of 's'."},
  });
}

TEST(RefusedScene, FingersAndCamerasThatCannotBe) {
  expect_refused({
      {changed("frames: 3", "frames: 0"),
       "7: frames: must be an integer from 1 to 1000000, not '0'."},
      {changed("frames: 3", "frames: 2.5"),
       "7: frames: must be an integer from 1 to 1000000, not '2.5'."},
      {changed("frames: 3", "frames: 3\nframes: 4"),
       "8: frames: is given twice. Try: delete one of the two."},
      {changed("frames: 3", "frames: 3\nframes_per_s: 0"),
       "8: frames_per_s: must be a number from 0.1 and up to 10000, not '0'."},
      {changed("frames: 3", "frame: 3"),
       "7: frame: unknown key 'frame'. Try: 'frames', or else one of name, why, frames, "
       "frames_per_s, finger, untouched, motion, effects."},
      {changed("frames: 3", "frames: 3 s"),
       "7: frames: must be an integer from 1 to 1000000, not '3 s'."},
      {changed("frames: 3", "frames: 0x3"),
       "7: frames: must be an integer from 1 to 1000000, not '0x3'."},
      {changed("size: [320, 180]", "size: [320]"),
       "4: finger.camera.size: this is not a list of the right length. Try: [2 numbers]."},
      {changed("size: [320, 180]", "size: [320, 180.5]"),
       "4: finger.camera.size: this is not [width, height]. Try: integers from 16 to 16384."},
      {changed("size: [320, 180]", "size: [320, 8]"),
       "4: finger.camera.size: holds '8', which is not a number from 16 and up to 16384."},
      {changed("fx: 170", "fx: 0"),
       "4: finger.camera.fx: 0 means that it is absent; leave out what is absent. Try: leave it "
       "out, or enter a number above 0 and up to 1e+06."},
      {changed("fx: 170", "fx: 170, fx: 171"),
       "4: finger.camera.fx: is given twice. Try: delete one of the two."},
      {changed("fx: 170", "f: 170"),
       "4: finger.camera.fx: is missing. Try: add 'fx: ...' under 'finger.camera:'."},
      {changed("model: pinhole", "model: pin"),
       "4: finger.camera.model: 'pin' is not known here. Try: one of pinhole, brown, fisheye, "
       "orthographic."},
      {changed("model: pinhole", "model: pinhole, mm_per_px: 3"),
       "4: finger.camera.mm_per_px: unknown key 'mm_per_px'. Try: one of model, size, cx, cy, fx, "
       "fy."},
      {changed("model: pinhole", "model: pinhole, distortion: [0.1]"),
       "4: finger.camera.distortion: unknown key 'distortion'. Try: one of model, size, cx, cy, "
       "fx, fy."},
      {changed("kind: fin_ray", "kind: finray"),
       "5: finger.face.kind: 'finray' is not known here. Try: 'fin_ray', or else one of fin_ray, "
       "flat."},
      {changed("kind: fin_ray", "kind: flat, plane_z_mm: 30"),
       "5: finger.face.width_mm: unknown key 'width_mm'. Try: one of kind, layer_mm, plane_z_mm."},
      {changed("width_mm: 24.0", "width_mm: -24.0"),
       "5: finger.face.width_mm: must be a number above 0 and up to 500, not '-24.0'."},
      {changed("width_mm: 24.0", "width: 24.0"),
       "5: finger.face.width_mm: is missing. Try: write 'width_mm' instead of 'width'."},
      {changed("per_row: 6", "per_row: 1"),
       "6: finger.markers.per_row: must be an integer from 2 to 64, not '1'."},
      {changed("polarity: bright", "polarity: light"),
       "6: finger.markers.polarity: 'light' is not known here. Try: 'bright', or else one of "
       "bright, dark."},
      {changed("incline_deg: 34.0", "incline_deg: 90"),
       "8: untouched.incline_deg: must be a number from -75 and up to 75, not '90'."},
      {changed("incline_deg: 34.0", "incline: 34"),
       "8: untouched.incline_deg: is missing. Try: write 'incline_deg' instead of 'incline'."},
      {changed("length_mm: 116.0", "length_mm: 0"),
       "8: untouched.length_mm: must be a number from 1 and up to 1000, not '0'."},
      {changed("length_mm: 116.0", "length_mm: 116 mm"),
       "8: untouched.length_mm: must be a number from 1 and up to 1000, not '116 mm'. Try: a "
       "number such as 24.0, with a point and without a unit."},
      {changed("name: test", "name: "), "1: name: must be text, not nothing."},
      {changed("name: test", "name: test\nname: again"),
       "2: name: is given twice. Try: delete one of the two."},
      {changed("name: test\n", ""), "1: name: is missing. Try: add 'name: ...'."},
      {changed("why: a finger to test with\n", ""), "1: why: is missing. Try: add 'why: ...'."},
  });
}

TEST(RefusedScene, ListsThatAreNone) {
  expect_refused({
      {changed("effects:\n  - {use: quantisation}", "effects: {use: quantisation}"),
       "9: effects: must be a list, not a block of keys. Try: [..., ...]."},
      {changed("effects:\n  - {use: quantisation}", "effects:\n  - quantisation"),
       "10: effects[0]: must be a block of 'key: value' lines, not 'quantisation'. Try: compare "
       "with another file of this kind."},
      {changed("effects:\n  - {use: quantisation}", "effect:\n  - {use: quantisation}"),
       "1: effects: is missing. Try: write 'effects' instead of 'effect'."},
      {changed("effects:\n  - {use: quantisation}", "effects:\n  -"),
       "11: effects[0].use: is missing. Try: add 'use: ...' under 'effects[0]:'."},
      {changed("effects:\n  - {use: quantisation}", "effects:"),
       "9: effects: must be a list, not nothing. Try: [..., ...]."},
      {changed("effects:\n  - {use: quantisation}",
               "effects:\n  - {use: quantisation, until: 2}\n  - {use: quantisation, from: 1}"),
       "11: quantisation#2.use: the effect 'quantisation' is listed twice for frames 1 to 1. Try: "
       "end one with 'until' before the other begins with 'from'."},
  });
}

TEST(RefusedScene, MotionsOfWhatDoesNotMove) {
  expect_refused({
      {changed("frames: 3", "frames: 3\nmotion: {kind: hold, pose: {q1_mm: 3}}"),
       "8: motion: the motion moves 'q1_mm', but the scene has no such effect. Try: add `bend` or "
       "`sway` to the effects."},
      {changed("frames: 3", "frames: 3\nmotion: {kind: wonder}"),
       "8: motion.kind: 'wonder' is not known here. Try: 'wander', or else one of hold, path, "
       "poses, random, wander."},
      {changed("frames: 3", "frames: 3\nmotion: {kind: poses, poses: []}"),
       "8: motion.poses: the list is empty. Try: one pose per frame."},
      {changed("frames: 3", "frames: 3\nmotion: {kind: random, pose: {q1_mm: 1}}"),
       "8: motion.pose: unknown key 'pose'. Try: one of kind."},
      {changed("frames: 3", "frames: 3\nmotion: {kind: wander}"),
       "8: motion.frames_per_move: is missing. Try: add 'frames_per_move: ...' under 'motion:'."},
      {changed("frames: 3", "frames: 3\nmotion: {kind: wander, frames_per_move: 0}"),
       "8: motion.frames_per_move: must be a number from 1 and up to 10000, not '0'."},
      {changed("frames: 3", "frames: 3\nmotion: {kind: hold, pose: {q_mm: 3}}"),
       "8: motion: the motion moves 'q_mm', but the scene has no such effect. Try: add `bend` or "
       "`sway` to the effects."},
      {changed("effects:\n  - {use: quantisation}",
               "effects:\n  - {use: bend, q1_mm: {from: -1, to: 1}, q2_mm: {from: -1, to: "
               "1}}\nmotion: {kind: hold, pose: {q3_mm: 3}}"),
       "11: motion: the motion moves 'q3_mm', but the scene has no such effect. Try: 'q1_mm', or "
       "else one of q1_mm, q2_mm."},
      {changed("effects:\n  - {use: quantisation}",
               "effects:\n  - {use: bend, q1_mm: {from: -1, to: 1}, q2_mm: {from: -1, to: "
               "1}}\nmotion: {kind: hold, pose: {q1_mm: 3}}"),
       "11: motion: q1_mm = 3 is outside the effect's range. Try: -1 to 1."},
      {changed("effects:\n  - {use: quantisation}",
               "effects:\n  - {use: quantisation}\nmotion: {kind: random}"),
       "11: motion: the motion has nothing to move. Try: add `bend` or `sway` to the effects, or "
       "leave the motion out."},
  });
}

}  // namespace
}  // namespace alltact
