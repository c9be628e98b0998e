#include "core/batch/parts.h"

#include "core/base/atomic_file.h"
#include "core/recording/depth_video.h"

#include <cassert>
#include <charconv>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "alltact-part/2";
constexpr int kMaxParts = 10000;

Error damaged(const fs::path& file) {
  return {en::say("the part is damaged or cut short"), file.string(),
          en::say("reconstruct this part again")};
}

bool is_possible(const Part& part) {
  return part.number >= 1 && part.number <= part.of && part.of <= kMaxParts;
}

/// Strict: the library would round 1.5 and truncate 1e99.
template <class Count>
Count count_in(const Json& head, const char* key) {
  const Json& value = head.at(key);
  if (!value.is_number_unsigned() || !std::in_range<Count>(value.get<std::uint64_t>()))
    throw std::out_of_range(key);
  return value.get<Count>();
}

Result<PartResults> read_part(const fs::path& file) {
  const auto content = read_file(file);
  if (!content) return content.error();
  std::istringstream stream(*content);
  std::string line;
  PartResults results;
  results.file = file;
  try {
    if (!std::getline(stream, line)) return damaged(file);
    const Json head = Json::parse(line);
    if (head.at("format") != kFormat) return damaged(file);
    results.part = {count_in<int>(head, "part"), count_in<int>(head, "of")};
    results.run = head.at("run");
    results.first = count_in<std::size_t>(head, "first");
    results.frame_count = count_in<std::size_t>(head, "frame_count");
    results.is_continuous = head.at("continuous");
    const auto count = count_in<std::size_t>(head, "frames");
    if (!is_possible(results.part)) return damaged(file);
    while (std::getline(stream, line)) results.lines.push_back(line);
    if (results.lines.size() != count) return damaged(file);
  } catch (const std::exception&) {
    return damaged(file);
  }
  return results;
}

Result<std::vector<fs::path>> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().filename().string().front() != '.') files.push_back(entry->path());
  if (error)
    return Error{en::say("the folder cannot be read: {}", error.message()), folder.string(),
                 en::say("check the path for typing errors")};
  std::sort(files.begin(), files.end());
  return files;
}

bool is_part(const fs::path& file) { return file.filename().string().starts_with("results.part-"); }

bool is_part_video(const fs::path& file) {
  return file.filename().string().starts_with("depth.part-");
}

/// Parts by number, each once, all of one run.
Result<std::map<int, PartResults>> find_parts(const std::vector<fs::path>& folders) {
  std::map<int, PartResults> parts;
  for (const fs::path& folder : folders) {
    const auto files = files_in(folder);
    if (!files) return files.error();
    for (const fs::path& file : *files) {
      if (!is_part(file)) continue;
      auto results = read_part(file);
      if (!results) return results.error();
      const PartResults& first = parts.empty() ? *results : parts.begin()->second;
      if (results->run != first.run || results->part.of != first.part.of)
        return Error{en::say("these are parts of two different runs: {} and {}",
                             parts.begin()->second.file, file),
                     file.string(),
                     en::say("the folders of one run, or reconstruct all its parts again")};
      const int number = results->part.number;
      const auto [before, is_new] = parts.emplace(number, std::move(*results));
      if (!is_new)
        return Error{en::say("part {} exists twice: {} and {}", number, before->second.file, file),
                     file.string(), en::say("remove one of them")};
    }
  }
  return parts;
}

Status check_complete(const std::map<int, PartResults>& parts, const fs::path& folder) {
  if (parts.empty())
    return Error{en::say("there are no parts of a reconstruction"), folder.string(),
                 en::say("alltact reconstruct with --shard 1/N to N/N first")};
  const int of = parts.begin()->second.part.of;
  const std::size_t total_frames = parts.begin()->second.frame_count;
  std::string missing;
  for (int number = 1; number <= of; ++number)
    if (!parts.contains(number)) missing += (missing.empty() ? "" : ", ") + std::to_string(number);
  if (!missing.empty())
    return Error{en::say("of {} parts these are missing: {}", of, missing), folder.string(),
                 en::say("reconstruct these parts, too")};
  for (const auto& [number, part] : parts) {
    const BatchFrames frames = frames_of(part.part, part.frame_count);
    if (part.first != frames.first || part.frame_count != total_frames) return damaged(part.file);
    if (part.lines.size() != frames.end - frames.first)
      return Error{en::say("the part was stopped after {} of {} frames", part.lines.size(),
                           frames.end - frames.first),
                   part.file.string(), en::say("reconstruct this part again")};
  }
  return {};
}

/// The content of results.jsonl. Counts its frames in `merged`.
Result<std::string> merge_lines(const std::map<int, PartResults>& parts, MergedParts& merged) {
  std::string content;
  FingerContactTracker contacts(parts.begin()->second.is_continuous);
  std::set<std::string> names;
  for (const auto& [number, part] : parts) {
    for (const std::string& text : part.lines) {
      const auto line = FrameLine::from_json(text);
      if (!line) return damaged(part.file);
      if (!names.insert(line->frame).second)
        return Error{en::say("another image is called '{}' as well", line->frame),
                     part.file.string(), en::say("giving the images different names")};
      content += complete_line(*line, contacts) + "\n";
      ++merged.frames;
      merged.failed += line->is_measured ? 0 : 1;
    }
  }
  return content;
}

