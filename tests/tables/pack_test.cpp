// SPDX-License-Identifier: Apache-2.0
#include "tables/pack.h"

#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "tables/sampler_state.h"
#include "tests/support/describe.h"
#include "tests/support/random.h"

namespace feline {
namespace {

// A field of a generated packed struct: `logic signed [14:0][24:0] level_base;`.
struct Member {
  std::string name;
  bool is_signed;
  int count, width;
};

std::string package_text() {
  std::ifstream file(std::string(FELINE_SOURCE_DIR) + "/tables/generated/feline_pkg.sv");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::map<std::string, std::vector<Member>> package_structs() {
  std::map<std::string, std::vector<Member>> structs;
  const std::regex member(R"(\s*logic (signed )?(?:\[(\d+):0\])?(?:\[(\d+):0\])? ?(\w+);.*)");
  const std::regex end(R"(\s*\} (\w+)_t;)");
  std::vector<Member> members;
  std::istringstream lines(package_text());
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, match, member)) {
      const int first = match[2].matched ? std::stoi(match[2]) + 1 : 1;
      const bool is_array = match[3].matched;
      members.push_back({match[4], match[1].matched, is_array ? first : 1, is_array ? std::stoi(match[3]) + 1 : first});
    } else if (std::regex_match(line, match, end)) {
      structs[match[1]] = std::exchange(members, {});
    }
  }
  return structs;
}

template <typename Beat>
class beats : public ::testing::Test {};  // NOLINT(readability-identifier-naming): the suite's name

using Beats = ::testing::Types<SamplerState<kDefaultConfig>, RequestBeat<kDefaultConfig>, GroupBeat<kDefaultConfig>,
                               FootprintBeat<kDefaultConfig>, PlanBeat<kDefaultConfig>, WalkBeat<kDefaultConfig>,
                               AddressBeat<kDefaultConfig>, FetchBeat<kDefaultConfig>, FilterBeat<kDefaultConfig>,
                               AccumulateBeat<kDefaultConfig>>;
struct BeatName {
  template <typename Beat>
  static std::string GetName(int) {  // NOLINT(readability-identifier-naming): as googletest calls it
    return std::string(Beat::kName.view());
  }
};
TYPED_TEST_SUITE(beats, Beats, BeatName);

template <typename Beat>
Beat random_beat(Random& random) {
  Beat beat;
  for_each_value(beat, [&]<Format kFormat>(const Name&, int, Fixed<kFormat>& value) {
    const auto raw = static_cast<std::int64_t>(random.bits()) >> (64 - kFormat.width());
    value = Fixed<kFormat>::from_raw(kFormat.is_signed ? raw : raw & kFormat.max_raw());
    if (random.one_in(4)) value = Fixed<kFormat>::from_raw(random.one_in(2) ? kFormat.max_raw() : kFormat.min_raw());
  });
  return beat;
}

bool bit_of(std::span<const std::uint32_t> words, int position) {
  return ((words[static_cast<std::size_t>(position / 32)] >> (position % 32)) & 1) != 0;
}

TYPED_TEST(beats, round_trip) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for(TypeParam::kName.view());
  std::vector<std::uint32_t> words(static_cast<std::size_t>(beat_words<TypeParam>()));
  for (int i = 0; i < 10000; ++i) {
    const auto beat = random_beat<TypeParam>(random);
    pack(beat, std::span(words));
    ASSERT_TRUE(same(beat, unpack<TypeParam>(words))) << one_line(beat);
    for (int bit = beat_width<TypeParam>(); bit < 32 * beat_words<TypeParam>(); ++bit) ASSERT_FALSE(bit_of(words, bit));
  }
}

// The generated SystemVerilog, read back: the same names, order, signs and widths; and each bit of each field lies
// where the language puts it, the first field and the last element highest.
TYPED_TEST(beats, bits_lie_where_the_generated_struct_puts_them) {
  const SeedTrace trace(__FILE__, __LINE__);
  const auto structs = package_structs();
  const auto found = structs.find(std::string(TypeParam::kName.view()));
  ASSERT_NE(found, structs.end());
  std::vector<Member> declared;
  for_each_shape<TypeParam>([&](Name name, const Format& format, int count, bool) {
    declared.push_back({std::string(name.view()), format.is_signed, count, format.width()});
  });
  ASSERT_EQ(found->second.size(), declared.size());
  int width = 0;
  for (std::size_t i = 0; i < declared.size(); ++i) {
    EXPECT_EQ(found->second[i].name, declared[i].name);
    EXPECT_EQ(found->second[i].is_signed, declared[i].is_signed) << declared[i].name;
    EXPECT_EQ(found->second[i].count, declared[i].count) << declared[i].name;
    EXPECT_EQ(found->second[i].width, declared[i].width) << declared[i].name;
    width += declared[i].count * declared[i].width;
  }
  EXPECT_EQ(width, beat_width<TypeParam>());
  std::string constant = std::string(TypeParam::kName.view());
  constant[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(constant[0])));
  constant += (constant == "Sampler" ? "Width = " : "BeatWidth = ") + std::to_string(width) + ";";
  EXPECT_NE(package_text().find(constant), std::string::npos) << constant;

  Random random = random_for(TypeParam::kName.view());
  const auto beat = random_beat<TypeParam>(random);
  std::vector<std::uint32_t> words(static_cast<std::size_t>(beat_words<TypeParam>()));
  pack(beat, std::span(words));
  int lowest = width;

  const auto all = field_values(beat);
  auto values = all.begin();
  for (const Member& member : found->second) {
    lowest -= member.count * member.width;
    for (int element = 0; element < member.count; ++element, ++values) {
      for (int bit = 0; bit < member.width; ++bit) {
        ASSERT_EQ(bit_of(words, lowest + element * member.width + bit), ((values->raw >> bit) & 1) != 0)
            << values->name << " bit " << bit;
      }
    }
  }
}

}  // namespace
}  // namespace feline
