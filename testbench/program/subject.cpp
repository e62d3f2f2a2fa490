// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/subject.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "testbench/error.h"
#include "testbench/scenes/scene.h"

namespace feline {
namespace {

constexpr std::array<std::string_view, 2> kMipFilterNames{"lanczos", "box"};

int parse_side(const std::string& option, const std::string& text, std::string_view digits) {
  int value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size() || value < 1 || value > kMaxImageSize) {
    bad_input(option, "size", text, fmt::format("WIDTHxHEIGHT or one number, each 1 to {}", kMaxImageSize));
  }
  return value;
}

// Choices of an enumeration: a list, or all of it.
template <typename Choice>
std::vector<Choice> parse_list(const std::string& option, const std::string& text, bool lists,
                               std::span<const std::string_view> names) {
  std::vector<Choice> choices;
  if (lists && text == "all") {
    for (std::size_t i = 0; i < names.size(); ++i) choices.push_back(static_cast<Choice>(i));
    return choices;
  }
  const std::vector<std::string> values = lists ? split_list(text) : std::vector<std::string>{text};
  for (const std::string& value : values) choices.push_back(static_cast<Choice>(parse_name(option, value, names)));
  return choices;
}

// Random lookups bring their own textures and samplers: what else was chosen would be ignored.
void refuse_with_random(const std::vector<const CLI::Option*>& options) {
  for (const CLI::Option* option : options) {
    if (option->count() == 0) continue;
    bad_input("command line", option->get_name(), fmt::format("{}", fmt::join(option->results(), ",")),
              "nothing together with --random");
  }
}

}  // namespace

Size parse_size(const std::string& option, const std::string& text) {
  const std::size_t cross = text.find('x');
  const std::string_view all = text;
  const int width = parse_side(option, text, all.substr(0, cross));
  return {width, cross == std::string::npos ? width : parse_side(option, text, all.substr(cross + 1))};
}

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    parts.push_back(text.substr(at, comma - at));
    at = comma + 1;
  }
  return parts;
}

std::size_t parse_name(const std::string& option, const std::string& value, std::span<const std::string_view> names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == value) return i;
  }
  bad_input("command line", option, value, fmt::format("one of {}", fmt::join(names, ", ")));
}

void SubjectOptions::add_to(CLI::App& command) {
  size_ = command.add_option("--size", size, "picture size of a scene: N or WIDTHxHEIGHT")->capture_default_str();
  options_ = {
      size_,
      command.add_option("--gbuffer", gbuffer, "EXR with channels s, t, dsdx, dtdx, dsdy, dtdy, instead of a scene's"),
      command.add_option("--texture", texture, "image or .tx file, instead of the scene's texture"),
      command.add_option("--mip-filter", mip_filter, "makes a texture's mip levels: lanczos (radius 3) or box")
          ->capture_default_str(),
      command.add_option("--texture-format", format, "r8, rg8 or rgba8, instead of what the file's channels say"),
      command.add_flag("--srgb", srgb, "the texture file's colours are sRGB encoded"),
      command.add_flag("--allow-non-finite", allow_non_finite, "take a G-buffer with NaN or infinity in it")};
}

Subject SubjectOptions::load(const std::string& scene_name) const {
  if (texture.empty() && !gbuffer.empty() && scene_name.empty()) {
    bad_input("command line", "--texture", "nothing", "an image for the G-buffer, or --scene for a built-in texture");
  }
  if (texture.empty() && srgb) bad_input("command line", "--srgb", "given", "nothing without --texture");
  if (texture.empty() && !format.empty()) {
    bad_input("command line", "--texture-format", format, "nothing without --texture");
  }
  if (!gbuffer.empty() && size_->count() != 0) {
    bad_input("command line", "--size", size, "nothing together with --gbuffer, which has its own");
  }
  Subject subject;
  const Scene& built_in = find_scene(scene_name.empty() ? scenes().front().name : std::string_view(scene_name));
  const auto filter = static_cast<MipFilter>(parse_name("--mip-filter", mip_filter, kMipFilterNames));
  if (gbuffer.empty()) {
    const Size pixels = parse_size("--size", size);
    subject.gbuffer = make_gbuffer(built_in, pixels.width, pixels.height);
    subject.name = built_in.name;
  } else {
    GBufferOptions options;
    options.allow_non_finite = allow_non_finite;
    subject.gbuffer = read_gbuffer(gbuffer, options);
    subject.name = gbuffer;
  }
  if (texture.empty()) {
    subject.texture = built_in.texture(filter);
  } else {
    ImageOptions options;
    options.srgb = srgb;
    options.mip_filter = filter;
    options.mip_edge = periodic ? MipEdge::kRepeat : MipEdge::kClamp;
    if (!format.empty()) {
      options.format = static_cast<TexelFormat>(parse_name("--texture-format", format, kTexelFormatNames));
    }
    subject.texture = load_texture(texture, options);
  }
  subject.memory = layout_texture(subject.texture);
  return subject;
}

