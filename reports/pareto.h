// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/power_law.h"

namespace plumbline::reports {

/// A way to a picture: what it takes, and the error that it leaves. Both are above 0.
struct TimedError {
    std::string method;
    std::string setting;  ///< of the method
    double seconds;
    double error;
};

/// The points that no other beats, as indices: none is both as quick and as exact. By rising time,
/// and so by falling error; of equal points the first counts.
std::vector<std::size_t> pareto_set(std::span<const TimedError> points);

/// The least error that any setting of a method reached, and the quickest way near it.
struct ErrorFloor {
    TimedError floor;
    /// The quickest whose error less a tenth is at most the floor's: from here on, a tenth less
    /// error costs floor.seconds. The floor itself if no other is that near.
    TimedError tenth_above;
};

/// One for each method, in the order in which they first appear.
std::vector<ErrorFloor> error_floors(std::span<const TimedError> points);

/// A method whose error can be lowered without end by taking more time: error = scale
/// seconds^exponent, with an exponent below 0.
struct ErrorLaw {
    std::string method;
    PowerLaw law;
    double least_seconds;  ///< of the points that it was fitted to; none is quicker
    double most_seconds;

    double error_after(double seconds) const;
    double seconds_to(double error) const;
    bool extrapolates(double seconds) const {
        return seconds < least_seconds || seconds > most_seconds;
    }
};

/// None with fewer than two times, or if more time did not bring less error.
std::optional<ErrorLaw> fit_error_law(std::span<const TimedError> points,
                                      const std::string& method);

/// The times through which one method leaves the least error of all.
struct Reign {
    std::string method;
    double from_seconds;
    double until_seconds;  ///< infinite for the last
    double error_from;     ///< the error at its beginning ...
    double error_until;    ///< ... and just before its end; at its beginning if it has none
};

/// Which method is best at each budget of time, from the quickest point on, where a method has come
/// as far as its best point within the budget, and the law's method as far as the law says.
std::vector<Reign> best_by_budget(std::span<const TimedError> points,
                                  const std::optional<ErrorLaw>& law);

}  // namespace plumbline::reports
