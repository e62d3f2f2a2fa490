// SPDX-License-Identifier: Apache-2.0
#include "testbench/prune/profile_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/testbench/prune/profiles.h"
#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

using Json = nlohmann::ordered_json;

Profile small_profile() {
  Profile profile;
  SamplerOptions options;
  options.wrap_s = Wrap::kClampToBorder;
  TestTexture(flat_texture(50, 20, 99), "one")
      .observe_in(profile, random_lookups(5, 40), options, "a \"name\" \xc3\xa4");
  options.mode = Mode::kExt;
  TestTexture(flat_texture(16, 16), "two").observe_in(profile, random_lookups(6, 9), options, "other");
  return profile;
}

std::string refusal(const std::string& text) {
  return input_error([&] { profile_from_json(text, "p.json"); });
}

TEST(profile_json, reading_gives_the_same_again) {
  const Profile profile = small_profile();
  const std::string text = profile_to_json(profile);
  EXPECT_EQ(profile_from_json(text, "p.json"), profile);
  EXPECT_EQ(profile_to_json(profile_from_json(text, "p.json")), text);
  EXPECT_EQ(profile_from_json(profile_to_json(Profile{}), "p.json"), Profile{});
  // Layout is nobody's business.
  EXPECT_EQ(profile_from_json(Json::parse(text).dump(), "p.json"), profile);
}

TEST(profile_json, says_what_was_counted) {
  const Profile profile = small_profile();
  const Json json = Json::parse(profile_to_json(profile));
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["lookups"], 49);
  EXPECT_EQ(json["reached"]["sampler"]["mode"], (Json{{"ext", 9}, {"table", 40}}));
  EXPECT_EQ(json["reached"]["sampler"]["wrap"], (Json{{"repeat", 49}, {"clamp_to_border", 49}}));
  EXPECT_EQ(json["reached"]["accumulate"]["status"], (Json{{"none", 49}}));
  EXPECT_EQ(json["sources"]["other"], 1);
  EXPECT_EQ(json["textures"].size(), 2U);
}

// Every prefix is no profile.
TEST(profile_json, cut_short) {
  const std::string text = profile_to_json(small_profile());
  for (std::size_t size = 0; size + 1 < text.size(); size += 1 + size / 16) {
    EXPECT_TRUE(refusal(text.substr(0, size)).starts_with("p.json: JSON: got")) << size;
  }
  EXPECT_NE(refusal(text + "x"), "");
}

// Calls `use` for every place of a document, which it may change.
template <typename Use>
void each_place(Json& json, const std::string& path, const Use& use) {
  use(json, path);
  if (json.is_object()) {
    const std::string before = path.empty() ? "" : path + ".";
    for (auto& [key, value] : json.items()) each_place(value, before + key, use);
  } else if (json.is_array()) {
    for (std::size_t i = 0; i < json.size(); ++i) each_place(json[i], path + "[" + std::to_string(i) + "]", use);
  }
}

// Of every place: a value of another kind is refused, and the message says where.
TEST(profile_json, other_kinds) {
  Json json = Json::parse(profile_to_json(small_profile()));
  int places = 0;
  each_place(json, "", [&](Json& place, const std::string& path) {
    const Json before = place;
    for (const Json& other : {Json(nullptr), Json(-1), Json(1.5), Json(true), Json("x"), Json::array({1, "x"})}) {
      if (other.is_string() && path.find(".names[") != std::string::npos) continue;
      place = other;
      const std::string message = refusal(json.dump());
      place = before;
      ++places;
      EXPECT_TRUE(message.starts_with("p.json: ")) << path;
      EXPECT_NE(message.find(path.empty() ? "profile" : path), std::string::npos) << path << ": " << message;
      EXPECT_NE(message.find("legal is"), std::string::npos) << message;
    }
  });
  EXPECT_GT(places, 1000);
}

// Of every object that has no free names: a field more, a field less.
TEST(profile_json, other_fields) {
  Json json = Json::parse(profile_to_json(small_profile()));
  each_place(json, "", [&](Json& place, const std::string& path) {
    if (!place.is_object() || path == "sources") return;
    const Json before = place;
    place["unheard"] = 1;
    EXPECT_NE(refusal(json.dump()).find("unheard"), std::string::npos) << path;
    place = before;
    if (path == "textures" || path == "reached.footprint.cell") return;
    // Fewer counts do not add up; of those that are met by some lookups only nobody knows.
    if (path == "reached.sampler.wrap" || path == "reached.group.exponent" || path == "reached.address.coarse_level")
      return;
    for (const auto& [key, value] : before.items()) {
      place.erase(key);
      EXPECT_NE(refusal(json.dump()), "") << path << " " << key;
      place = before;
    }
  });
}

