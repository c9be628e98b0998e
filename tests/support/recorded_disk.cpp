#include "tests/support/recorded_disk.h"

#include "core/finger/finger_store.h"
#include "tests/support/temporary_folder.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string parent_of(const std::string& name) {
  const std::size_t slash = name.rfind('/');
  return slash == std::string::npos ? std::string() : name.substr(0, slash);
}

std::string names_of(const DiskModel::Files& files, const DiskModel::Files& before,
                     const DiskModel::Files& after) {
  std::string names;
  for (const auto& [name, bytes] : files) {
    const auto is_in = [&, n = name, b = bytes](const DiskModel::Files& others) {
      const auto found = others.find(n);
      return found != others.end() && found->second == b;
    };
    names += name +
             (is_in(before)  ? is_in(after) ? " (both)" : " (old)"
              : is_in(after) ? " (new)"
                             : " (neither)") +
             "\n";
  }
  return names;
}

}  // namespace

std::vector<DiskOperation> disk_log(const fs::path& file) {
  std::istringstream stream(bytes_of(file));
  std::vector<DiskOperation> operations;
  for (std::string line; std::getline(stream, line);) {
    DiskOperation one;
    std::istringstream words(line);
    std::string size;
    std::getline(words, one.what, '\t');
    std::getline(words, size, '\t');
    std::getline(words, one.path);
    one.bytes.resize(std::stoul(size));
    stream.read(one.bytes.data(), std::ssize(one.bytes));
    if (one.what == "write" || one.what == "cut") {
      const std::size_t dot = one.path.find('.');
      one.at = std::stoul(one.path.substr(0, dot));
      one.path = one.path.substr(dot + 1);
    } else if (one.what == "rename") {
      one.other = one.bytes;
    } else if (one.what == "stream") {
      throw std::runtime_error("written as a stream, which cannot be seen: " + one.path);
    }
    operations.push_back(std::move(one));
  }
  return operations;
}

DiskModel::DiskModel(const fs::path& folder) : folder_(folder.string()) {
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = inside(entry.path().string());
    if (entry.is_directory()) {
      now_.folders.insert(name);
      continue;
    }
    const std::string bytes = bytes_of(entry.path());
    now_.files[name] = std::make_shared<File>(File{bytes, bytes});
  }
  now_.folders.insert("");
  synced_ = now_;
}

std::string DiskModel::inside(const std::string& path) const {
  if (path == folder_) return {};
  if (!path.starts_with(folder_ + "/")) throw std::runtime_error("not in the folder: " + path);
  return path.substr(folder_.size() + 1);
}

void DiskModel::sync(const std::string& name) {
  if (const auto file = now_.files.find(name); file != now_.files.end()) {
    file->second->synced = file->second->now;
    return;
  }
  const auto lies_here = [&](const std::string& other) {
    return !other.empty() && parent_of(other) == name;
  };
  std::erase_if(synced_.files, [&](const auto& entry) { return lies_here(entry.first); });
  std::erase_if(synced_.folders, lies_here);
  for (const auto& [other, file] : now_.files)
    if (lies_here(other)) synced_.files[other] = file;
  for (const std::string& other : now_.folders)
    if (lies_here(other)) synced_.folders.insert(other);
}

void DiskModel::apply(const DiskOperation& operation) {
  const std::string name = inside(operation.path);
  if (operation.what == "make") {
    now_.files[name] = std::make_shared<File>();
  } else if (operation.what == "write") {
    std::string& bytes = now_.files.at(name)->now;
    bytes.resize(std::max(bytes.size(), operation.at + operation.bytes.size()));
    bytes.replace(operation.at, operation.bytes.size(), operation.bytes);
  } else if (operation.what == "cut") {
    now_.files.at(name)->now.resize(operation.at);
  } else if (operation.what == "sync") {
    sync(name);
  } else if (operation.what == "syncall") {
    for (auto& [other, file] : now_.files) file->synced = file->now;
    synced_ = now_;
  } else if (operation.what == "rename") {
    const auto from = now_.files.extract(name);
    if (from) now_.files[inside(operation.other)] = from.mapped();
  } else if (operation.what == "unlink") {
    now_.files.erase(name);
  } else if (operation.what == "mkdir") {
    now_.folders.insert(name);
  } else if (operation.what == "rmdir") {
    now_.folders.erase(name);
  } else {
    throw std::runtime_error("unknown: " + operation.what);
  }
}

DiskModel::Files DiskModel::files(Lost lost) const {
  const bool has_names = lost == Lost::kNothing || lost == Lost::kBytes;
  const bool has_bytes = lost == Lost::kNothing || lost == Lost::kNames;
  const Names& names = has_names ? now_ : synced_;
  Files files;
  for (const auto& [name, file] : names.files) {
    bool is_reached = true;
    for (std::string above = parent_of(name); is_reached && !above.empty();
         above = parent_of(above))
      is_reached = names.folders.contains(above);
    if (is_reached) files[name] = has_bytes ? file->now : file->synced;
  }
  return files;
}

DiskModel::Files shown(const DiskModel::Files& files) {
  DiskModel::Files left;
  for (const auto& [name, bytes] : files)
    if (name.find("/.") == std::string::npos && name.front() != '.') left[name] = bytes;
  return left;
}

DiskModel::Files files_in(const fs::path& folder) {
  return shown(DiskModel(folder).files(DiskModel::Lost::kNothing));
}

void lay_out(const DiskModel::Files& files, const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  for (const auto& [name, bytes] : files) {
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name, std::ios::binary) << bytes;
  }
}

void expect_old_or_new_after_cuts(DiskModel before, const std::vector<DiskOperation>& operations,
                                  const fs::path& finger) {
  DiskModel& disk = before;
  const DiskModel::Files old_files = shown(disk.files(DiskModel::Lost::kNothing));
  const DiskModel::Files new_files = files_in(finger);
  ASSERT_NE(old_files, new_files);
  const TemporaryFolder scratch;
  std::set<DiskModel::Files> seen;
  std::size_t old_ones = 0, new_ones = 0;
  for (std::size_t done = 0; done <= operations.size(); ++done) {
    if (done > 0) disk.apply(operations[done - 1]);
    for (const DiskModel::Lost lost : kEveryLoss) {
      const DiskModel::Files left = disk.files(lost);
      if (!seen.insert(left).second) continue;
      const fs::path folder = scratch / std::to_string(seen.size());
      lay_out(left, folder);
      const auto opened = open_finger(folder);
      ASSERT_TRUE(opened) << opened.error().sentence() << " after " << done << " of "
                          << operations.size();
      const DiskModel::Files found = files_in(folder);
      EXPECT_TRUE(found == old_files || found == new_files)
          << "cut after " << done << " of " << operations.size() << ", "
          << (done > 0 ? operations[done - 1].what + " " + operations[done - 1].path : "") << "\n"
          << names_of(found, old_files, new_files);
      old_ones += found == old_files, new_ones += found == new_files;
      fs::remove_all(folder);
    }
  }
  EXPECT_GT(old_ones, 0U);
  EXPECT_GT(new_ones, 0U);
  std::printf("[ figures  ] %zu operations, %zu states of the disk: %zu old, %zu new\n",
              operations.size(), seen.size(), old_ones, new_ones);
}

}  // namespace alltact::test