/// Moves the files of frames, not the parts.
Status move_files(const fs::path& from, const fs::path& to) {
  const auto files = files_in(from);
  if (!files) return files.error();
  for (const fs::path& file : *files) {
    std::error_code error;
    if (is_part(file) || is_part_video(file) || !fs::is_regular_file(file, error) ||
        file.filename() == "results.jsonl")
      continue;
    const fs::path there = to / file.filename();
    fs::rename(file, there, error);
    if (error) {  // another disk
      fs::copy_file(file, there, fs::copy_options::overwrite_existing, error);
      if (!error) fs::remove(file, error);
    }
    if (error)
      return Error{en::say("the file cannot be moved: {}", error.message()), there.string(),
                   en::say("free some space, or ask the folder's owner for access")};
  }
  return {};
}

/// The depth videos by part, if the run made any; a part without frames needs none. Error: one is
/// missing.
Result<std::vector<fs::path>> part_videos(const std::map<int, PartResults>& parts) {
  std::vector<fs::path> videos;
  bool any = false;
  const fs::path* missing = nullptr;
  for (const auto& [number, part] : parts) {
    const fs::path video = part.file.parent_path() / part_video(part.part);
    std::error_code error;
    const bool is_there = fs::exists(video, error);
    any = any || is_there;
    if (part.lines.empty()) continue;
    if (is_there)
      videos.push_back(video);
    else
      missing = &part.file;
  }
  if (!any) return std::vector<fs::path>();
  if (missing != nullptr)
    return Error{en::say("the part's video of depth is missing"), missing->string(),
                 en::say("reconstruct this part again")};
  return videos;
}

/// Joins the compressed images of all videos without encoding them again.
Status join_videos(const std::vector<fs::path>& videos, const fs::path& joined) {
  std::optional<DepthVideoWriter> writer;
  for (const fs::path& file : videos) {
    auto video = DepthVideo::open(file);
    if (!video) return video.error();
    if (!writer) {
      auto made = DepthVideoWriter::create(joined, video->size(), video->frames_per_s());
      if (!made) return made.error();
      writer = std::move(*made);
    }
    while (true) {
      const auto packet = video->next_packet();
      if (!packet) return packet.error();
      if (packet->empty()) break;
      if (Status status = writer->add(*packet); !status) return status;
    }
  }
  return writer ? writer->finish() : Status();
}

}  // namespace

Result<Part> part_of(const std::string& text) {
  Part part;
  const char *begin = text.data(), *end = begin + text.size();
  const auto number = std::from_chars(begin, end, part.number);
  const bool has_slash = number.ec == std::errc() && number.ptr != end && *number.ptr == '/';
  const auto of = has_slash ? std::from_chars(number.ptr + 1, end, part.of) : number;
  if (!has_slash || of.ec != std::errc() || of.ptr != end || !is_possible(part))
    return Error{en::say("'{}' is not a valid part", text), "",
                 en::say("1/8 to 8/8 for eight parts, for example")};
  return part;
}

BatchFrames frames_of(const Part& part, std::size_t frame_count) {
  const std::size_t pieces = (frame_count + kPieceFrames - 1) / kPieceFrames;
  const auto number = static_cast<std::size_t>(part.number), of = static_cast<std::size_t>(part.of);
  return {std::min(frame_count, pieces * (number - 1) / of * kPieceFrames),
          std::min(frame_count, pieces * number / of * kPieceFrames)};
}

std::string part_file(const Part& part) {
  return fmt::format("results.part-{}-of-{}.jsonl", part.number, part.of);
}

std::string part_video(const Part& part) {
  return fmt::format("depth.part-{}-of-{}.mkv", part.number, part.of);
}

Status write_part(const fs::path& folder, const PartResults& results) {
  Json head;
  head["format"] = kFormat;
  head["part"] = results.part.number;
  head["of"] = results.part.of;
  head["run"] = results.run;
  head["first"] = results.first;
  head["frame_count"] = results.frame_count;
  head["continuous"] = results.is_continuous;
  head["frames"] = results.lines.size();
  std::string text = head.dump() + "\n";
  for (const std::string& line : results.lines) text += line + "\n";
  return write_file_atomically(folder / part_file(results.part), text);
}

Result<MergedParts> merge_parts(const std::vector<fs::path>& folders) {
  assert(!folders.empty());
  const fs::path& folder = folders.front();
  const auto parts = find_parts(folders);
  if (!parts) return parts.error();
  if (const Status status = check_complete(*parts, folder); !status) return status.error();
  MergedParts merged;
  const auto lines = merge_lines(*parts, merged);
  if (!lines) return lines.error();
  const auto videos = part_videos(*parts);
  if (!videos) return videos.error();
  std::error_code ignored;
  for (std::size_t i = 1; i < folders.size(); ++i)
    if (!fs::equivalent(folders[i], folder, ignored))
      if (const Status status = move_files(folders[i], folder); !status) return status.error();
  if (const Status status = join_videos(*videos, folder / kDepthVideoFile); !status)
    return status.error();
  if (const Status status = sync_disk_of(folder); !status) return status.error();
  merged.results = folder / "results.jsonl";
  if (const Status status = write_file_atomically(merged.results, *lines); !status)
    return status.error();
  for (const auto& [number, part] : *parts) {
    fs::remove(part.file.parent_path() / part_video(part.part), ignored);
    fs::remove(part.file, ignored);
  }
  return merged;
}

}  // namespace alltact
