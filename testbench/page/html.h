// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Pages of one file that need no network: text, tables, inline SVG and PNG. Every function returns a piece of HTML;
// arguments called `text` are plain and get escaped, those called `html` are pieces already.
namespace feline::page {

// For text and for attributes in double quotes.
std::string escape(std::string_view text);

std::string heading(int level, std::string_view text);
std::string paragraph(std::string_view text);
// "- " before each; nothing for no items.
std::string bullets(std::span<const std::string> texts);

// What a cell says beyond its text.
enum class Tone { kPlain, kGood, kBad };

struct Cell {
  std::string text;
  Tone tone = Tone::kPlain;
};

struct Table {
  struct Column {
    std::string name;
    bool number = false;  // right-aligned, digits of equal width
  };
  std::string caption;  // none where empty
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  // each as long as columns; std::invalid_argument otherwise
};
// In a box of its own that scrolls sideways where the window is narrower than the table.
std::string table(const Table& table);

// A picture or plot with its caption beneath.
std::string figure(std::string_view html, std::string_view caption_text);
// Figures side by side where the window is wide enough, beneath each other where it is not.
std::string gallery(std::span<const std::string> html);
// Small figures in rows, as many as fit.
std::string thumbnails(std::span<const std::string> html);
// A piece that opens when its summary is chosen.
std::string fold(std::string_view summary_text, std::string_view html);
// A PNG file's bytes within the page; `text` is for those who do not see it.
std::string png(std::span<const std::byte> file, std::string_view text);
// The same of base64; `magnified`: pixels stay sharp squares.
std::string png(std::string_view file_in_base64, std::string_view text, bool magnified);
std::string base64(std::span<const std::byte> bytes);

// The whole file: style sheet included, light or dark as the reader's system is; `text` is the title.
std::string document(std::string_view text, std::string_view html);

}  // namespace feline::page
