# SPDX-License-Identifier: Apache-2.0
# The packages of the tests, besides those of the build. Sourced after testbench/build.sh.
feline_install_tests() {
  feline_install clang++=clang clang-format=clang-format clang-tidy=clang-tidy yosys=yosys iverilog=iverilog \
    /usr/share/qflow/tech/osu018=qflow-tech-osu018 "$@"
}

# Also those of the long tests: the pages are opened in a browser.
feline_install_long_tests() {
  feline_install_tests chromium=chromium
}
