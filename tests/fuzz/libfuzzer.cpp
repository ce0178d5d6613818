// SPDX-License-Identifier: Apache-2.0
// The entry that libFuzzer calls; PLUMBLINE_FUZZ_TARGET is one of the targets.
#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    plumbline::fuzz::PLUMBLINE_FUZZ_TARGET({bytes, size});
    return 0;
}