void SamplerChoice::add_to(CLI::App& command, bool lists) {
  lists_ = lists;
  const auto add = [&](const char* name, std::string& values, std::span<const std::string_view> names) {
    const std::string help = fmt::format("{}{}", fmt::join(names, ", "), lists ? "; a list a,b, or all" : "");
    return command.add_option(name, values, help)->capture_default_str();
  };
  mode_ = add("--mode", modes, kModeNames);
  kernel_ = add("--kernel", kernels, kKernelNames);
  wrap_ = add("--wrap", wraps, kWrapNames);
  const std::string probes = fmt::format("1 to {}", kDefaultConfig.max_probes);
  others_ = {command.add_option("--wrap-t", wrap_t, "another wrap mode along t"),
             command.add_option("--magnify", magnify, "nearest or linear; nearest is the default of mode nearest only"),
             command.add_option("--parameters", parameters, "exact, high_quality or high_efficiency (Feline 3.4)")
                 ->capture_default_str(),
             command.add_option("--length-factor", length_factor, "shortens the ellipse: above 0, to 1"),
             command.add_option("--blur-factor", blur_factor, "widens it at most so much: 1 to 1.996"),
             command.add_option("--alias-factor", alias_factor, "spreads probes at most so much: 1 to 2"),
             command.add_option("--max-probes", max_probes, probes)->capture_default_str(),
             command.add_option("--bias", bias, "level of detail bias: -16 to 15.996")->capture_default_str(),
             command.add_option("--min-level", min_level, "0 to 15.996")->capture_default_str(),
             command.add_option("--max-level", max_level, "0 to 15.996"),
             command.add_option("--border", border, "border colour R,G,B,A, each 0 to 1, linear")
                 ->delimiter(',')
                 ->expected(4)};
}

std::vector<SamplerOptions> SamplerChoice::combinations() const {
  constexpr std::array<std::string_view, 3> kSetNames{"exact", "high_quality", "high_efficiency"};
  constexpr std::array<ProbeParameters, 3> kSets{kExact, kHighQuality, kHighEfficiency};
  SamplerOptions options;
  options.probes = kSets[parse_name("--parameters", parameters, kSetNames)];
  options.probes.length_factor = length_factor.value_or(options.probes.length_factor);
  options.probes.blur_factor = blur_factor.value_or(options.probes.blur_factor);
  options.probes.alias_factor = alias_factor.value_or(options.probes.alias_factor);
  // Factors other than one mean the limits of 3.4, which only its ceiling knows.
  if (blur_factor || alias_factor) options.probes.rounding = ProbeRounding::kCeiling;
  options.max_probes = max_probes;
  options.level_bias = bias;
  options.min_level = min_level;
  options.max_level = max_level.value_or(options.max_level);
  for (std::size_t c = 0; c < border.size(); ++c) options.border[c] = border[c];

  std::vector<SamplerOptions> all;
  for (const Mode mode : parse_list<Mode>("--mode", modes, lists_, kModeNames)) {
    for (const Kernel kernel : parse_list<Kernel>("--kernel", kernels, lists_, kKernelNames)) {
      for (const Wrap wrap : parse_list<Wrap>("--wrap", wraps, lists_, kWrapNames)) {
        options.mode = mode;
        options.kernel = kernel;
        options.wrap_s = wrap;
        options.wrap_t = wrap_t.empty() ? wrap : static_cast<Wrap>(parse_name("--wrap-t", wrap_t, kWrapNames));
        options.magnify = magnify.empty() ? (mode == Mode::kNearest ? Magnify::kNearest : Magnify::kLinear)
                                          : static_cast<Magnify>(parse_name("--magnify", magnify, kMagnifyNames));
        all.push_back(options);
      }
    }
  }
  return all;
}

RandomBatches::Choices SamplerChoice::random_choices() const {
  refuse_with_random(others_);
  RandomBatches::Choices choices;
  if (mode_->count() != 0) choices.modes = parse_list<Mode>("--mode", modes, lists_, kModeNames);
  if (kernel_->count() != 0) choices.kernels = parse_list<Kernel>("--kernel", kernels, lists_, kKernelNames);
  if (wrap_->count() != 0) choices.wraps = parse_list<Wrap>("--wrap", wraps, lists_, kWrapNames);
  return choices;
}

void SubjectOptions::check_random() const {
  if (!scene.empty()) bad_input("command line", "--scene", scene, "nothing together with --random");
  refuse_with_random(options_);
}

SamplerState<kDefaultConfig> prepare_sampler(const SamplerOptions& options, const Texture& texture,
                                             const TextureMemory& memory) {
  try {
    return make_sampler<kDefaultConfig>(options, texture, memory);
  } catch (const SamplerError& error) {
    bad_input("sampler", error.field, error.value, error.legal);
  }
}

}  // namespace feline
