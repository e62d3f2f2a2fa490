// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/model_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

namespace feline::mutation {
namespace {

struct Token {
  std::size_t first = 0;
  std::string_view text;
};

// What model_site.h has: its name, the operator and how many operands that has, and what is done instead.
struct Pattern {
  std::string_view name, token;
  int operands;
  std::array<std::string_view, 3> alternatives;
};
constexpr auto kKinds = std::to_array<Pattern>({
    {"Plus", "+", 2, {"a - b", "a"}},
    {"Minus", "-", 2, {"a + b", "a"}},
    {"Times", "*", 2, {"a + b", "a"}},
    {"Divide", "/", 2, {"a * b", "a"}},
    {"Modulo", "%", 2, {"a / b", "a"}},
    {"ShiftLeft", "<<", 2, {"a >> b", "a"}},
    {"ShiftRight", ">>", 2, {"a << b", "a"}},
    {"And", "&", 2, {"a | b", "a"}},
    {"Or", "|", 2, {"a & b", "a"}},
    {"Xor", "^", 2, {"a | b", "a"}},
    {"Less", "<", 2, {"a <= b", "a >= b"}},
    {"LessEqual", "<=", 2, {"a < b", "a > b"}},
    {"Greater", ">", 2, {"a >= b", "a <= b"}},
    {"GreaterEqual", ">=", 2, {"a > b", "a < b"}},
    {"Equal", "==", 2, {"a != b", "true"}},
    {"NotEqual", "!=", 2, {"a == b", "true"}},
    {"AndAlso", "&&", 2, {"b", "!a && b"}},
    {"OrElse", "||", 2, {"b", "!a || b"}},
    {"Negative", "-", 1, {"a"}},
    {"Not", "!", 1, {"a"}},
    {"Complement", "~", 1, {"a"}},
    {"Condition", "", 0, {"the opposite", "always", "never"}},
    {"Value", "", 0, {"another value", "0"}},
    {"literal", "", 0, {"one more, or the opposite", "one less"}},
});

const Pattern* kind_of(std::string_view token, int operands) {
  const auto* const found = std::ranges::find_if(
      kKinds, [&](const Pattern& kind) { return kind.token == token && kind.operands == operands; });
  return found == kKinds.end() ? nullptr : found;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Words, numbers and operators; what is a comment, a string or a directive is none.
std::vector<Token> tokens_of(std::string_view text) {
  static constexpr std::array<std::string_view, 22> kLong{"<=>", "<<=", ">>=", "->*", "...", "::", "->", "<<",
                                                          "<=",  ">=",  "==",  "!=",  "&&",  "||", "++", "--",
                                                          "+=",  "-=",  "*=",  "/=",  "|=",  "&="};
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const auto to = [&](std::size_t end) { return end == std::string_view::npos ? text.size() : end; };
    if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++i;
    } else if (c == '#' || text.substr(i, 2) == "//") {
      i = to(text.find('\n', i));
    } else if (c == '"') {
      std::size_t end = i + 1;
      while (text[end] != '"') end += text[end] == '\\' ? 2 : 1;
      i = end + 1;
    } else if (is_word(c)) {
      std::size_t end = i;
      // With the marks between digits.
      while (end < text.size() && (is_word(text[end]) || (text[end] == '\'' && is_word(text[end + 1])))) ++end;
      tokens.push_back({i, text.substr(i, end - i)});
      i = end;
    } else {
      const auto* const found = std::ranges::find_if(kLong, [&](auto op) { return text.substr(i).starts_with(op); });
      const std::size_t length = found == kLong.end() ? 1 : found->size();
      tokens.push_back({i, text.substr(i, length)});
      i += length;
    }
  }
  return tokens;
}

class SourceInstrumenter {
 public:
  SourceInstrumenter(std::string_view text, const std::string& file, std::vector<ModelSite>& sites)
      : text_(text), file_(file), sites_(sites), tokens_(tokens_of(text)) {}

