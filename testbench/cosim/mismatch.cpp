// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "tables/emit.h"
#include "testbench/cosim/job.h"

namespace feline {
namespace {

std::string value_text(const FieldValue& value) {
  return fmt::format("{} = {}", hex_text(value), value.format.value(value.raw));
}

std::string format_text(const Format& format) { return fmt::format("{}, {}", notation(format), format.unit.view()); }

// Calls visit with a default beat of the stage's type.
template <typename Visit, std::size_t kStage = 0>
void with_beat(Stage stage, Visit visit) {
  if constexpr (kStage < kStageCount) {
    if (static_cast<std::size_t>(stage) == kStage) {
      visit(StageBeat<kUnit, kStage>{});
    } else {
      with_beat<Visit, kStage + 1>(stage, visit);
    }
  }
}

void describe_fields(std::string& out, const Mismatch& mismatch) {
  with_beat(mismatch.stage, [&]<typename Beat>(Beat) {
    const auto got = field_values(unpack<Beat>(mismatch.got));
    const auto expected = field_values(unpack<Beat>(mismatch.expected));
    for (std::size_t i = 0; i < got.size(); ++i) {
      if (got[i].raw == expected[i].raw) continue;
      out += fmt::format("  field {}: RTL {}, model {} ({})\n", got[i].name, value_text(got[i]),
                         value_text(expected[i]), format_text(got[i].format));
    }
  });
}

template <typename Beat>
void list_fields(std::string& out, const Beat& beat) {
  for (const FieldValue& value : field_values(beat)) {
    out += fmt::format("    {} {} ({})\n", value.name, value_text(value), format_text(value.format));
  }
}

// The model's beat that the wrong stage took.
void describe_inputs(std::string& out, const Mismatch& mismatch, const CosimJob& job) {
  const Batch batch = job.batch(mismatch.lookup / job.batch_lookups);
  const auto index = mismatch.lookup - batch.first_lookup;
  const Lookup& lookup = batch.lookups[index];
  out += fmt::format("  lookup s {:.9g}, t {:.9g}, ds/dx {:.9g}, dt/dx {:.9g}, ds/dy {:.9g}, dt/dy {:.9g}\n", lookup.s,
                     lookup.t, lookup.dsdx, lookup.dtdx, lookup.dsdy, lookup.dtdy);
  out += fmt::format("  inputs of {}:\n", stage_name(mismatch.stage));
  const auto wanted = static_cast<std::size_t>(mismatch.stage);
  // Each stage from address to accumulate takes one beat a probe; the others one a lookup.
  std::uint64_t probe = 0;
  sample<kUnit>(make_request<kUnit>(lookup, static_cast<std::int64_t>(mismatch.lookup)), batch.sampler, *batch.memory,
                [&]<typename Beat>(const Beat& beat) {
                  constexpr std::size_t kGiver = stage_of<kUnit, Beat>();
                  constexpr bool kIsRequest = kGiver == kStageCount;
                  if ((kIsRequest ? 0 : kGiver + 1) != wanted) return;
                  const bool per_probe = mismatch.stage > Stage::kWalk;
                  const bool every = mismatch.stage == Stage::kAccumulate;
                  if (!per_probe || every || probe == mismatch.probe) list_fields(out, beat);
                  ++probe;
                });
}

}  // namespace

std::string describe_mismatch(const Mismatch& mismatch, const CosimJob& job) {
  std::string place = fmt::format("lookup {}", mismatch.lookup);
  if (job.width > 0) {
    const auto width = static_cast<std::uint64_t>(job.width);
    place += fmt::format(" (pixel {}, {})", mismatch.lookup % width, mismatch.lookup / width);
  }
  std::string out = fmt::format("MISMATCH at stage {}, {}, probe {}, cycle {}; scene {}, mode {}, kernel {}, wrap {}\n",
                                stage_name(mismatch.stage), place, mismatch.probe, mismatch.cycle, job.scene, job.mode,
                                job.kernel, job.wrap);
  switch (mismatch.kind) {
    case Mismatch::Kind::kValue: describe_fields(out, mismatch); break;
    case Mismatch::Kind::kUnexpected: out += "  the RTL gives a beat that the model does not\n"; return out;
    case Mismatch::Kind::kMissing: out += "  the RTL does not give a beat that the model gives\n"; break;
    case Mismatch::Kind::kProtocol: out += fmt::format("  {}\n", mismatch.note); return out;
  }
  describe_inputs(out, mismatch, job);
  return out;
}

}  // namespace feline
