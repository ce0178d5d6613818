// SPDX-License-Identifier: Apache-2.0
#include "reports/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace plumbline::reports {

namespace {

/// What an error is multiplied by when a tenth of it is gone.
constexpr double tenth_less = .9;

using Points = std::vector<TimedError>;

/// The best point within a budget.
std::optional<TimedError> best_within(const Points& points, double seconds) {
    std::optional<TimedError> best;
    for (const TimedError& point : points)
        if (point.seconds <= seconds && (!best || point.error < best->error)) best = point;
    return best;
}

/// All points but those that the law speaks for.
Points points_beside(std::span<const TimedError> points, const std::optional<ErrorLaw>& law) {
    Points others(points.begin(), points.end());
    if (law)
        std::erase_if(others, [&](const TimedError& point) { return point.method == law->method; });
    return others;
}

/// Every time at which the best method can change, rising.
std::vector<double> turning_points(const Points& points, const std::optional<ErrorLaw>& law) {
    std::vector<double> times;
    for (const TimedError& point : points) {
        times.push_back(point.seconds);
        if (law) times.push_back(std::max(law->seconds_to(point.error), law->least_seconds));
    }
    if (law) times.push_back(law->least_seconds);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

/// The best of all between two turning points, where it does not change.
std::string best_between(const Points& points, const std::optional<ErrorLaw>& law, double from,
                         double until) {
    const double inside = std::isfinite(until) ? std::sqrt(from * until) : 2 * from;
    const std::optional<TimedError> point = best_within(points, inside);
    const bool law_has_begun = law && inside >= law->least_seconds;
    if (!point || (law_has_begun && law->error_after(inside) < point->error)) return law->method;
    return point->method;
}

}  // namespace

std::vector<std::size_t> pareto_set(std::span<const TimedError> points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if (points[a].seconds != points[b].seconds) return points[a].seconds < points[b].seconds;
        return points[a].error < points[b].error;
    });
    std::vector<std::size_t> best;
    for (const std::size_t i : order)
        if (best.empty() || points[i].error < points[best.back()].error) best.push_back(i);
    return best;
}

std::vector<ErrorFloor> error_floors(std::span<const TimedError> points) {
    std::vector<ErrorFloor> floors;
    for (const TimedError& point : points) {
        const auto known = std::ranges::find_if(
            floors, [&](const ErrorFloor& floor) { return floor.floor.method == point.method; });
        if (known == floors.end())
            floors.push_back({point, point});
        else if (point.error < known->floor.error ||
                 (point.error == known->floor.error && point.seconds < known->floor.seconds))
            known->floor = point;
    }
    for (ErrorFloor& floor : floors) {
        floor.tenth_above = floor.floor;
        for (const TimedError& point : points)
            if (point.method == floor.floor.method &&
                tenth_less * point.error <= floor.floor.error &&
                point.seconds < floor.tenth_above.seconds)
                floor.tenth_above = point;
    }
    return floors;
}

double ErrorLaw::error_after(double seconds) const {
    return law.scale * std::pow(seconds, law.exponent);
}

double ErrorLaw::seconds_to(double error) const {
    return std::pow(error / law.scale, 1 / law.exponent);
}

std::optional<ErrorLaw> fit_error_law(std::span<const TimedError> points,
                                      const std::string& method) {
    std::vector<double> seconds;
    std::vector<double> errors;
    for (const TimedError& point : points) {
        if (point.method != method) continue;
        seconds.push_back(point.seconds);
        errors.push_back(point.error);
    }
    const std::optional<PowerLaw> law = fit_power_law(seconds, errors);
    if (!law || law->exponent >= 0) return std::nullopt;
    const auto [least, most] = std::minmax_element(seconds.begin(), seconds.end());
    return ErrorLaw{method, *law, *least, *most};
}

std::vector<Reign> best_by_budget(std::span<const TimedError> points,
                                  const std::optional<ErrorLaw>& law) {
    const Points others = points_beside(points, law);
    const std::vector<double> times = turning_points(others, law);
    std::vector<Reign> reigns;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double until =
            i + 1 < times.size() ? times[i + 1] : std::numeric_limits<double>::infinity();
        const std::string best = best_between(others, law, times[i], until);
        if (reigns.empty() || reigns.back().method != best)
            reigns.push_back({best, times[i], until, 0, 0});
        reigns.back().until_seconds = until;
    }
    for (Reign& reign : reigns) {
        const bool lawful = law && reign.method == law->method;
        Points own = others;
        std::erase_if(own, [&](const TimedError& point) { return point.method != reign.method; });
        const auto error_at = [&](double seconds) {
            return lawful ? law->error_after(seconds) : best_within(own, seconds)->error;
        };
        reign.error_from = error_at(reign.from_seconds);
        const bool ends = std::isfinite(reign.until_seconds);
        if (lawful && !ends)
            reign.error_until = reign.error_from;
        else
            reign.error_until =
                error_at(ends ? std::nextafter(reign.until_seconds, 0) : reign.until_seconds);
    }
    return reigns;
}

}  // namespace plumbline::reports
