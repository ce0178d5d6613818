// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pathtracer/statistics.h"

namespace plumbline::test {

using pathtracer::chi_square_z;
using pathtracer::sidak_limit;

}  // namespace plumbline::test
