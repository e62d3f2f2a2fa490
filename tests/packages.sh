# SPDX-License-Identifier: Apache-2.0
# The packages of the tests, besides those of the build. Sourced after testbench/build.sh.
feline_install_tests() {
  feline_install clang++=clang clang-format=clang-format clang-tidy=clang-tidy yosys=yosys cadical=cadical \
    iverilog=iverilog /usr/share/qflow/tech/osu018=qflow-tech-osu018 "$@"
}

# Those of tests/coverage.sh.
feline_install_coverage() {
  feline_install clang++=clang llvm-cov=llvm
}

# Also those of the long tests: the pages are opened in a browser; libFuzzer is apart from clang.
feline_install_long_tests() {
  feline_install_tests chromium=chromium llvm-cov=llvm \
    "/usr/lib/llvm-*/lib/clang/*/lib/linux/libclang_rt.fuzzer-*.a=libclang-rt-14-dev"
}
