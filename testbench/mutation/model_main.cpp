// SPDX-License-Identifier: Apache-2.0
// feline_mutated_model: tries every mutant of the model. Built by testbench/mutation/build.sh from the sources that
// `feline mutate --model` made. Given are the first site and one beyond the last. Each mutant is tried in a process of
// its own, as it may crash or not end; of each a line of JSON on standard output, in any order. One that the model
// without it never gets to is not tried: its line says so.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "testbench/error.h"
#include "testbench/mutation/model_site.h"
#include "testbench/prove/leaf.h"
#include "testbench/random.h"

namespace {

using namespace feline;

enum Tier : int { kSmoke, kUnit, kTests, kLeaves, kSurvived };
constexpr std::array kTierNames{"smoke", "unit", "tests", "leaves"};
// Whole lookups against exact arithmetic and what else soon finds what no leaf sees; all but the million draws of each
// invariant, which take longest and find no more.
constexpr std::string_view kUnitTests = "unit.*:sampler.*:shortcuts.*:memory.*:rounding.*:lookup.*";
// Of the others those that find most come first.
constexpr std::string_view kEarlyTests = "pruned.*:fetch.*:accumulate.*";
constexpr std::string_view kLongTests = "*_long.*:invariants.*";
constexpr rlim_t kMostMemory = rlim_t{4} << 30;  // bytes
// Seconds of a processor: a mutant may take so many times what the model takes without one, and some more.
constexpr rlim_t kTimes = 20;
constexpr rlim_t kMore = 10;
constexpr rlim_t kNoLimit = 3600;
// Exit codes of a trial.
constexpr int kFound = 1;
constexpr int kNotTried = 3;

// What a process that tries a mutant leaves behind.
struct Trace {
  int tier = kSmoke;  // the one that it is in
  char name[64]{};    // of the leaf
};

// Inputs of a leaf and what exact arithmetic makes of them.
struct Judged {
  const prove::Leaf* leaf;
  std::vector<std::uint64_t> inputs, outputs;
  std::size_t count = 0;
};

std::vector<Judged> judge_leaves(std::uint64_t count, std::uint64_t seed) {
  std::vector<Judged> all;
  SplitMix64 random(seed);
  for (const prove::Leaf& leaf : prove::all_leaves()) {
    Judged judged{&leaf, {}, {}, static_cast<std::size_t>(std::min(count, leaf.domain.count))};
    judged.inputs.resize(judged.count * leaf.input_words);
    judged.outputs.resize(judged.count * leaf.output_words);
    for (std::size_t i = 0; i < judged.count; ++i) {
      // The whole of a small domain; of others its ends, and any.
      const bool whole = judged.count == leaf.domain.count;
      const std::uint64_t last = leaf.domain.count - 1;
      const std::uint64_t input = whole || i < judged.count / 8 ? i
                                  : i < judged.count / 4        ? last - (i - judged.count / 8)
                                                                : random.next() % leaf.domain.count;
      leaf.domain.fill(input, 1, judged.inputs.data() + i * leaf.input_words);
    }
    leaf.exact(judged.inputs.data(), judged.outputs.data(), judged.count);
    all.push_back(std::move(judged));
  }
  return all;
}

bool holds(const std::vector<Judged>& all, Trace& trace) {
  for (const Judged& judged : all) {
    std::snprintf(trace.name, sizeof trace.name, "%s", judged.leaf->name.c_str());
    std::vector<std::uint64_t> got(judged.outputs.size());
    judged.leaf->model(judged.inputs.data(), got.data(), judged.count);
    if (got != judged.outputs) return false;
  }
  return true;
}

struct Trials {
  std::vector<Judged> smoke = judge_leaves(1U << 11, 1);
  std::vector<Judged> leaves = judge_leaves(1U << 17, 2);
};

bool passes(const std::string& filter, Trace& trace) {
  std::strcpy(trace.name, "");
  testing::GTEST_FLAG(filter) = filter;
  return RUN_ALL_TESTS() == 0;
}

// In the child: 0 for a survivor.
int try_mutant(const Trials& trials, Trace& trace) {
  trace.tier = kSmoke;
  if (!holds(trials.smoke, trace)) return kFound;
  trace.tier = kUnit;
  if (!passes(std::string(kUnitTests), trace)) return kFound;
  trace.tier = kTests;
  if (!passes(std::string(kEarlyTests), trace)) return kFound;
  if (!passes(fmt::format("-{}:{}:{}", kUnitTests, kEarlyTests, kLongTests), trace)) return kFound;
  trace.tier = kLeaves;
  if (!holds(trials.leaves, trace)) return kFound;
  trace.tier = kSurvived;
  return 0;
}

template <typename T>
T* shared(std::size_t count) {
  void* const memory = mmap(nullptr, count * sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error("no memory to share with other processes");
  return static_cast<T*>(memory);
}

pid_t start(const Trials& trials, std::uint32_t mutant, rlim_t patience, Trace& trace) {
  trace = {};
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process more");
  if (child > 0) return child;
  mutation::current_model_mutant = mutant;
  const rlimit time{patience, patience + 5};
  const rlimit memory{kMostMemory, kMostMemory};
  if (setrlimit(RLIMIT_CPU, &time) != 0 || setrlimit(RLIMIT_AS, &memory) != 0 ||
      std::freopen("/dev/null", "w", stdout) == nullptr || std::freopen("/dev/null", "w", stderr) == nullptr) {
    _exit(kNotTried);
  }
  int code = kFound;
  try {
    code = try_mutant(trials, trace);
  } catch (...) {
    code = kFound;
  }
  _exit(code);
}

// How a trial ended that found a mutant. Throws std::runtime_error for an end that says nothing of it.
std::string_view way(int status) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == kFound) return "mismatch";
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU) return "no end";
  for (const int crash : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL}) {
    if (signal == crash) return "crash";
  }
  throw std::runtime_error(signal != 0 ? fmt::format("a trial was ended by signal {}", signal)
                                       : fmt::format("a trial ended with exit code {}", WEXITSTATUS(status)));
}

