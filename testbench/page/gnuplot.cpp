// SPDX-License-Identifier: Apache-2.0
#include "testbench/page/gnuplot.h"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

#include "testbench/error.h"
#include "testbench/page/html.h"
#include "testbench/process.h"

namespace feline::page {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
}

void remove_all(std::string& text, std::string_view from, std::string_view until) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos;) {
    text.erase(at, text.find(until, at) + until.size() - at);
  }
}

// gnuplot's document to an element of a page: no declaration, name spaces or version; names of this plot alone; the
// text colour for black.
std::string embedded(std::string svg, const Drawing& drawing) {
  svg.erase(0, svg.find("<svg"));
  svg.erase(0, svg.find('>') + 1);
  remove_all(svg, "<title>", "</title>");
  remove_all(svg, "<desc>", "</desc>");
  remove_all(svg, "<filter", "</filter>");
  for (const char* const quote : {"'", "\""}) {
    replace_all(svg, fmt::format("id={}", quote), fmt::format("id={}{}-", quote, drawing.name));
    replace_all(svg, fmt::format("xlink:href={}#", quote), fmt::format("href={}#{}-", quote, drawing.name));
    replace_all(svg, fmt::format("stroke={0}black{0}", quote), "stroke=\"currentColor\"");
    replace_all(svg, fmt::format("fill={0}black{0}", quote), "fill=\"currentColor\"");
    replace_all(svg, fmt::format(" color={0}black{0}", quote), "");
  }
  replace_all(svg, "url(#", "url(#" + drawing.name + "-");
  while (svg.ends_with('\n')) svg.pop_back();
  return fmt::format("<svg role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {} {}\">{}", escape(drawing.title),
                     drawing.width, drawing.height, svg);
}

Finished gnuplot(std::string_view argument, std::string_view input) {
  try {
    return run_process({"gnuplot", std::string(argument)}, input);
  } catch (const std::system_error& error) {
    throw InputError(fmt::format("gnuplot: {}; plots need it (Debian package gnuplot-nox)", error.code().message()));
  }
}

}  // namespace

void check_gnuplot() { gnuplot("--version", ""); }

// A line's end would end the command.
std::string quoted(std::string_view text) {
  std::string safe = "'";
  for (const char c : text) safe += c == '\'' ? "''" : c == '\n' ? " " : std::string(1, c);
  return safe + "'";
}

std::string run_gnuplot(std::string_view commands, const Drawing& drawing) {
  const std::string script =
      fmt::format("set terminal svg size {},{} dynamic font 'sans-serif,15' noenhanced\nset encoding utf8\n{}",
                  drawing.width, drawing.height, commands);
  Finished finished = gnuplot("--default-settings", script);
  if (finished.code != 0 || finished.output.find("</svg>") == std::string::npos) {
    throw InputError(
        fmt::format("gnuplot: exit code {} for plot {}: {}", finished.code, drawing.name, finished.errors));
  }
  return embedded(std::move(finished.output), drawing);
}

}  // namespace feline::page
