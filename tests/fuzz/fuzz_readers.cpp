// libFuzzer's program: ALLTACT_READER=NAME fuzz_readers [its flags] SEEDS... reads changed bytes
// until it is told to end; fuzz_readers --list names the readers, --seeds FOLDER writes seeds and
// dictionaries of all of them, NAME/ and NAME.dict.
#include "tests/fuzz/readers.h"

#include <cctype>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>

namespace {

using namespace alltact::test;
namespace fs = std::filesystem;

/// Words and short heads of the seeds: what a format's keys and marks are.
std::set<std::string> words_of(const std::vector<std::string>& seeds) {
  constexpr std::size_t kMost = 400, kLongest = 24;
  std::set<std::string> words{"-1", "1e308", "nan", ".inf", "0x7fffffff", "18446744073709551615"};
  for (const std::string& seed : seeds) {
    std::string word;
    for (const char c : seed + ' ') {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-') {
        word += c;
        continue;
      }
      if (word.size() > 1 && word.size() <= kLongest && words.size() < kMost) words.insert(word);
      word.clear();
    }
  }
  return words;
}

void write_seeds(const fs::path& folder) {
  for (const Reader& reader : readers()) {
    const fs::path seeds_folder = folder / reader.name;
    fs::create_directories(seeds_folder);
    const auto seeds = reader.seeds();
    for (std::size_t i = 0; i < seeds.size(); ++i)
      std::ofstream(seeds_folder / ("seed_" + std::to_string(i)), std::ios::binary) << seeds[i];
    std::ofstream dictionary(folder / (std::string(reader.name) + ".dict"));
    for (const std::string& word : words_of(seeds)) dictionary << '"' << word << "\"\n";
  }
}

const Reader& chosen() {
  static const Reader reader = [] {
    const char* name = std::getenv("ALLTACT_READER");
    for (const Reader& one : readers())
      if (name != nullptr && one.name == name) return one;
    std::fprintf(stderr, "ALLTACT_READER must be one of those that --list names.\n");
    std::exit(2);
  }();
  return reader;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  const std::string flag = *count > 1 ? (*arguments)[1] : "";
  if (flag == "--list")
    for (const Reader& reader : readers()) std::printf("%s\n", reader.name.data());
  else if (flag == "--seeds" && *count == 3)
    write_seeds((*arguments)[2]);
  else
    return (void)chosen(), 0;
  std::exit(0);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string fault =
      fault_of(chosen(), std::string(reinterpret_cast<const char*>(data), size));
  if (fault.empty()) return 0;
  std::fprintf(stderr, "BROKEN: %s\n", fault.c_str());
  std::abort();
}
