#include "core/thumbnail/thumbnail.h"

#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "core/base/atomic_file.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

namespace alltact {
namespace {

struct ThumbnailOptions {
  Path file, output;
  int size_px = 256;  ///< of the longer side
};

/// Writes a thumbnail of a depth map or a mesh for file managers (thumbnail.h).
Status run_thumbnail(const ThumbnailOptions& options, Console& console) {
  const auto image = thumbnail_of(options.file, options.size_px);
  if (!image) return image.error();
  std::vector<unsigned char> png;
  cv::imencode(".png", *image, png);
  const Status written = write_file_atomically(
      options.output, std::string_view(reinterpret_cast<const char*>(png.data()), png.size()));
  if (!written) return written;
  console.say(fmt::format("{}: {} x {} px", options.output.string(), image->cols, image->rows));
  console.answer()["picture"] = options.output.string();
  return {};
}

}  // namespace

void add_thumbnail(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ThumbnailOptions>();
  CLI::App* command = add_command(program, "thumbnail");
  command
      ->add_option("FILE", options->file,
                   "NAME.depth.tiff, NAME.depth16.png, or a mesh (ply, vtp, stl, glb, obj)")
      ->required();
  command->add_option("-o,--output", options->output, "Image to write, a PNG")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--size", options->size_px,
                   "Longer side of the image, pixels (16 to 4096; default 256)")
      ->type_name("PX")
      ->transform(typed_integer(16, 4096));
  command->callback([=, &chosen] {
    chosen = [=](Console& console) { return run_thumbnail(*options, console); };
  });
}

}  // namespace alltact
