// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/schedule.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace plumbline::pathtracer {
namespace {

constexpr int batch = Sampler::batch_size;

/// Below two batches there is only the spread of single samples to tell the variance from.
constexpr int fewest_for_batches = 2 * batch;

}  // namespace

std::optional<Pass> Schedule::next(const Passes& passes, double seconds) {
    const int samples = passes.samples();
    // Within a pass, the decision to take it stands.
    if (passes.between_passes() && done(passes, samples, seconds)) return std::nullopt;
    look_ahead(passes, samples, seconds);
    if (counted() && options_.spp < fewest_for_batches) return Pass{options_.spp, 1};
    const bool singly = samples == 0 && !counted();
    return Pass{std::min(samples + batch, options_.spp), singly ? 1 : batch};
}

bool Schedule::done(const Passes& passes, int samples, double seconds) const {
    if (samples >= options_.spp) return true;
    if (samples == 0) return false;
    if (options_.target_relmse) {
        return relmse_estimate(passes.pixels()) <= *options_.target_relmse;
    }
    if (!options_.seconds) return false;
    const double more = passes.rays_to(samples + batch) / double(passes.rays());
    return seconds * (1. + more) > *options_.seconds;
}

void Schedule::look_ahead(const Passes& passes, int samples, double seconds) {
    if (!Progress::visible()) return;
    label_ = counted() ? fmt::format("{} of {} samples a pixel", samples, options_.spp)
                       : fmt::format("{} samples a pixel", samples);
    double expected = options_.spp;
    if (samples == 0) {
        if (!counted()) expected = batch;
    } else {
        const double relmse = relmse_estimate(passes.pixels());
        label_ += fmt::format(", relMSE {:.2g}", relmse);
        if (options_.seconds) expected = samples * *options_.seconds / seconds;
        if (options_.target_relmse) {
            label_ += fmt::format(" of {:.2g}", *options_.target_relmse);
            expected = samples * relmse / *options_.target_relmse;
        }
        expected = std::clamp(expected, double(samples), double(options_.spp));
    }
    expected_ = static_cast<int>(std::ceil(expected));
}

}  // namespace plumbline::pathtracer
