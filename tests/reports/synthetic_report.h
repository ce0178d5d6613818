// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reports/report.h"

namespace plumbline::reports {

/// A report made of pictures with known values, without any rendering: `scenes` scenes of `width` x
/// `height` pixels. Each has a truth with noise of standard error 0.01, the
/// models thesis, thesis-fitted and conserving with biases of their own, and a path tracer.
/// `hostile` puts markup into every text that a user's scene file can bring.
Report synthetic_report(int width, int height, int scenes = 1, bool hostile = false);

/// Text that breaks out of HTML or scripts that do not escape it.
extern const char* const hostile_text;

}  // namespace plumbline::reports
