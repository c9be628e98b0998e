// What every reader owes to whatever bytes it is given: a value that keeps its laws, or a sentence.
#include "tests/fuzz/readers.h"

#include "tests/fuzz/mutations.h"
#include "tests/support/slow_run.h"

#include <ostream>
#include <random>

#include <gtest/gtest.h>

namespace alltact::test {

void PrintTo(const Reader& reader, std::ostream* stream) { *stream << reader.name; }

namespace {

/// About how many bytes a format may cost in all.
std::size_t budget() { return is_slow_run() ? 200'000'000 : 150'000; }

class Readers : public testing::TestWithParam<Reader> {};

TEST_P(Readers, TakeWhatTheProgramWrites) {
  const Reader& reader = GetParam();
  ASSERT_FALSE(reader.seeds().empty());
  for (const std::string& seed : reader.seeds()) {
    const Reading reading = reader.read(seed);
    EXPECT_EQ(reading.broken, "");
    EXPECT_FALSE(reading.refused) << reading.refused->sentence() << "\n" << seed.substr(0, 2000);
  }
}

TEST_P(Readers, MeetEveryTruncation) {
  const Reader& reader = GetParam();
  for (const std::string& seed : reader.seeds()) {
    const std::size_t step = 1 + seed.size() * seed.size() / 2 / budget();
    for (std::size_t length = 0; length < seed.size(); length += step)
      ASSERT_EQ(fault_of(reader, seed.substr(0, length)), "") << length;
  }
}

TEST_P(Readers, MeetDamage) {
  const Reader& reader = GetParam();
  std::mt19937 random(20);
  const auto seeds = reader.seeds();
  for (std::size_t spent = 0; spent < budget();) {
    const std::string bytes = damaged(seeds[random() % seeds.size()], random);
    ASSERT_EQ(fault_of(reader, bytes), "") << bytes;
    spent += 300 + bytes.size();
  }
}

INSTANTIATE_TEST_SUITE_P(Each, Readers, testing::ValuesIn(readers()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace alltact::test
