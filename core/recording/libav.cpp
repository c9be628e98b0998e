#include "core/recording/libav.h"

#include "core/base/slow_disk.h"

#include <array>
#include <string>

namespace alltact {
namespace {

Error no_video(const Message& what, const std::filesystem::path& file) {
  return {what, file.string(),
          en::say("play it in a video player; if that fails too, record it again")};
}

}  // namespace

Error av_error(const Message& doing, const std::filesystem::path& file, int number) {
  const int system = AVUNERROR(number);
  if (system > 0 && system < 200) return system_error(doing, file, system);
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(number, text.data(), text.size());
  return {en::at(doing, Message::typed(text.data())), file.string(), en::say("once more")};
}

bool VideoInput::read(AVPacket& packet) const {
  const DiskWait waiting(context->url);
  while (true) {
    av_packet_unref(&packet);
    if (av_read_frame(context.get(), &packet) < 0) return false;
    if (packet.stream_index == stream) return true;
  }
}

Result<VideoInput> open_video_input(const std::filesystem::path& file) {
  quiet_libav();
  const Message cannot = en::say("the video cannot be opened");
  const DiskWait waiting(file);
  // Not texts, images and lists of other files, which libav takes for videos as well.
  constexpr const char* kContainers =
      "matroska,mov,avi,mpegts,mpeg,mpegvideo,m4v,h264,hevc,mjpeg,flv,asf,ogg,nut,ivf,yuv4mpegpipe,"
      "dv,mxf,gif,rm,wtv,obu,apng";
  AVFormatContext* raw = nullptr;
  AVDictionary* options = nullptr;
  av_dict_set(&options, "format_whitelist", kContainers, 0);
  av_dict_set(&options, "protocol_whitelist", "file", 0);
  const std::string url = "file:" + file.string();  // a name may contain a colon
  const int opened = avformat_open_input(&raw, url.c_str(), nullptr, &options);
  av_dict_free(&options);
  if (opened < 0) return no_video(cannot, file);
  VideoInput input{AvInput(raw), -1};
  // Matroska's header is complete; other formats need a search of the stream.
  if (!input.is_matroska() && avformat_find_stream_info(raw, nullptr) < 0)
    return no_video(cannot, file);
  input.stream = av_find_best_stream(raw, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
  if (input.stream < 0) return no_video(cannot, file);
  for (unsigned i = 0; i < raw->nb_streams; ++i)
    if (static_cast<int>(i) != input.stream) raw->streams[i]->discard = AVDISCARD_ALL;
  return input;
}

}  // namespace alltact
