// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "tables/config.h"
#include "tables/sampler_enums.h"

namespace feline {

// What a machine makes of a request for something that may be left out (tables/config.h). Each gives the choice itself
// where the machine has it.

constexpr bool has_mode(const Features& features, Mode mode) {
  switch (mode) {
    case Mode::kNearest: return features.nearest;
    case Mode::kBilinear: return features.bilinear;
    case Mode::kTrilinear: return features.trilinear;
    case Mode::kExt: return features.ext;
    case Mode::kSimple: return features.simple_feline;
    case Mode::kTable: return features.table_feline;
  }
  return false;
}

constexpr bool has_wrap(const Features& features, Wrap wrap) {
  switch (wrap) {
    case Wrap::kRepeat: return features.repeat;
    case Wrap::kMirroredRepeat: return features.mirrored_repeat;
    case Wrap::kClampToEdge: return features.clamp_to_edge;
    case Wrap::kClampToBorder: return features.clamp_to_border;
  }
  return false;
}

constexpr bool has_format(const Features& features, TexelFormat format) {
  switch (format) {
    case TexelFormat::kR8: return features.r8;
    case TexelFormat::kRg8: return features.rg8;
    case TexelFormat::kRgba8: return features.rgba8;
  }
  return false;
}

constexpr Mode supported_mode(const Features& features, Mode mode) {
  if (has_mode(features, mode)) return mode;
  for (const Mode other : {Mode::kTrilinear, Mode::kBilinear, Mode::kNearest, Mode::kExt, Mode::kSimple}) {
    if (has_mode(features, other)) return other;
  }
  return Mode::kTable;
}

constexpr Wrap supported_wrap(const Features& features, Wrap wrap) {
  if (has_wrap(features, wrap)) return wrap;
  if (wrap == Wrap::kClampToBorder && features.clamp_to_edge) return Wrap::kClampToEdge;
  for (const Wrap other : {Wrap::kRepeat, Wrap::kClampToEdge, Wrap::kMirroredRepeat}) {
    if (has_wrap(features, other)) return other;
  }
  return Wrap::kClampToBorder;
}

constexpr TexelFormat supported_format(const Features& features, TexelFormat format) {
  if (has_format(features, format)) return format;
  for (const TexelFormat other : {TexelFormat::kRgba8, TexelFormat::kRg8}) {
    if (has_format(features, other)) return other;
  }
  return TexelFormat::kR8;
}

// Channels that textures can bring; the others are 0, alpha 255.
constexpr int channel_count(const Features& features) { return features.rgba8 ? 4 : features.rg8 ? 2 : 1; }

// Of red, green, blue, alpha: whether it can be anything but 0, alpha anything but 255.
constexpr bool has_channel(const Features& features, int channel) {
  return channel < channel_count(features) && (channel < 3 || features.alpha);
}

}  // namespace feline
