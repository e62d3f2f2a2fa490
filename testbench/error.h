// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <string_view>

namespace feline {

// Bad use or bad input. The program prints what() and exits with code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// RTL, model or exact arithmetic differ where something else was asked for. The program prints what() and exits with
// code 1.
class WitnessMismatch : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws InputError "<where>: <field>: got <value>, legal is <legal>".
//   where  the file, or the option on the command line
//   field  what in it is wrong
//   value  what was found
//   legal  what would be accepted
// bad_input("a.png", "width", "20000", "1 to 16384") reads
//   a.png: width: got 20000, legal is 1 to 16384
[[noreturn]] inline void bad_input(std::string_view where, std::string_view field, std::string_view value,
                                   std::string_view legal) {
  throw InputError(fmt::format("{}: {}: got {}, legal is {}", where, field, value, legal));
}

}  // namespace feline