// Seconds of a processor that the children took so far.
rlim_t seconds_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<rlim_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec);
}

class Campaign {
 public:
  Campaign(const Trials& trials, rlim_t patience)
      : trials_(trials), patience_(patience), traces_(shared<Trace>(workers())) {
    for (std::size_t i = 0; i < workers(); ++i) free_.push_back(i);
  }

  void run(const std::vector<std::uint32_t>& mutants) {
    for (const std::uint32_t mutant : mutants) {
      if (free_.empty()) finish_one();
      const std::size_t place = free_.back();
      free_.pop_back();
      running_[start(trials_, mutant, patience_, traces_[place])] = {mutant, place, std::chrono::steady_clock::now()};
    }
    while (!running_.empty()) finish_one();
  }

 private:
  struct Running {
    std::uint32_t mutant = 0;
    std::size_t place = 0;
    std::chrono::steady_clock::time_point start;
  };

  static std::size_t workers() { return std::max(1U, std::thread::hardware_concurrency()); }

  void finish_one() {
    int status = 0;
    const pid_t child = wait(&status);
    const Running done = running_.at(child);
    running_.erase(child);
    free_.push_back(done.place);
    const Trace& trace = traces_[done.place];
    nlohmann::ordered_json line{{"code", done.mutant}};
    if (status != 0) {
      line["tier"] = kTierNames[static_cast<std::size_t>(trace.tier)];
      line["way"] = way(status);
      line["leaf"] = trace.name;
      const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - done.start;
      line["milliseconds"] = time.count();
    }
    fmt::print("{}\n", line.dump());
    std::fflush(stdout);
  }

  const Trials& trials_;
  rlim_t patience_;
  Trace* traces_;
  std::vector<std::size_t> free_;
  std::map<pid_t, Running> running_;
};

// Mutants of the sites first .. end - 1.
int run(std::uint32_t first, std::uint32_t end) {
  const Trials trials;
  mutation::reached_alternatives = shared<std::uint8_t>(mutation::kMostModelSites);
  Trace& trace = *shared<Trace>(1);
  int status = 0;
  waitpid(start(trials, mutation::kNoModelMutant, kNoLimit, trace), &status, 0);
  if (status != 0) {
    throw WitnessMismatch(fmt::format("the model without a mutant fails: {} {}, {}",
                                      kTierNames[static_cast<std::size_t>(trace.tier)], trace.name, way(status)));
  }
  std::vector<std::uint32_t> mutants;
  for (std::uint32_t code = first * mutation::kAlternatives; code < end * mutation::kAlternatives; ++code) {
    const unsigned asked = mutation::reached_alternatives[code / mutation::kAlternatives];
    if ((asked >> code % mutation::kAlternatives & 1U) != 0) {
      mutants.push_back(code);
    } else if (asked == 0 && code % mutation::kAlternatives == 0) {
      fmt::print("{}\n", nlohmann::ordered_json{{"code", code}, {"reached", false}}.dump());
    }
  }
  mutation::reached_alternatives = nullptr;
  Campaign(trials, kTimes * seconds_of_children() + kMore).run(mutants);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  testing::GTEST_FLAG(fail_fast) = true;
  try {
    if (argc != 3) throw std::runtime_error("usage: feline_mutated_model FIRST_SITE END_SITE");
    return run(static_cast<std::uint32_t>(std::stoul(argv[1])), static_cast<std::uint32_t>(std::stoul(argv[2])));
  } catch (const WitnessMismatch& error) {
    std::fputs((std::string(error.what()) + "\n").c_str(), stderr);
    return 1;
  } catch (const std::exception& error) {
    std::fputs((std::string(error.what()) + "\n").c_str(), stderr);
    return 2;
  }
}