  std::string run() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) i = visit(i);
    std::ranges::stable_sort(edits_, {}, &Edit::first);
    std::string out;
    std::size_t done = 0;
    for (const Edit& edit : edits_) {
      out += text_.substr(done, edit.first - done);
      out += edit.text;
      done = edit.first + edit.length;
    }
    return out + std::string(text_.substr(done));
  }

 private:
  struct Edit {
    std::size_t first, length;
    std::string text;
  };

  std::string_view token(std::size_t i) const { return i < tokens_.size() ? tokens_[i].text : std::string_view(); }

  // The token at which `close` ends what token i opens.
  std::size_t matching(std::size_t i, std::string_view open, std::string_view close) const {
    for (int depth = 0; i < tokens_.size(); ++i) {
      if (token(i) == open) ++depth;
      if (token(i) == close && --depth == 0) break;
    }
    return i;
  }

  // The first ; or { outside all parentheses; of a constant, which has a = or no parameters, the ; behind its value.
  std::size_t end_of_declaration(std::size_t i) const {
    const bool is_constant = token(i) == "constexpr";
    bool has_value = false;
    bool has_parameters = false;
    for (int depth = 0; i < tokens_.size(); ++i) {
      const std::string_view word = token(i);
      has_value = has_value || (is_constant && depth == 0 && (word == "=" || (word == "{" && !has_parameters)));
      has_parameters = has_parameters || word == "(";
      if (word == "(" || word == "[" || (word == "{" && has_value)) ++depth;
      if (word == ")" || word == "]" || (word == "}" && has_value)) --depth;
      if (depth == 0 && (word == ";" || word == "{")) break;
    }
    return i;
  }

  // The name of a site of token i.
  std::string site(std::size_t i, std::string_view kind) {
    const auto number = static_cast<std::uint32_t>(sites_.size());
    const std::string_view before = text_.substr(0, tokens_[i].first);
    const auto line = static_cast<std::uint32_t>(std::ranges::count(before, '\n')) + 1;
    const std::size_t start = before.find_last_of('\n');
    const auto column =
        static_cast<std::uint32_t>(start == std::string_view::npos ? before.size() + 1 : before.size() - start);
    sites_.push_back({number, file_, line, column, std::string(token(i)), std::string(kind)});
    return fmt::format("::feline::mutation::{}<{}>", kind, number);
  }
  void insert(std::size_t at, std::string text) { edits_.push_back({at, 0, std::move(text)}); }
  void insert_after(std::size_t i, std::string text) { insert(tokens_[i].first + token(i).size(), std::move(text)); }

  bool spaced(std::size_t i) const {
    const std::size_t first = tokens_[i].first;
    const std::size_t end = first + token(i).size();
    const auto blank = [&](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    return first > 0 && end < text_.size() && blank(text_[first - 1]) && blank(text_[end]);
  }

  // Of what is known when it is compiled nothing is another: the last token that is passed over, or i.
  std::size_t pass_over(std::size_t i) const {
    const std::string_view word = token(i);
    if (word == "static_assert" || word == "using" || word == "template" || word == "constexpr" || word == "struct" ||
        word == "operator") {
      return end_of_declaration(i);
    }
    if (word == "case") {
      while (token(i) != ":") ++i;
    } else if (word == "<" && !spaced(i)) {
      i = matching(i, "<", ">");
    } else if (word == "enum") {
      i = matching(i, "{", "}");
    } else if (word == "if" && token(i + 1) == "constexpr") {
      i = matching(i + 2, "(", ")");
    }
    return i;
  }

  // Handles token i; the last token that needs no other look.
  std::size_t visit(std::size_t i) {
    const std::string_view word = token(i);
    const std::size_t passed = pass_over(i);
    if (passed != i) return passed;
    if (word == "if" || word == "while") {
      const std::size_t close = matching(i + 1, "(", ")");
      const bool declares = std::any_of(tokens_.begin() + static_cast<std::ptrdiff_t>(i),
                                        tokens_.begin() + static_cast<std::ptrdiff_t>(close),
                                        [](const Token& each) { return each.text == "="; });
      if (!declares) insert(tokens_[close].first, fmt::format(" || {}{{}}", site(i, "Condition")));
    } else if (word == "?") {
      insert(tokens_[i].first, fmt::format("|| {}{{}} ", site(i, "Condition")));
    } else if (word == "return" || keeps_value(i)) {
      // A number by itself is a site of its own.
      const bool is_single_number = is_number(i + 1) && (token(i + 2) == ";" || token(i + 2) == ",");
      if (token(i + 1) != "{" && token(i + 1) != ";" && token(i + 1) != "[" && !is_single_number) {
        insert_after(i, fmt::format(" {}{{}} ^=", site(i, "Value")));
      }
    } else if (is_number(i)) {
      const Token& number = tokens_[i];
      edits_.push_back({number.first, word.size(), fmt::format("{}({})", site(i, "literal"), word)});
    } else {
      visit_operator(i);
    }
    return i;
  }

  bool keeps_value(std::size_t i) const {
    static const std::set<std::string_view> keeping{"=", "+=", "-=", "*=", "/=", "|=", "&=", ">>=", "<<="};
    const bool is_reference = i >= 2 && (token(i - 2) == "&" || token(i - 2) == "*" || token(i - 2) == "&&");
    return keeping.contains(token(i)) && spaced(i) && !is_reference && token(i + 1) != "default" &&
           token(i + 1) != "delete";
  }

  bool is_number(std::size_t i) const {
    const std::string_view word = token(i);
    if (word.empty()) return false;
    if (word == "true" || word == "false") return true;
    const std::size_t end = tokens_[i].first + word.size();
    const bool part_of_float = text_[end] == '.' || (tokens_[i].first > 0 && text_[tokens_[i].first - 1] == '.');
    const bool is_hex = word.starts_with("0x");
    const bool is_float = !is_hex && word.find_first_of("eE.fF") != std::string_view::npos;
    return std::isdigit(static_cast<unsigned char>(word[0])) != 0 && !part_of_float && !is_float;
  }

  void visit_operator(std::size_t i) {
    const std::string_view word = token(i);
    // Two brackets that close templates look the same but for the space.
    if (word == ">" && token(i + 1) == ">" && tokens_[i + 1].first == tokens_[i].first + 1) {
      const bool shifts = std::isspace(static_cast<unsigned char>(text_[tokens_[i].first - 1])) != 0;
      if (shifts) insert_after(i + 1, fmt::format(" {}{{}} >>", site(i, "ShiftRight")));
    } else if (const Pattern* const binary = kind_of(word, 2); binary != nullptr && spaced(i)) {
      insert_after(i, fmt::format(" {}{{}} {}", site(i, binary->name), word));
    } else if (const Pattern* const unary = kind_of(word, 1); unary != nullptr && !spaced(i)) {
      edits_.push_back({tokens_[i].first, 1, fmt::format("{}{{}}->*", site(i, unary->name))});
    }
  }

  std::string_view text_;
  const std::string& file_;
  std::vector<ModelSite>& sites_;
  std::vector<Token> tokens_;
  std::vector<Edit> edits_;
};

}  // namespace

std::string instrument_source(std::string_view text, const std::string& file, std::vector<ModelSite>& sites) {
  return SourceInstrumenter(text, file, sites).run();
}

std::string ModelSite::alternative(std::uint32_t alternative) const {
  const auto& alternatives = std::ranges::find(kKinds, kind, &Pattern::name)->alternatives;
  return alternative < alternatives.size() ? std::string(alternatives[alternative]) : "";
}

std::string ModelSite::place() const { return fmt::format("{} at {}:{}.{}", token, file, line, column); }

}  // namespace feline::mutation
