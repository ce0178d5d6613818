// SPDX-License-Identifier: Apache-2.0
#include "reports/allocated.h"

#include <malloc.h>

namespace plumbline::reports {

std::size_t allocated_bytes() {
    const struct mallinfo2 info = ::mallinfo2();
    return info.uordblks + info.hblkhd;
}

}  // namespace plumbline::reports
