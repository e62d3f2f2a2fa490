// SPDX-License-Identifier: Apache-2.0
#include "tests/testbench/report/browser.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "testbench/process.h"

namespace feline {
namespace {

// The page in a frame, as a phone's window is no window that headless Chromium has; the answer takes the place of the
// document, where --dump-dom finds it.
constexpr const char* kWrapper = R"html(<!DOCTYPE html><html><body>
<iframe id="frame" src="{}" style="width:{}px;height:2000px;border:0"></iframe>
<script>
window.onload = () => {{
  const page = document.getElementById("frame").contentDocument;
  for (const fold of page.querySelectorAll("details")) fold.open = {};
  const boxes = (name) => [...page.querySelectorAll(name)].map((element) => {{
    const box = element.getBoundingClientRect();
    return {{left: box.left, right: box.right, height: box.height, natural_width: element.naturalWidth || 0,
            folded: element.closest("details:not([open])") !== null}};
  }});
  const told = {{scroll_width: page.documentElement.scrollWidth, frame_width: page.documentElement.clientWidth,
                drawings: boxes("svg"), pictures: boxes("img")}};
  document.documentElement.innerHTML = "<body><pre>TOLD" + JSON.stringify(told) + "END</pre></body>";
}};
</script></body></html>
)html";

Finished run_chromium(const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"timeout", "120", "chromium"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  Finished finished = run_process(command, "");
  if (finished.code == 127) {
    throw std::runtime_error("no chromium on the PATH (Debian package chromium): ./tests/run --all installs it");
  }
  return finished;
}

std::vector<Visit::Box> boxes_of(const nlohmann::json& json) {
  std::vector<Visit::Box> boxes;
  for (const auto& box : json) {
    boxes.push_back({box.at("left"), box.at("right"), box.at("height"), box.at("natural_width"), box.at("folded")});
  }
  return boxes;
}

// Chromium asks for updates of its own, which no page initiated; files are not in the log.
std::vector<std::string> requests_of(const std::string& log) {
  std::vector<std::string> urls;
  const auto json = nlohmann::json::parse(log);
  for (const auto& event : json.at("events")) {
    const auto parameters = event.find("params");
    if (parameters == event.end() || !parameters->contains("initiator")) continue;
    if (parameters->at("initiator") != "not an origin") urls.push_back(parameters->at("url"));
  }
  return urls;
}

std::vector<std::string> lines_with(const std::string& text, std::string_view part) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.find(part) != std::string::npos) lines.push_back(line);
  }
  return lines;
}

}  // namespace

Visit visit(const TempDir& dir, const std::filesystem::path& page, int width, bool unfolded) {
  write_bytes(dir / "wrapper.html", fmt::format(kWrapper, "file://" + page.string(), width, unfolded));
  const std::filesystem::path profile = dir / "profile";
  const std::filesystem::path log = dir / "network.json";
  std::filesystem::remove_all(profile);
  std::filesystem::remove(log);
  const Finished finished = run_chromium(
      {"--headless", "--no-sandbox", "--user-data-dir=" + profile.string(), "--allow-file-access-from-files",
       "--disable-background-networking", "--disable-component-update", "--no-first-run",
       "--host-resolver-rules=MAP * ~NOTFOUND", "--enable-logging=stderr", "--v=0", "--log-net-log=" + log.string(),
       "--window-size=1600,2400", "--dump-dom", "file://" + (dir / "wrapper.html").string()});
  const std::size_t start = finished.output.find("TOLD");
  const std::size_t end = finished.output.find("END</pre>");
  if (finished.code != 0 || start == std::string::npos || end == std::string::npos) {
    throw std::runtime_error(fmt::format("chromium: exit code {}, {}: {}\n{}", finished.code, page.string(),
                                         finished.output, finished.errors));
  }
  const auto told = nlohmann::json::parse(finished.output.substr(start + 4, end - start - 4));
  return {told.at("scroll_width"),
          told.at("frame_width"),
          boxes_of(told.at("drawings")),
          boxes_of(told.at("pictures")),
          lines_with(finished.errors, ":CONSOLE"),
          requests_of(read_bytes(log))};
}

}  // namespace feline
