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

    /// Whole passes that `passes` holds.
    std::uint64_t passes_done(const Passes& passes) const;
    /// Passes in all, as far as one can tell: variance falls as one over the samples.
    std::uint64_t passes_expected() const { return expected_; }
    /// Samples done and their error, for people.
    const std::string& label() const { return label_; }

 private:
    bool counted() const { return !options_.seconds && !options_.target_relmse; }
    bool done(const Passes& passes, int samples, double seconds) const;
    void look_ahead(const Passes& passes, int samples, double seconds);

    const RenderOptions& options_;
    std::uint64_t expected_ = 1;
    std::string label_;
};

}  // namespace plumbline::pathtracer
