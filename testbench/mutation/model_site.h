// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

// What model_source.cpp puts into the model's sources at the places where one thing can be done instead of another. An
// expression with operators of the same precedence around it: `a + b` becomes `a + Plus<7>{} + b`. Of each site the
// alternatives are numbered from 0; what a constant expression computes is never another.
namespace feline::mutation {

inline constexpr std::uint32_t kAlternatives = 4;
inline constexpr std::uint32_t kMostModelSites = 1U << 16;
inline constexpr std::uint32_t kNoModelMutant = ~0U;

// Site * kAlternatives + alternative.
inline std::uint32_t current_model_mutant = kNoModelMutant;
// Of each site a bit for every alternative that was asked for; kHasNone when it was done and has none.
inline std::uint8_t* reached_alternatives = nullptr;
inline constexpr std::uint32_t kHasNone = kAlternatives;

constexpr void reach(std::uint32_t site, std::uint32_t alternative) {
  if (std::is_constant_evaluated() || reached_alternatives == nullptr) return;
  reached_alternatives[site] = static_cast<std::uint8_t>(reached_alternatives[site] | 1U << alternative);
}

constexpr bool instead(std::uint32_t site, std::uint32_t alternative) {
  if (std::is_constant_evaluated()) return false;
  reach(site, alternative);
  return current_model_mutant == site * kAlternatives + alternative;
}

template <typename T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;

template <typename T, typename Operator>
struct Left {
  T value;
};

// NOLINTBEGIN(bugprone-macro-parentheses): "macro argument should be enclosed in parentheses": names and operators.

// A binary operator: of numbers also what it gives in the two alternatives. By value: a reference would make a use of
// a constant one that a lambda has to capture.
#define FELINE_MUTATION_BINARY(Name, op, first, second)                                                               \
  template <std::uint32_t kSite>                                                                                      \
  struct Name {};                                                                                                     \
  template <typename T, std::uint32_t kSite>                                                                          \
  constexpr Left<T, Name<kSite>> operator op(T a, Name<kSite>) {                                                      \
    return {a};                                                                                                       \
  }                                                                                                                   \
  template <typename T, std::uint32_t kSite, typename U>                                                              \
  constexpr auto operator op(const Left<T, Name<kSite>>& left, U b)->std::remove_cvref_t<decltype(left.value op b)> { \
    const T& a = left.value;                                                                                          \
    if constexpr (Number<T> && Number<U>) {                                                                           \
      if (instead(kSite, 0)) return first;                                                                            \
      if (instead(kSite, 1)) return second;                                                                           \
    } else {                                                                                                          \
      reach(kSite, kHasNone);                                                                                         \
    }                                                                                                                 \
    return a op b;                                                                                                    \
  }

FELINE_MUTATION_BINARY(Plus, +, a - b, a)
FELINE_MUTATION_BINARY(Minus, -, a + b, a)
FELINE_MUTATION_BINARY(Times, *, a + b, a)
FELINE_MUTATION_BINARY(Divide, /, a* b, a)
FELINE_MUTATION_BINARY(Modulo, %, a / b, a)
FELINE_MUTATION_BINARY(ShiftLeft, <<, a >> b, a)
FELINE_MUTATION_BINARY(ShiftRight, >>, a << b, a)
FELINE_MUTATION_BINARY(And, &, a | b, a)
FELINE_MUTATION_BINARY(Or, |, a& b, a)
FELINE_MUTATION_BINARY(Xor, ^, a | b, a)
FELINE_MUTATION_BINARY(Less, <, a <= b, a >= b)
FELINE_MUTATION_BINARY(LessEqual, <=, a<b, a> b)
FELINE_MUTATION_BINARY(Greater, >, a >= b, a <= b)
FELINE_MUTATION_BINARY(GreaterEqual, >=, a > b, a < b)
FELINE_MUTATION_BINARY(Equal, ==, a != b, true)
FELINE_MUTATION_BINARY(NotEqual, !=, a == b, true)
#undef FELINE_MUTATION_BINARY

// `a && b` becomes `a && AndAlso<7>{} && b`, so that b is still looked at only then: the left side left out, or the
// opposite.
template <std::uint32_t kSite>
struct AndAlso {};
template <std::uint32_t kSite>
constexpr bool operator&&(bool a, AndAlso<kSite>) {
  return instead(kSite, 0) || (instead(kSite, 1) ? !a : a);
}
template <std::uint32_t kSite>
struct OrElse {};
template <std::uint32_t kSite>
constexpr bool operator||(bool a, OrElse<kSite>) {
  return !instead(kSite, 0) && (instead(kSite, 1) ? !a : a);
}

// A condition, `a ? ` as `a || Condition<7>{} ? `: the opposite, always, never.
template <std::uint32_t kSite>
struct Condition {};
template <std::uint32_t kSite>
constexpr bool operator||(bool a, Condition<kSite>) {
  if (instead(kSite, 0)) return !a;
  return instead(kSite, 1) || (!instead(kSite, 2) && a);
}

// `-a`, `!a` and `~a` as `Negative<7>{}->*a`: without.
#define FELINE_MUTATION_UNARY(Name, op)                                                \
  template <std::uint32_t kSite>                                                       \
  struct Name {};                                                                      \
  template <std::uint32_t kSite, typename T>                                           \
  constexpr auto operator->*(Name<kSite>, T a)->std::remove_cvref_t<decltype(op a)> {  \
    if (instead(kSite, 0)) return static_cast<std::remove_cvref_t<decltype(op a)>>(a); \
    return op a;                                                                       \
  }
FELINE_MUTATION_UNARY(Negative, -)
FELINE_MUTATION_UNARY(Not, !)
FELINE_MUTATION_UNARY(Complement, ~)
#undef FELINE_MUTATION_UNARY

// NOLINTEND(bugprone-macro-parentheses)

// A value that is kept or returned, `x = a` as `x = Value<7>{} ^= a`: one more, or 0; of a bool the opposite.
template <std::uint32_t kSite>
struct Value {};
template <std::uint32_t kSite, typename T>
constexpr decltype(auto) operator^=(Value<kSite>, T&& a) {
  using Plain = std::remove_cvref_t<T>;
  if constexpr (std::is_same_v<Plain, bool>) {
    return static_cast<Plain>(instead(kSite, 0) ? !a : a);
  } else if constexpr (std::is_integral_v<Plain>) {
    return static_cast<Plain>(instead(kSite, 0) ? static_cast<Plain>(a + 1) : instead(kSite, 1) ? Plain{0} : a);
  } else if constexpr (requires { Plain::from_raw(a.raw()); }) {
    return instead(kSite, 0) ? Plain::from_raw(a.raw() ^ 1) : instead(kSite, 1) ? Plain{} : Plain{a};
  } else {
    reach(kSite, kHasNone);
    return std::forward<T>(a);
  }
}

// A number that is written down: one more, one less; true and false.
template <std::uint32_t kSite, typename T>
constexpr T literal(T a) {
  if constexpr (std::is_same_v<T, bool>) {
    return instead(kSite, 0) ? !a : a;
  } else {
    return instead(kSite, 0) ? static_cast<T>(a + 1) : instead(kSite, 1) ? static_cast<T>(a - 1) : a;
  }
}

}  // namespace feline::mutation
