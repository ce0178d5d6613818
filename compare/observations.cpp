// SPDX-License-Identifier: Apache-2.0
#include "compare/observations.h"

#include <algorithm>
#include <cmath>

#include "compare/lattice.h"
#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

ThesisPicture picture_of(const FitCase& fit_case) {
    const Image& reference = *fit_case.reference;
    for (const char* layer : {"indirect", "variance_indirect"})
        if (!reference.has_layer(layer))
            throw FitError(reference.source.empty() ? fit_case.scene->name : reference.source,
                           std::string("no layer '") + layer + "' to fit to",
                           "render the reference with `plumbline render`");
    return {*fit_case.scene, fit_case.frame, reference.width(), reference.height()};
}

bool finite(const std::array<std::span<const float>, 3>& layer, std::size_t i) {
    return std::isfinite(layer[0][i]) && std::isfinite(layer[1][i]) && std::isfinite(layer[2][i]);
}

/// Sums that a gain needs.
struct Products {
    double mm = 0, mr = 0, rr = 0, n = 0;
};

}  // namespace

Observations::Observations(const FitCase& fit_case) : picture_(picture_of(fit_case)) {
    const Image& reference = *fit_case.reference;
    const auto indirect = reference.layer("indirect");
    const auto variance = reference.layer("variance_indirect");
    const Lattice lattice(reference.width(), reference.height());
    double largest = 0;
    for (std::size_t i = 0; i < reference.pixels(); ++i) {
        if (!finite(indirect, i) || !finite(variance, i)) continue;
        const bool fitted = lattice.fitted(i);
        all_pixels_.push_back(std::uint32_t(i));
        if (fitted) pixels_.push_back(std::uint32_t(i));
        for (std::size_t c = 0; c < 3; ++c) {
            all_radiance_.push_back(double(indirect[c][i]));
            largest = std::max(largest, all_radiance_.back());
            if (!fitted) continue;
            radiance_.push_back(double(indirect[c][i]));
            variance_.push_back(double(variance[c][i]));
            tiles_.push_back(lattice.tile(i));
        }
    }
    if (pixels_.empty() || largest <= 0)
        throw FitError(reference.source.empty() ? fit_case.scene->name : reference.source,
                       "the indirect layer is black or not finite", "there is nothing to fit to");
    keep_variances_positive(radiance_, variance_);
}

BestGain best_gain(const std::vector<Observations>& cases) {
    Products sums;
    std::vector<std::vector<double>> models;
    for (const Observations& one : cases) {
        models.push_back(
            one.picture().indirect<double>(one.picture().published(), one.all_pixels()));
        for (std::size_t i = 0; i < models.back().size(); ++i) {
            const double m = models.back()[i], r = one.all_radiance()[i];
            sums.mm += m * m;
            sums.mr += m * r;
            sums.rr += r * r;
            sums.n += 1;
        }
    }
    if (!(sums.mm > 0))
        throw FitError("thesis", "the published picture is black, so no gain can fit",
                       "set bounceAttenuation and probeBrightness above 0");
    const double gain = sums.mr / sums.mm;
    double squares = 0, weighted = 0, before = 0;
    for (std::size_t k = 0; k < cases.size(); ++k)
        for (std::size_t i = 0; i < models[k].size(); ++i) {
            const double m = models[k][i], r = cases[k].all_radiance()[i];
            squares += (r - gain * m) * (r - gain * m);
            weighted += m * m * (r - gain * m) * (r - gain * m);
            before += (r - m) * (r - m);
        }
    return {gain, std::sqrt(weighted) / sums.mm, std::sqrt(before / sums.n),
            std::sqrt(squares / sums.n)};
}

double rmse_at(std::span<const Observations> cases,
               const std::vector<Constants<double>>& constants) {
    double squares = 0, n = 0;
    for (std::size_t k = 0; k < cases.size(); ++k) {
        const Observations& one = cases[k];
        const auto model = one.picture().indirect<double>(constants[k], one.all_pixels());
        for (std::size_t i = 0; i < model.size(); ++i) {
            const double d = model[i] - one.all_radiance()[i];
            squares += d * d;
            n += 1;
        }
    }
    return std::sqrt(squares / n);
}

}  // namespace plumbline::compare
