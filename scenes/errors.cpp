// SPDX-License-Identifier: Apache-2.0
#include "scenes/errors.h"

#include "scenes/printable.h"

namespace plumbline {

InputError::InputError(const std::string& where, const std::string& problem,
                       const std::string& cure)
    : std::runtime_error(printable(where + ": " + problem + "; " + cure)) {}

}  // namespace plumbline