TEST(profile_json, values_out_of_range) {
  const Json whole = Json::parse(profile_to_json(small_profile()));
  const std::string texture = "/textures/" + whole["textures"].items().begin().key();
  const auto refused = [&](const std::string& path, const Json& value, const std::string& says) {
    Json json = whole;
    json[Json::json_pointer(path)] = value;
    const std::string message = refusal(json.dump());
    EXPECT_NE(message.find(says), std::string::npos) << path << ": no \"" << says << "\" in " << message;
  };
  refused("/version", 2, "version: got 2, legal is a whole number, 1 to 1");
  refused("/configuration/mantissa_bits", 9, "configuration.mantissa_bits: got 9");
  refused("/lookups", 50, "reached.sampler.mode: got 49 in all, legal is 50, as many as lookups");
  refused("/probes", 0, "as many as probes");
  refused("/sources/other", 0, "sources.other: got 0");
  refused("/reached/group/dudx/128", 1, "reached.group.dudx: got 128, legal is values of -128 to 127");
  refused("/reached/group/dudx/+1", 1, "reached.group.dudx: got +1");
  refused("/reached/group/dudx/01", 1, "reached.group.dudx: got 01");
  refused("/reached/footprint/cell/256", 1, "legal is values of 0 to 255");
  refused("/reached/plan/probes/0", 1, "legal is values of 1 to 16");
  refused("/reached/sampler/mode/fancy", 1, "got fancy, legal is nearest, bilinear");
  refused("/reached/sampler/mode/table", 0, "legal is a whole number, 1 to 9007199254740992");
  refused("/reached/sampler/mode/table", 18446744073709551615U, "9007199254740992");
  refused(texture + "/width", 0, "width: got 0, legal is a whole number, 1 to 16384");
  refused(texture + "/width", 16385, "width: got 16385");
  refused(texture + "/levels", 20, "levels: got 20");
  refused(texture + "/format", "rgb", "format: got rgb, legal is one of r8, rg8, rgba8");
  refused(texture + "/names", Json::array(), "names: got []");
  refused(texture + "/names", {"b", "a"}, "names in order");
  refused(texture + "/lines", "", "lines: got an empty number");
  refused(texture + "/lines", "3", "lines: got 3 lines");
  refused(texture + "/lines", "3 0 4", "lines: got 0");
  refused(texture + "/lines", "1 -1", "lines: got -1");
  refused(texture + "/lines", "99999", "lines: got 99999");
  refused(texture + "/lines", "1  2", "lines: got an empty number");
  refused(texture + "/blocks", "1 2", "blocks: got 2 counts");
  Json json = whole;
  json["textures"]["abc"] = json["textures"].items().begin().value();
  EXPECT_NE(refusal(json.dump()).find("abc, legal is 40 hexadecimal digits"), std::string::npos);
  json["textures"].erase("abc");
  json["textures"][std::string(40, 'a')] = json["textures"].items().begin().value();
  EXPECT_NE(refusal(json.dump()).find("hexadecimal digits, in capitals"), std::string::npos);
}

TEST(profile_json, nothing_twice) {
  std::string text = profile_to_json(small_profile());
  const std::size_t at = text.find("\"lookups\"");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(refusal(text.insert(at, "\"lookups\": 1, ")), "p.json: lookups: got two values, legal is one");
}

TEST(profile_json, files) {
  const TempDir dir;
  const Profile profile = small_profile();
  write_bytes(dir / "p.json", profile_to_json(profile));
  EXPECT_EQ(read_profile(dir / "p.json"), profile);
  EXPECT_NE(input_error([&] { read_profile(dir / "none.json"); }).find("none.json: open"), std::string::npos);
  EXPECT_NE(input_error([&] { read_profile(dir / ""); }).find("open"), std::string::npos);
  write_bytes(dir / "empty.json", "");
  EXPECT_NE(input_error([&] { read_profile(dir / "empty.json"); }).find("empty.json: JSON"), std::string::npos);
}

}  // namespace
}  // namespace feline
