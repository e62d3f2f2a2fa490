// SPDX-License-Identifier: Apache-2.0
#include "testbench/page/html.h"

#include <fmt/format.h>

#include <stdexcept>

namespace feline::page {
namespace {

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --ink: #1b1f24; --paper: #fff; --line: #d5d9de; --soft: #f4f6f8;
  --good: #116329; --bad: #b3261e; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e7eb; --paper: #14171a; --line: #3a4048; --soft: #1e2227; --good: #6fcf8a; --bad: #ff8a80; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem; max-width: 78rem; color: var(--ink); background: var(--paper);
  font: 16px/1.5 system-ui, sans-serif; overflow-wrap: break-word; }
h1 { font-size: 1.7rem; line-height: 1.2; }
h2 { font-size: 1.3rem; margin-top: 2.2rem; border-bottom: 1px solid var(--line); }
h3 { font-size: 1.05rem; margin-top: 1.6rem; }
p, li { max-width: 46rem; }
.scroll { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; font-size: 0.875rem; line-height: 1.35; }
caption { text-align: left; padding: 0.3rem 0; font-weight: 600; }
th, td { padding: 0.3rem 0.6rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
th { background: var(--soft); }
td:first-child { white-space: nowrap; }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.good { color: var(--good); font-weight: 600; }
.bad { color: var(--bad); font-weight: 600; }
.gallery { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 32rem), 1fr)); }
.thumbnails { display: grid; gap: 0.75rem; grid-template-columns: repeat(auto-fill, minmax(9.5rem, 1fr)); }
.magnified { image-rendering: pixelated; }
summary { cursor: pointer; padding: 0.4rem 0; }
figure { margin: 0; }
figure svg, figure img { display: block; width: 100%; max-width: 100%; height: auto; }
figcaption { font-size: 0.875rem; }
)";

std::string_view tone_name(Tone tone) {
  switch (tone) {
    case Tone::kGood: return "good";
    case Tone::kBad: return "bad";
    case Tone::kPlain: break;
  }
  return "";
}

// ` class="a b"` of those that are there.
std::string classes(bool number, Tone tone) {
  std::string names = number ? "number" : "";
  if (tone != Tone::kPlain) names += (names.empty() ? "" : " ") + std::string(tone_name(tone));
  return names.empty() ? "" : fmt::format(" class=\"{}\"", names);
}

}  // namespace

std::string escape(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&': html += "&amp;"; break;
      case '<': html += "&lt;"; break;
      case '>': html += "&gt;"; break;
      case '"': html += "&quot;"; break;
      default: html += c;
    }
  }
  return html;
}

std::string heading(int level, std::string_view text) { return fmt::format("<h{0}>{1}</h{0}>\n", level, escape(text)); }

std::string paragraph(std::string_view text) { return fmt::format("<p>{}</p>\n", escape(text)); }

std::string bullets(std::span<const std::string> texts) {
  if (texts.empty()) return {};
  std::string html = "<ul>\n";
  for (const std::string& text : texts) html += fmt::format("<li>{}</li>\n", escape(text));
  return html + "</ul>\n";
}

std::string table(const Table& table) {
  std::string html = "<div class=\"scroll\"><table>\n";
  if (!table.caption.empty()) html += fmt::format("<caption>{}</caption>\n", escape(table.caption));
  html += "<thead><tr>";
  for (const Table::Column& column : table.columns) {
    html += fmt::format("<th{}>{}</th>", classes(column.number, Tone::kPlain), escape(column.name));
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    if (row.size() != table.columns.size()) throw std::invalid_argument("a row of another length than the columns");
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      html += fmt::format("<td{}>{}</td>", classes(table.columns[i].number, row[i].tone), escape(row[i].text));
    }
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table></div>\n";
}

std::string figure(std::string_view html, std::string_view caption_text) {
  return fmt::format("<figure>\n{}\n<figcaption>{}</figcaption>\n</figure>\n", html, escape(caption_text));
}

std::string gallery(std::span<const std::string> html) {
  std::string all = "<div class=\"gallery\">\n";
  for (const std::string& piece : html) all += piece;
  return all + "</div>\n";
}

std::string thumbnails(std::span<const std::string> html) {
  std::string all = "<div class=\"thumbnails\">\n";
  for (const std::string& piece : html) all += piece;
  return all + "</div>\n";
}

std::string fold(std::string_view summary_text, std::string_view html) {
  return fmt::format("<details>\n<summary>{}</summary>\n{}</details>\n", escape(summary_text), html);
}

std::string png(std::string_view file_in_base64, std::string_view text, bool magnified) {
  return fmt::format("<img alt=\"{}\"{} src=\"data:image/png;base64,{}\">", escape(text),
                     magnified ? " class=\"magnified\"" : "", file_in_base64);
}

std::string png(std::span<const std::byte> file, std::string_view text) { return png(base64(file), text, false); }

std::string base64(std::span<const std::byte> bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      group = (group << 8) | (i < count ? std::to_integer<std::uint32_t>(bytes[at + i]) : 0);
    }
    for (std::size_t i = 0; i < 4; ++i) text += i <= count ? kDigits[(group >> (18 - 6 * i)) & 63] : '=';
  }
  return text;
}

std::string document(std::string_view text, std::string_view html) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{0}</title>\n"
      "<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}</body>\n</html>\n",
      escape(text), kStyle, html);
}

}  // namespace feline::page
