// SPDX-License-Identifier: Apache-2.0
#include "ddgi/spectral_radius.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "ddgi/look_up.h"

namespace plumbline::ddgi {
namespace {

constexpr double settled_below = 1e-5;  ///< of the value: what later iterations may still change
constexpr int settled_in_a_row = 4;     ///< estimates, for a turning point changes little too
constexpr int most_iterations = 500;
constexpr double critical_within = 1e-4;  ///< of a radius of 1
constexpr int most_secants = 40;

/// How far the iteration goes from the dark, of the light b that one update brings. More would meet
/// the clamp of the thesis's surfels; less would drown in the rounding of b.
constexpr float amplitude_of_light = 0.1f;
/// ... and where there is no light, hence no rounding of it.
constexpr float amplitude_in_the_dark = 1e-3f;

float largest_of(std::span<const float> values) {
    float largest = 0.f;
    for (const float value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

/// What is left to change if changes go on shrinking as `change` did from `change_before`: a small
/// change alone would also end the iteration where a second mode dies slowly.
double left_to_change(double change, double change_before) {
    if (std::isinf(change_before)) return change_before;  // the first estimate
    if (change == 0.) return 0.;
    const double ratio = change / change_before;
    return ratio < 1. ? change * ratio / (1. - ratio) : change_before + change;
}

constexpr const char* feedback_constant = "multiBounceIntensity";

/// One colour channel of all probes, and what is known of its radius.
struct Channel {
    std::size_t index;
    std::size_t probes;
    std::size_t bins;
    double radius = 0.;
    double change = std::numeric_limits<double>::infinity();
    int calm = 0;  ///< estimates in a row that leave little to change

    template <typename Visit>
    void for_each(std::span<float> values, const Visit& visit) const {
        for (std::size_t probe = 0; probe < probes; ++probe) {
            const std::size_t first = value_index(probe, index, 0, bins);
            for (float& value : values.subspan(first, bins)) visit(value);
        }
    }

    double l1_norm(std::span<float> values) const {
        double sum = 0.;
        for_each(values, [&](const float& value) { sum += std::abs(double(value)); });
        return sum;
    }

    void scale_to_one(std::span<float> values) const {
        float largest = 0.f;
        for_each(values, [&](const float& value) { largest = std::max(largest, std::abs(value)); });
        if (largest > 0.f) for_each(values, [&](float& value) { value /= largest; });
    }

    /// Takes in an iteration that led from `mode` to `next`.
    void take(std::span<float> mode, std::span<float> next) {
        const double before = l1_norm(mode);
        const double radius_before = radius;
        radius = before > 0. ? l1_norm(next) / before : 0.;
        const double change_before = std::exchange(change, std::abs(radius - radius_before));
        const bool still = left_to_change(change, change_before) <= settled_below * radius;
        calm = still ? calm + 1 : 0;
        scale_to_one(next);
    }
};

}  // namespace

SpectralRadius spectral_radius(const ProbeModel& model, std::size_t probes, std::size_t values,
                               std::vector<float>& mode) {
    if (mode.empty()) mode.assign(values, 1.f);
    std::vector<float> state(values, 0.f);
    std::vector<float> lit(values);
    std::vector<float> next(values);
    model.update(state, lit);
    const float light = largest_of(lit);
    const float amplitude = light > 0.f ? amplitude_of_light * light : amplitude_in_the_dark;
    const std::size_t bins = values / (3 * probes);
    std::array<Channel, 3> channels{{{0, probes, bins}, {1, probes, bins}, {2, probes, bins}}};
    SpectralRadius radius;
    while (!radius.settled && radius.updates < most_iterations) {
        for (std::size_t i = 0; i < values; ++i) state[i] = amplitude * mode[i];
        model.update(state, next);
        // Cancellation: where b is far above what the mode adds, only b's rounding is left. The
        // norm is a sum, to which such values give little.
        for (std::size_t i = 0; i < values; ++i) next[i] = (next[i] - lit[i]) / amplitude;
        radius.value = 0.;
        radius.settled = true;
        for (Channel& channel : channels) {
            channel.take(mode, next);
            radius.value = std::max(radius.value, channel.radius);
            radius.settled = radius.settled && channel.calm >= settled_in_a_row;
        }
        mode.swap(next);
        ++radius.updates;
        if (!std::isfinite(radius.value)) break;
    }
    return radius;
}

std::optional<double> critical_multi_bounce(const Scene& scene, const ProbeVolume& volume,
                                            const DdgiOptions& options) {
    std::vector<float> mode;
    const auto excess_at = [&](double intensity) {
        std::map<std::string, double> set = options.set;
        set[feedback_constant] = intensity;
        const ModelSetup setup =
            make_model(options.model, scene, volume.cache().grid(), set, options.probes);
        setup.model->take_surfels(volume.cache());
        // The mode of one intensity is a good start for the next.
        return spectral_radius(*setup.model, probe_count(volume.cache().grid()),
                               volume.values().size(), mode)
                   .value -
               1.;
    };
    const auto asked = options.set.find(feedback_constant);
    if (options.model != "thesis" || asked == options.set.end()) return std::nullopt;
    double high = asked->second;
    double above = excess_at(high);
    if (above < 0.) return std::nullopt;
    double low = 0.;
    double below = excess_at(low);
    if (below >= 0.) return std::nullopt;
    mode.clear();
    // False position with the Illinois rule [Dowell and Jarratt 1971].
    double intensity = high;
    for (int i = 0; i < most_secants; ++i) {
        intensity = (low * above - high * below) / (above - below);
        const double excess = excess_at(intensity);
        if (std::abs(excess) <= critical_within) break;
        if (excess > 0.) {
            high = intensity;
            above = excess;
            below /= 2.;
        } else {
            low = intensity;
            below = excess;
            above /= 2.;
        }
    }
    return intensity;
}

}  // namespace plumbline::ddgi
