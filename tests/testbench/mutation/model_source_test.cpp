// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/model_source.h"

#include <gtest/gtest.h>

namespace feline::mutation {
namespace {

std::string instrumented(std::string_view text) {
  std::vector<ModelSite> sites;
  std::string out = instrument_source(text, "model/x.h", sites);
  const std::string space = "::feline::mutation::";
  for (std::size_t at = out.find(space); at != std::string::npos; at = out.find(space)) out.erase(at, space.size());
  return out;
}

TEST(mutation_model_source, operators_of_two_operands) {
  EXPECT_EQ(instrumented("f(a + b * c, a << b, a >> b);"),
            "f(a + Plus<0>{} + b * Times<1>{} * c, a << ShiftLeft<2>{} << b, a >> ShiftRight<3>{} >> b);");
  EXPECT_EQ(instrumented("f(a < b, a >= b, a == b, a & b, a && b);"),
            "f(a < Less<0>{} < b, a >= GreaterEqual<1>{} >= b, a == Equal<2>{} == b, a & And<3>{} & b, "
            "a && AndAlso<4>{} && b);");
}

TEST(mutation_model_source, numbers_values_and_conditions) {
  EXPECT_EQ(instrumented("int x = 0x7f;"), "int x = literal<0>(0x7f);");
  EXPECT_EQ(instrumented("float x = 0, y = 1, z = a;"),
            "float x = literal<0>(0), y = literal<1>(1), z = Value<2>{} ^= a;");
  EXPECT_EQ(instrumented("int x = 2 + a;"), "int x = Value<0>{} ^= literal<1>(2) + Plus<2>{} + a;");
  EXPECT_EQ(instrumented("if (a || b) return -a;"),
            "if (a || OrElse<1>{} || b || Condition<0>{}) return Value<2>{} ^= Negative<3>{}->*a;");
  EXPECT_EQ(instrumented("x += a ? true : !b;"),
            "x += Value<0>{} ^= a || Condition<1>{} ? literal<2>(true) : Not<3>{}->*b;");
}

// What is known to the compiler, what is no operator, and what would not be the same thing any more.
TEST(mutation_model_source, leaves_the_rest) {
  for (const char* const text :
       {"constexpr int kX = 1 + 2;", "constexpr auto kX = std::int64_t{1} << (2 + 3);", "std::array<int, 4> x;",
        "constexpr X kX{1, {2, a + 3}};", "inline constexpr std::array kX{X{1}, X{2}};", "f<1, A<2, 3>>(a);",
        "template <int kN = 3>\nint f(int a);", "std::vector<std::vector<int>> f(T&& a);", "static_assert(1 + 1 == 2);",
        "enum class X { kA = 1, kB = 2 };", "// a + b\n", "f(\"a + b\", x2, 1.5);", "case 3: return;", "auto& a = b;",
        "return {a, b};", "X& operator=(const X&) = default;", "*a;", "#if 1 + 1\n",
        "bool operator==(const X&) const = default;"}) {
    EXPECT_EQ(instrumented(text), text);
  }
  EXPECT_EQ(instrumented("constexpr int f(int a = 1) { return 1 + a; }"),
            "constexpr int f(int a = 1) { return Value<0>{} ^= literal<1>(1) + Plus<2>{} + a; }");
  EXPECT_EQ(instrumented("constexpr X f() { return f<1>(2); }"),
            "constexpr X f() { return Value<0>{} ^= f<1>(literal<1>(2)); }");
  EXPECT_EQ(instrumented("if constexpr (k < 3) f(1);"), "if constexpr (k < 3) f(literal<0>(1));");
  EXPECT_EQ(instrumented("if (const auto x = f()) g();"), "if (const auto x = Value<0>{} ^= f()) g();");
}

TEST(mutation_model_source, sites_say_where_they_are) {
  std::vector<ModelSite> sites(1);
  instrument_source("int f(int a) {\n  return a % b;\n}\n", "model/x.h", sites);
  ASSERT_EQ(sites.size(), 3U);
  EXPECT_EQ(sites[2].number, 2U);
  EXPECT_EQ(sites[2].file, "model/x.h");
  EXPECT_EQ(sites[2].line, 2U);
  EXPECT_EQ(sites[2].column, 12U);
  EXPECT_EQ(sites[2].token, "%");
  EXPECT_EQ(sites[2].alternative(0), "a / b");
  EXPECT_EQ(sites[1].alternative(1), "0");
  instrument_source("f(-a);", "model/x.h", sites);
  EXPECT_EQ(sites[3].alternative(0), "a");
}

}  // namespace
}  // namespace feline::mutation
