// Prints how deep a calibrated finger is pressed, live: measure_live FINGER SOURCE
#include <cstdio>

#include <alltact/core/open/open_source.h>
#include <alltact/core/sensing/pipeline.h>
#include <alltact/core/sources/source.h>

int main(int argc, char** argv) {
  using namespace alltact;
  const auto fail = [](const Error& e) {
    return std::fprintf(stderr, "%s\n", e.sentence().c_str()), 1;
  };
  if (argc != 3) return std::fputs("usage: measure_live FINGER SOURCE\n", stderr), 2;
  const auto finger = open_finger(argv[1]);
  if (!finger) return fail(finger.error());
  auto source = open_source({argv[2]}, {.pace = Pace::kRecorded});
  if (!source) return fail(source.error());
  auto pipeline = Pipeline::create(**finger, PipelineSettings(), Job());
  if (!pipeline) return fail(pipeline.error());
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  NewestSource frames(std::move(*source));
  for (auto frame = frames.next(); frame && *frame; frame = frames.next())
    if (const auto measured = (*pipeline)(*frame); measured && !measured->regions.empty())
      std::printf("%s %.3f mm\n", (*frame)->name.c_str(), measured->regions.front().deepest_mm);
}
