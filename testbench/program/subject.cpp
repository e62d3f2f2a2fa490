// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/subject.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "testbench/error.h"
#include "testbench/program/command_line.h"
#include "testbench/scenes/scene.h"
#include "testbench/text_number.h"

namespace feline {
namespace {

constexpr std::array<std::string_view, 2> kMipFilterNames{"lanczos", "box"};

int parse_side(const std::string& option, const std::string& text, std::string_view digits) {
  const auto value = number_of<int>(digits);
  if (!value || *value < 1 || *value > kMaxImageSize) {
    bad_input("command line", option, text, fmt::format("WIDTHxHEIGHT or one number, each 1 to {}", kMaxImageSize));
  }
  return *value;
}

const Scene& scene_of(const std::string& name) {
  return find_scene(name.empty() ? scenes().front().name : std::string_view(name));
}

template <typename Make>
SamplerState<kDefaultConfig> without_sampler_error(Make make) {
  try {
    return make();
  } catch (const SamplerError& error) {
    bad_input("sampler", error.field, error.value, error.legal);
  }
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
  const std::vector<std::string> values = lists ? split_list(option, text) : std::vector<std::string>{text};
  for (const std::string& value : values) choices.push_back(static_cast<Choice>(parse_name(option, value, names)));
  return choices;
}

}  // namespace

Size parse_size(const std::string& option, const std::string& text) {
  const std::size_t cross = text.find('x');
  const std::string_view all = text;
  const int width = parse_side(option, text, all.substr(0, cross));
  return {width, cross == std::string::npos ? width : parse_side(option, text, all.substr(cross + 1))};
}

std::string scene_names() {
  std::vector<std::string_view> names;
  for (const Scene& each : scenes()) names.push_back(each.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

void SubjectOptions::add_to(CLI::App& command, bool with_scene) {
  if (with_scene) view_.push_back(command.add_option("--scene", scene, scene_names()));
  view_.push_back(
      command.add_option("--gbuffer", gbuffer, "EXR with channels s, t, dsdx, dtdx, dsdy, dtdy, instead of a scene's"));
  size_ = command.add_option("--size", size, "picture size of a scene: N or WIDTHxHEIGHT")->capture_default_str();
  view_.push_back(
      command.add_flag("--allow-non-finite", allow_non_finite, "take a G-buffer with NaN or infinity in it"));
  const CLI::Option* const file = command.add_option("--texture", texture, "image or .tx file, instead of the scene's");
  filter_ = command.add_option("--mip-filter", mip_filter, "makes a texture's mip levels: lanczos (radius 3) or box")
                ->capture_default_str();
  texture_parts_ = {
      command.add_option("--texture-format", format, "r8, rg8 or rgba8, instead of what the file's channels say"),
      command.add_flag("--srgb", srgb, "the texture file's colours are sRGB encoded")};
  options_ = view_;
  options_.insert(options_.end(), {size_, file, filter_});
  options_.insert(options_.end(), texture_parts_.begin(), texture_parts_.end());
}

ImageOptions SubjectOptions::image_options(MipEdge edge) const {
  ImageOptions options;
  options.srgb = srgb;
  options.mip_filter = static_cast<MipFilter>(parse_name("--mip-filter", mip_filter, kMipFilterNames));
  options.mip_edge = edge;
  if (!format.empty()) {
    options.format = static_cast<TexelFormat>(parse_name("--texture-format", format, kTexelFormatNames));
  }
  return options;
}

Texture SubjectOptions::load_texture_only(MipEdge edge) const { return load_texture(texture, image_options(edge)); }

void SubjectOptions::check_texture_only() const {
  refuse_given(view_, "together with --derivatives");
  if (texture.empty()) {
    refuse_given(texture_parts_, "without --texture");
    refuse_given(std::array{filter_}, "without --texture");
  } else {
    refuse_given(std::array{size_}, "together with --texture, which has its own");
  }
}

void SubjectOptions::check_random() const { refuse_given(options_, "together with --random"); }

Subject SubjectOptions::load_view(const std::string& scene_name) const {
  if (texture.empty() && !gbuffer.empty() && scene_name.empty()) {
    bad_input("command line", "--texture", "nothing", "an image for the G-buffer, or --scene for a built-in texture");
  }
  if (!texture.empty() && !gbuffer.empty() && !scene_name.empty()) {
    bad_input("command line", "--scene", scene_name, "nothing together with both --gbuffer and --texture");
  }
  if (texture.empty()) refuse_given(texture_parts_, "without --texture");
  if (!gbuffer.empty()) refuse_given(std::array{size_}, "together with --gbuffer, which has its own");
  Subject subject;
  const Scene& built_in = scene_of(scene_name);
  if (gbuffer.empty()) {
    const Size pixels = parse_size("--size", size);
    subject.gbuffer = make_gbuffer(built_in, pixels.width, pixels.height);
    subject.name = built_in.name;
  } else {
    GBufferOptions options;
    options.allow_non_finite = allow_non_finite;
    subject.gbuffer = read_gbuffer(gbuffer, options);
    subject.name = std::filesystem::path(gbuffer).stem().string();
    if (texture.empty()) subject.name += "+" + scene_name;
  }
  return subject;
}

void SubjectOptions::load_whole_texture(Subject& subject, const std::string& scene_name, MipEdge edge) const {
  if (texture.empty()) {
    const auto filter = static_cast<MipFilter>(parse_name("--mip-filter", mip_filter, kMipFilterNames));
    subject.texture = scene_of(scene_name).texture(filter, edge);
  } else {
    subject.texture = load_texture_only(edge);
  }
  subject.memory = layout_texture(subject.texture);
}

Subject SubjectOptions::load(const std::string& scene_name, MipEdge edge) const {
  Subject subject = load_view(scene_name);
  load_whole_texture(subject, scene_name, edge);
  return subject;
}

Subject SubjectOptions::load_lazily(MipEdge edge) const {
  Subject subject = load_view(scene);
  if (!texture.empty()) subject.lazy = LazyTexture::open(texture, image_options(edge));
  if (!subject.lazy) load_whole_texture(subject, scene, edge);
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
  using F = Formats<kDefaultConfig>;
  constexpr double kFactorStep = F::kFactor.value(1);
  of_unit_ = {
      command.add_option("--magnify", magnify, "nearest or linear; nearest is the default of mode nearest only"),
      command.add_option("--parameters", parameters, "exact, high_quality or high_efficiency (Feline 3.4)")
          ->capture_default_str(),
      command.add_option("--rounding", rounding,
                         "of the probe count: nearest (Feline 3.1) or ceiling (3.4), instead of the parameters' own"),
      command.add_option("--length-factor", length_factor, "shortens the ellipse")
          ->check(number(F::kFactor.value(F::kLeastLengthFactor), 1)),
      command.add_option("--blur-factor", blur_factor, "widens it at most so much: rounding is then ceiling")
          ->check(number(1, 2 - kFactorStep)),
      command.add_option("--alias-factor", alias_factor, "spreads probes at most so much: rounding is then ceiling")
          ->check(number(1, 2)),
      command.add_option("--max-probes", max_probes, "the most that a lookup takes")
          ->check(whole_number(1, kDefaultConfig.max_probes))
          ->capture_default_str(),
      command.add_option("--bias", bias, "of the level of detail")
          ->check(number(-16, kMaxLevel))
          ->capture_default_str(),
      command.add_option("--min-level", min_level, "the finest level")
          ->check(number(0, kMaxLevel))
          ->capture_default_str(),
      command.add_option("--max-level", max_level, "the coarsest level")->check(number(0, kMaxLevel))};
  others_ = {command.add_option("--wrap-t", wrap_t, "another wrap mode along t"),
             command.add_option("--border", border, "border colour R,G,B,A, linear")
                 ->delimiter(',')
                 ->expected(4)
                 ->check(number(0, 1))};
  others_.insert(others_.end(), of_unit_.begin(), of_unit_.end());
}

std::vector<SamplerOptions> SamplerChoice::combinations() const {
  constexpr std::array<std::string_view, 3> kSetNames{"exact", "high_quality", "high_efficiency"};
  constexpr std::array<ProbeParameters, 3> kSets{kExact, kHighQuality, kHighEfficiency};
  SamplerOptions options;
  options.probes = kSets[parse_name("--parameters", parameters, kSetNames)];
  options.probes.length_factor = length_factor.value_or(options.probes.length_factor);
  options.probes.blur_factor = blur_factor.value_or(options.probes.blur_factor);
  options.probes.alias_factor = alias_factor.value_or(options.probes.alias_factor);
  // Only the ceiling of 3.4 knows limits of blur and aliasing.
  const bool factored = options.probes.blur_factor != 1 || options.probes.alias_factor != 1;
  if (factored) options.probes.rounding = ProbeRounding::kCeiling;
  if (!rounding.empty()) {
    options.probes.rounding = static_cast<ProbeRounding>(parse_name("--rounding", rounding, kProbeRoundingNames));
  }
  if (factored && options.probes.rounding == ProbeRounding::kNearest) {
    bad_input("command line", "--rounding", rounding, "ceiling, with a blur or alias factor other than 1");
  }
  options.max_level = max_level.value_or(options.max_level);
  if (min_level > options.max_level) {
    bad_input("command line", "--min-level", fmt::format("{}", min_level),
              fmt::format("at most --max-level, {}", options.max_level));
  }
  options.max_probes = max_probes;
  options.level_bias = bias;
  options.min_level = min_level;
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

void SamplerChoice::check_filter() const {
  refuse_given(std::array{mode_, kernel_}, "together with --filter");
  refuse_given(of_unit_, "together with --filter");
}

SamplerChoices SamplerChoice::random_choices() const {
  refuse_given(others_, "together with --random");
  SamplerChoices choices;
  if (mode_->count() != 0) choices.modes = parse_list<Mode>("--mode", modes, lists_, kModeNames);
  if (kernel_->count() != 0) choices.kernels = parse_list<Kernel>("--kernel", kernels, lists_, kKernelNames);
  if (wrap_->count() != 0) choices.wraps = parse_list<Wrap>("--wrap", wraps, lists_, kWrapNames);
  return choices;
}

std::string wrap_name(const SamplerOptions& choice) {
  const auto name = [](Wrap wrap) { return std::string(kWrapNames[static_cast<std::size_t>(wrap)]); };
  return choice.wrap_s == choice.wrap_t ? name(choice.wrap_s) : name(choice.wrap_s) + "-" + name(choice.wrap_t);
}

SamplerState<kDefaultConfig> prepare_sampler(const SamplerOptions& options, const Texture& texture,
                                             const TextureMemory& memory) {
  return without_sampler_error([&] { return make_sampler<kDefaultConfig>(options, texture, memory); });
}

SamplerState<kDefaultConfig> prepare_sampler(const SamplerOptions& options, const Subject& subject) {
  if (!subject.lazy) return prepare_sampler(options, subject.texture, subject.memory);
  return without_sampler_error([&] { return make_sampler<kDefaultConfig>(options, subject.lazy->shape()); });
}

}  // namespace feline
