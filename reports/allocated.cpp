// SPDX-License-Identifier: Apache-2.0
#include "reports/allocated.h"

#include <malloc.h>

#if __has_include(<sanitizer/allocator_interface.h>)
#include <sanitizer/allocator_interface.h>
#endif

namespace plumbline::reports {

std::size_t allocated_bytes() {
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
    // It allocates in glibc's stead.
    return __sanitizer_get_current_allocated_bytes();
#endif
#endif
    const struct mallinfo2 info = ::mallinfo2();
    return info.uordblks + info.hblkhd;
}

}  // namespace plumbline::reports
