// What a scene may not say: for every class of mistakes several texts, each with the sentence that
// it is refused with - what, file, line and key - and what to try instead.
#include "tests/core/simulation/refused_scene.h"

namespace alltact {
namespace {

TEST(RefusedScene, TimesThatEndBeforeTheyBegin) {
  expect_refused({
      {effects({"use: shot, gain: 1, from: 2, until: 2"}),
       "10: shot.until: it would never be active, for it begins with frame 2. Try: a later frame, "
       "or leave the effect out."},
      {effects({"use: shot, gain: 1, from: 2, until: 1"}),
       "10: shot.until: it would never be active, for it begins with frame 2. Try: a later frame, "
       "or leave the effect out."},
      {effects({"use: shot, gain: 1, until: 1, from: 2"}),
       "10: shot.until: it would never be active, for it begins with frame 2. Try: a later frame, "
       "or leave the effect out."},
      {effects({"use: shot, gain: 1, from: 1, from: 2"}),
       "10: effects[0].from: is given twice. Try: delete one of the two."},
      {effects({"use: shot, gain: 1, from: 5"}),
       "10: shot.from: the scene ends before that. Try: one of its frames, 0 to 2."},
      {effects({"use: shot, gain: 1, from: -1 s"}),
       "10: shot.from: must be a point in time, not '-1 s'. Try: a frame such as 60, or seconds "
       "such as 2 s."},
      {effects({"use: shot, gain: 1, from: 1 ms"}),
       "10: shot.from: must be a point in time, not '1 ms'. Try: a frame such as 60, or seconds "
       "such as 2 s."},
      {effects({"use: shot, gain: 1, from: 0x1"}),
       "10: shot.from: must be a point in time, not '0x1'. Try: a frame such as 60, or seconds "
       "such as 2 s."},
      {effects({"use: shot, gain: 1, from: nan"}),
       "10: shot.from: must be a point in time, not 'nan'. Try: a frame such as 60, or seconds "
       "such as 2 s."},
      {effects({"use: shot, gain: 1, from: inf"}),
       "10: shot.from: must be a point in time, not 'inf'. Try: a frame such as 60, or seconds "
       "such as 2 s."},
      {effects({"use: shot, gain: 1, from: 1s s"}),
       "10: shot.from: must be a point in time, not '1s s'. Try: a frame such as 60, or seconds "
       "such as 2 s."},
      {effects({"use: ball, radius_mm: 4, s_mm: {from: 30, until: 40}, y_mm: 0, depth_mm: 1"}),
       "10: ball.s_mm.to: is missing. Try: add 'to: ...' under 'ball.s_mm:'."},
      {effects({"use: gamma, gamma: 2, until: 2", "use: gamma, gamma: 2, from: 1"}),
       "11: gamma#2.use: the effect 'gamma' is listed twice for frames 1 to 1. Try: end one with "
       "'until' before the other begins with 'from'."},
  });
}

TEST(RefusedScene, KeyFramesAndRangesOutOfOrder) {
  expect_refused({
      {effects({"use: ball, radius_mm: 4, s_mm: [], y_mm: 0, depth_mm: 1"}),
       "10: ball.s_mm: the list is empty. Try: one number per frame."},
      {effects({"use: ball, radius_mm: 4, s_mm: {from: 30, to: 20}, y_mm: 0, depth_mm: 1"}),
       "10: ball.s_mm.from: 'from' is not below 'to'. Try: an increasing range."},
      {effects({"use: ball, radius_mm: 4, s_mm: {from: 30, to: 30}, y_mm: 0, depth_mm: 1"}),
       "10: ball.s_mm.from: 'from' is not below 'to'. Try: an increasing range."},
      {effects(
           {"use: ball, radius_mm: 4, s_mm: {from: 30, to: 40, by: smooth}, y_mm: 0, depth_mm: 1"}),
       "10: ball.s_mm.by: unknown key 'by'. Try: one of from, to."},
      {effects({"use: ball, radius_mm: 4, s_mm: [{at: 2, is: 30}, {at: 1, is: 40}], y_mm: 0, "
                "depth_mm: 1"}),
       "10: ball.s_mm[1].at: the key frame before it has a later time. Try: key frames in order of "
       "time."},
      {effects({"use: ball, radius_mm: 4, s_mm: [{at: 1, is: 30}, {at: 1, is: 40}], y_mm: 0, "
                "depth_mm: 1"}),
       "10: ball.s_mm[1].at: the key frame before it has the same time. Try: a later time, or "
       "leave one of the two out."},
      {effects({"use: ball, radius_mm: 4, s_mm: [{at: 1, is: 30, is: 40}], y_mm: 0, depth_mm: 1"}),
       "10: ball.s_mm[0].is: is given twice. Try: delete one of the two."},
      {effects({"use: ball, radius_mm: 4, s_mm: [{at: 1, is: 30}, 40], y_mm: 0, depth_mm: 1"}),
       "10: ball.s_mm[1]: must be a block of 'key: value' lines, not '40'. Try: compare with "
       "another file of this kind."},
      {effects({"use: ball, radius_mm: 4, s_mm: [{at: 1, is: 30}, {at: 2, was: 40}], y_mm: 0, "
                "depth_mm: 1"}),
       "10: ball.s_mm[1].is: is missing. Try: add 'is: ...' under 'ball.s_mm[1]:'."},
      {effects({"use: ball, radius_mm: 4, s_mm: [40, {at: 1, is: 30}], y_mm: 0, depth_mm: 1"}),
       "10: ball.s_mm: holds a block of keys, which is not a number from -1000 and up to 1000. "
       "Try: a number such as 24.0, with a point and without a unit."},
      {effects({"use: ball, radius_mm: 4, s_mm: [{at: 1, is: 30}, {at: 2, is: 0x28}], y_mm: 0, "
                "depth_mm: 1"}),
       "10: ball.s_mm[1].is: must be a number from -1000 and up to 1000, not '0x28'. Try: a number "
       "such as 24.0, with a point and without a unit."},
      {effects({"use: bend, q1_mm: 3, q2_mm: {from: -1, to: 1}"}),
       "10: bend.q1_mm: must be a block of 'key: value' lines, not '3'. Try: compare with another "
       "file of this kind."},
      {effects({"use: bend, q1_mm: {from: 1, to: -1}, q2_mm: {from: -1, to: 1}"}),
       "10: bend.q1_mm.from: 'from' is not below 'to'. Try: an increasing range."},
      {effects({"use: bend, q1_mm: {from: -1, to: 200}, q2_mm: {from: -1, to: 1}"}),
       "10: bend.q1_mm.to: must be a number from -100 and up to 100, not '200'."},
  });
}

TEST(RefusedScene, EffectsThatContradictThemselvesOrOthers) {
  expect_refused({
      {effects({"use: ball, radius_mm: 4, s_mm: 40, y_mm: 30, depth_mm: 1"}),
       "10: ball: y_mm is outside the face. Try: -12 to 12."},
      {effects({"use: ball, radius_mm: 4, s_mm: 140, y_mm: 0, depth_mm: 1"}),
       "10: ball: s_mm is beyond the ends of the face. Try: 0 to 116."},
      {effects({"use: ball, radius_mm: 4, s_mm: 40, y_mm: 0, depth_mm: 1.5"}),
       "10: ball: depth_mm = 1.5 reaches through the layer of 1.5 mm. Try: less than "
       "finger.face.layer_mm."},
      {effects({"use: ball, radius_mm: 0.5, s_mm: 40, y_mm: 0, depth_mm: 1"}),
       "10: ball: the ball would sink in past its centre. Try: depth_mm below radius_mm."},
      {effects({"use: dead-pixels"}),
       "10: dead-pixels: there is neither dead nor hot. Try: name one of them."},
      {effects({"use: fixed-pattern"}),
       "10: fixed-pattern: there is neither prnu nor dsnu. Try: name one of them."},
      {effects({"use: leak, lux: 100"}),
       "10: leak.grey_per_lux: is missing. Try: add 'grey_per_lux: ...' under 'leak:'."},
      {effects({"use: leak, lux: 100, grey_per_lux: 1, grey: 3"}),
       "10: leak.grey: unknown key 'grey'. Try: one of use, from, until, lux, grey_per_lux."},
      {effects({"use: leak, grey: 3, grey_per_lux: 1"}),
       "10: leak.grey_per_lux: unknown key 'grey_per_lux'. Try: one of use, from, until, lux, "
       "grey."},
      {effects({"use: leak"}), "10: leak.grey: is missing. Try: add 'grey: ...' under 'leak:'."},
      {effects({"use: flicker, kind: mains, hz: 100, exposure_ms: 1, duty: 0.5, depth: 1"}),
       "10: flicker.duty: unknown key 'duty'. Try: one of use, from, until, kind, hz, exposure_ms, "
       "depth."},
      {effects({"use: flicker, kind: pwm, hz: 100, exposure_ms: 1, depth: 1, duty: 0.5"}),
       "10: flicker.depth: unknown key 'depth'. Try: one of use, from, until, kind, hz, "
       "exposure_ms, duty."},
      {effects({"use: vignetting, kind: cos4, coefficients: [1]"}),
       "10: vignetting.coefficients: unknown key 'coefficients'. Try: one of use, from, until, "
       "kind."},
      {effects({"use: vignetting, kind: polynomial, coefficients: [-2]"}),
       "10: vignetting.coefficients: parts of the image would have no light. Try: 1 + a r^2 + b "
       "r^4 + c r^6 above 0 up to r = 1."},
      {effects({"use: vignetting, kind: cos"}),
       "10: vignetting.kind: 'cos' is not known here. Try: 'cos4', or else one of cos4, "
       "polynomial."},
      {effects({"use: automatic-exposure, target: 60, least: 1, greatest: 1"}),
       "10: automatic-exposure.greatest: the exposure could not change. Try: more than 1."},
      {effects({"use: automatic-exposure, target: 60, least: 2"}),
       "10: automatic-exposure.least: must be a number from 0.001 and up to 1, not '2'."},
      {effects({"use: gamma, gamma: 1"}),
       "10: gamma.gamma: gamma 1 changes nothing. Try: leave gamma out."},
      {effects({"use: sides, albedo: 0.1, depth_mm: 9",
                "use: markers, radius_mm: 1, setback_mm: 4, first: 0.1, last: 0.9, albedo: 1",
                "use: occlusion, count: 2, markers: [1]"}),
       "12: occlusion.markers: unknown key 'markers'. Try: one of use, from, until, count."},
      {effects({"use: occlusion, markers: [1.5]"}),
       "10: occlusion.markers: 1.5 is not a marker number. Try: 0, 1, 2, ...."},
      {effects({"use: sides, albedo: 0.1, depth_mm: 9",
                "use: markers, radius_mm: 1, setback_mm: 4, first: 0.1, last: 0.9, albedo: 1",
                "use: occlusion, markers: [1, 1]"}),
       "12: occlusion.markers: marker 1 is listed twice. Try: each number once."},
      {effects({"use: occlusion, markers: []"}),
       "10: occlusion.markers: this is not a list of the right length. Try: [1 to 128 numbers]."},
      {effects({"use: sides, albedo: 0.1, depth_mm: 9",
                "use: markers, radius_mm: 1, setback_mm: 4, first: 0.1, last: 0.9, albedo: 1",
                "use: occlusion, markers: [12]"}),
       "12: occlusion: there is no marker 12. Try: 0 to 11."},
      {effects({"use: sides, albedo: 0.1, depth_mm: 9",
                "use: markers, radius_mm: 1, setback_mm: 4, first: 0.1, last: 0.9, albedo: 1",
                "use: occlusion, count: 13"}),
       "12: occlusion: more dots would be hidden than there are. Try: up to 12."},
      {effects({"use: sides, albedo: 0.1, depth_mm: 9",
                "use: markers, radius_mm: 1, setback_mm: 4, first: 0.1, last: 0.9, albedo: 1",
                "use: worn-marker, markers: [1, 1], wear: 0.5"}),
       "12: worn-marker.markers: marker 1 is listed twice. Try: each number once."},
      {effects({"use: late, share: 0, by_ms: 3"}),
       "10: late.share: 0 means that it is absent; leave out what is absent. Try: leave it out, or "
       "enter a number above 0 and up to 1."},
      {effects({"use: drop, share: 1"}),
       "10: drop.share: must be a number above 0 and below 1, not '1'."},
      {effects({"use: drop, share: 0.5, run: 0"}),
       "10: drop.run: must be an integer from 1 to 1000, not '0'."},
      {effects({"use: drop, share: 0.5, run: 1.5"}),
       "10: drop.run: must be an integer from 1 to 1000, not '1.5'."},
      {effects({"use: quantisation", "use: mjpeg, quality: 0"}),
       "11: mjpeg.quality: must be an integer from 1 to 100, not '0'."},
      {effects({"use: mjpeg, quality: 80"}),
       "10: mjpeg: JPEG needs integer grey levels. Try: add the effect quantisation."},
      {effects({"use: layer, scatter_per_mm: 0.6, along: x"}),
       "10: layer.along: 'x' is not known here. Try: one of normal, z."},
      {effects({"use: layer, scatter_per_mm: 0.6, along: normal, absorb_per_mm: 0"}),
       "10: layer.absorb_per_mm: 0 means that it is absent; leave out what is absent. Try: leave "
       "it out, or enter a number above 0 and up to 100."},
      {effects({"use: leds, lamps: []"}),
       "10: leds.lamps: there is no lamp. Try: - {at_mm: [x, y, z], power: p}."},
      {effects({"use: leds, lamps: [{at_mm: [0, 0], power: 1}]"}),
       "10: leds.lamps[0].at_mm: this is not a list of the right length. Try: [3 numbers]."},
      {effects({"use: leds, lamps: [{at_mm: [0, 0, nan], power: 1}]"}),
       "10: leds.lamps[0].at_mm: holds 'nan', which is not a number from -1e+06 and up to 1e+06. "
       "Try: a number such as 24.0, with a point and without a unit."},
      {effects({"use: leds, lamps: [{at_mm: [0, 0, 0], power: 1, lobe: 2}]"}),
       "10: leds.lamps[0].lobe: unknown key 'lobe'. Try: one of at_mm, power, aim_mm."},
      {effects({"use: leds, lamps: [{at_mm: [0, 0, 0], power: 1, aim_mm: [0,0,0], lobe: 2}]"}),
       "10: leds.lamps[0].aim_mm: the lamp aims at itself. Try: another point."},
      {effects({"use: leds, lamps: [{at_mm: [0, 0, 0], power: 1, aim_mm: [0,0,9], lobe: 3}]"}),
       "10: leds.lamps[0].lobe: unknown lobe. Try: 1, 2, 4 or 8."},
      {effects({"use: leds, lamps: [{at_mm: [0, 0, 0], power: 1}, {at_mm: [0, 0, 0], power: 1, "
                "colour: red}]"}),
       "10: leds.lamps[1].colour: unknown key 'colour'. Try: one of at_mm, power, aim_mm."},
      {effects({"use: leds, lamps: [{at_mm: [0, 0, 0], power: 1}, {at_mm: [0, 0, 0], powr: 1}]"}),
       "10: leds.lamps[1].power: is missing. Try: write 'power' instead of 'powr'."},
      {effects({"use: markers, radius_mm: 1, setback_mm: 4, first: 0.9, last: 0.1, albedo: 1"}),
       "10: markers.first: 'first' is not below 'last'. Try: e.g. 0.1 and 0.9."},
      {effects({"use: markers, radius_mm: 5, setback_mm: 4, first: 0.1, last: 0.9, albedo: 1"}),
       "10: markers.radius_mm: the dots would cut the face's edge. Try: less than setback_mm."},
      {effects({"use: markers, radius_mm: 1, setback_mm: 4, first: 0.1, last: 0.9, albedo: 1"}),
       "10: markers: markers are engraved in the side faces. Try: add the effect sides."},
      {effects({"use: rolloff, kind: smooth"}),
       "10: rolloff.length_mm: is missing. Try: add 'length_mm: ...' under 'rolloff:'."},
      {effects({"use: rolloff, kind: hertz"}),
       "10: rolloff: nothing is pressed in, so nothing rolls off. Try: add ball or relief."},
      {effects({"use: relief, shape: picture, s_mm: 30, y_mm: 0, depth_mm: 1, mm_per_px: 1, "
                "height_mm: 1, file: none.png"}),
       "10: relief.file: could not read the file: it does not exist. Try: check the path for "
       "typing errors."},
      {effects(
           {"use: relief, shape: t_bar, size_mm: 3, bar_mm: 4, s_mm: 30, y_mm: 0, depth_mm: 1"}),
       "10: relief.bar_mm: the bars are wider than the T. Try: less than size_mm."},
      {effects({"use: relief, shape: t_bar, size_mm: 9, bar_mm: 2, s_mm: 30, y_mm: 0, depth_mm: 1",
                "use: rolloff, kind: hertz"}),
       "11: rolloff: kind hertz is for balls only. Try: kind: smooth with a length_mm."},
      {effects({"use: motion-blur, exposure_ms: 50"}),
       "10: motion-blur: the shutter would be open for longer than a frame lasts. Try: exposure_ms "
       "up to 33.3333."},
      {effects({"use: motion-blur, exposure_ms: 5, moments: 1"}),
       "10: motion-blur.moments: must be an integer from 2 to 100, not '1'."},
      {effects({"use: rolling-shutter, readout_ms: 50"}),
       "10: rolling-shutter: reading the rows would take longer than a frame lasts. Try: "
       "readout_ms up to 33.3333."},
      {effects({"use: dead-lamp, lamp: 0"}),
       "10: dead-lamp: there is no lamp that could fail. Try: name the effect leds too."},
      {effects({"use: leds, lamps: [{at_mm: [0, 0, 0], power: 1}]", "use: dead-lamp, lamp: 3"}),
       "11: dead-lamp: there is no lamp 3. Try: 0 to 0."},
      {effects({"use: flicker, kind: mains, hz: 100, exposure_ms: 1, depth: 1"}),
       "10: flicker: there is no lamp that could flicker. Try: name the effect leds too."},
      {effects({"use: warming, loss: 0.1, after_s: 0"}),
       "10: warming.after_s: 0 means that it is absent; leave out what is absent. Try: leave it "
       "out, or enter a number above 0 and up to 1e+06."},
      {effects({"use: uneven-layer, share: 0.5, length_mm: 3"}),
       "10: uneven-layer.share: must be a number above 0 and up to 0.1, not '0.5'."},
      {effects({"use: bubble, s_mm: 40, y_mm: 0, radius_mm: 1"}),
       "10: bubble: the bubble needs a layer. Try: name the effect layer too."},
      {effects({"use: gamma, gamma: 2", "use: gamma, gamma: 2"}),
       "11: gamma#2.use: the effect 'gamma' is listed twice. Try: remove one of them."},
  });
}

}  // namespace
}  // namespace alltact
