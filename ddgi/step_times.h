// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace plumbline::ddgi {

/// What the steps took by which probes follow a scene from frame to frame: ms of wall-clock time.
struct StepTimes {
    double planes = 0;        ///< taking in the planes of surfaces, for `see`
    double mark_places = 0;   ///< which surfels may end elsewhere, or see other probes
    double place = 0;         ///< tracing their rays
    double see = 0;           ///< which probes around them they see
    double mark_shadows = 0;  ///< which may be lit otherwise
    double light = 0;         ///< shadow rays
    double take = 0;          ///< what the model keeps of surfels that changed
    double update = 0;        ///< of the probes, and by how much it changed them

    double placing() const { return planes + mark_places + place + see; }
    double lighting() const { return mark_shadows + light + take + update; }
};

/// The steps in their order, by name.
struct TimedStep {
    const char* name;
    double StepTimes::*ms;
};
constexpr std::array timed_steps = {
    TimedStep{"planes", &StepTimes::planes},
    TimedStep{"mark_places", &StepTimes::mark_places},
    TimedStep{"place", &StepTimes::place},
    TimedStep{"see", &StepTimes::see},
    TimedStep{"mark_shadows", &StepTimes::mark_shadows},
    TimedStep{"light", &StepTimes::light},
    TimedStep{"take", &StepTimes::take},
    TimedStep{"update", &StepTimes::update},
};

inline StepTimes& operator+=(StepTimes& sum, const StepTimes& times) {
    for (const TimedStep& step : timed_steps) sum.*step.ms += times.*step.ms;
    return sum;
}

/// Times of threads, which overlap, as shares of the wall-clock time that they took together.
inline StepTimes shared_out(const StepTimes& threads, double wall_ms) {
    double sum = 0.;
    for (const TimedStep& step : timed_steps) sum += threads.*step.ms;
    StepTimes shares;
    if (sum == 0.) return shares;
    for (const TimedStep& step : timed_steps) shares.*step.ms = threads.*step.ms / sum * wall_ms;
    return shares;
}

}  // namespace plumbline::ddgi
