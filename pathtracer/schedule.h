// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "pathtracer/passes.h"

namespace plumbline::pathtracer {

/// Which passes a render takes: all of its samples a pixel, or until time or error ends it.
///
/// What comes next depends on what `passes` holds and on the time spent, never on how the process
/// came there, so that a resumed render goes on as if it had not stopped.
class Schedule {
 public:
    explicit Schedule(const RenderOptions& options) : options_(options) {}

    /// The next pass, or none after the last. `seconds` have been spent so far.
    std::optional<Pass> next(const Passes& passes, double seconds);

    /// Whether what `passes` holds is the pilot of an adaptive render.
    bool pilot_ends(const Passes& passes) const {
        return options_.adaptive && passes.samples() == pilot_samples(options_.spp);
    }

    /// Samples a pixel in all, as far as one can tell: variance falls as one over the samples.
    int samples_expected() const { return expected_; }
    /// Samples done and their error, for people.
    const std::string& label() const { return label_; }

 private:
    bool counted() const { return !options_.seconds && !options_.target_relmse; }
    bool done(const Passes& passes, int samples, double seconds) const;
    void look_ahead(const Passes& passes, int samples, double seconds);

    const RenderOptions& options_;
    int expected_ = 1;
    std::string label_;
};

}  // namespace plumbline::pathtracer
