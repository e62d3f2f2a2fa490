// SPDX-License-Identifier: Apache-2.0
// The stimuli that coverage is counted of: what they run is compared, and a unit that computes wrong fails.
#include <gtest/gtest.h>

#include "testbench/coverage/suite.h"
#include "tests/rtl/fault.h"
#include "tests/rtl/faulty_unit.h"

namespace feline::coverage {
namespace {

TEST(coverage_suite, fails_where_the_rtl_is_wrong) {
  for (const Fault& fault : {kFaults[0], kFaults[std::size(kFaults) / 2], kFaults[std::size(kFaults) - 1]}) {
    set_fault(fault.number);
    const CoveredUnit unit{make_faulty_unit(1), [] {}, {}};
    const SuiteResult result = run_suite(unit, 1);
    set_fault(0);
    EXPECT_NE(result.mismatch.find(std::string("MISMATCH at stage ") + fault.stage), std::string::npos)
        << fault.what << ": " << result.mismatch;
  }
}

}  // namespace
}  // namespace feline::coverage
