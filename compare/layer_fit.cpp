// SPDX-License-Identifier: Apache-2.0
#include "compare/layer_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/find_layer.h"
#include "compare/lattice.h"
#include "compare/noise.h"
#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

using Channels = std::array<std::span<const float>, 3>;

/// Sums of layers: the derivative in a gain is the layer.
class GainPrediction : public Prediction {
 public:
    explicit GainPrediction(Jacobian layers) : layers_(std::move(layers)) {}
    std::vector<double> predict(const std::vector<double>& gains,
                                Jacobian* jacobian) const override {
        const Eigen::VectorXd sum =
            layers_ * Eigen::Map<const Eigen::VectorXd>(gains.data(), Eigen::Index(gains.size()));
        if (jacobian) *jacobian = layers_;
        return {sum.begin(), sum.end()};
    }

 private:
    Jacobian layers_;
};

/// The reference and the layers, finite in all of them.
struct Passes {
    Channels reference;
    std::optional<Channels> variance;
    std::vector<Channels> layers;
    std::vector<std::uint32_t> pixels;
};

Passes passes_of(const std::vector<GainLayer>& layers, const Image& reference,
                 const LayerFitSettings& settings) {
    Passes passes{find_layer(reference, settings.layer).channels,
                  variances_of(reference, settings.layer),
                  {},
                  {}};
    std::vector<Channels> all{passes.reference};
    if (passes.variance) all.push_back(*passes.variance);
    for (const GainLayer& one : layers) {
        if (one.image->width() != reference.width() || one.image->height() != reference.height())
            throw ImageError(
                one.image->source,
                fmt::format("is {}x{} but the reference is {}x{}", one.image->width(),
                            one.image->height(), reference.width(), reference.height()),
                "give all layers at the reference's size");
        passes.layers.push_back(find_layer(*one.image, one.layer).channels);
        all.push_back(passes.layers.back());
    }
    const auto finite = [&](std::size_t i) {
        return std::all_of(all.begin(), all.end(), [i](const Channels& channels) {
            return std::all_of(channels.begin(), channels.end(),
                               [i](const auto& values) { return std::isfinite(values[i]); });
        });
    };
    for (std::size_t i = 0; i < reference.pixels(); ++i)
        if (finite(i)) passes.pixels.push_back(std::uint32_t(i));
    return passes;
}

Observed observed_of(const Passes& passes, const std::vector<std::uint32_t>& pixels,
                     const Lattice& lattice) {
    Observed observed;
    for (std::uint32_t i : pixels)
        for (std::size_t c = 0; c < 3; ++c) {
            observed.values.push_back(double(passes.reference[c][i]));
            observed.variance.push_back(passes.variance ? double((*passes.variance)[c][i]) : 0);
            observed.tile.push_back(lattice.tile(i));
        }
    keep_variances_positive(observed.values, observed.variance);
    return observed;
}

Jacobian layers_at(const Passes& passes, const std::vector<std::uint32_t>& pixels) {
    Jacobian layers(Eigen::Index(pixels.size() * 3), Eigen::Index(passes.layers.size()));
    for (std::size_t k = 0; k < passes.layers.size(); ++k)
        for (std::size_t i = 0; i < pixels.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                layers(Eigen::Index(i * 3 + c), Eigen::Index(k)) =
                    double(passes.layers[k][c][pixels[i]]);
    return layers;
}

/// The error over all pixels of gains, and sums that the best gain on top of them needs.
struct Errors {
    double squares = 0, mm = 0, mr = 0, values = 0;
    double rmse() const { return std::sqrt(squares / values); }
};

Errors errors_at(const Passes& passes, const std::vector<double>& gains) {
    Errors errors;
    for (std::uint32_t i : passes.pixels)
        for (std::size_t c = 0; c < 3; ++c) {
            double model = 0;
            for (std::size_t k = 0; k < gains.size(); ++k)
                model += gains[k] * double(passes.layers[k][c][i]);
            const double r = double(passes.reference[c][i]);
            errors.squares += (model - r) * (model - r);
            errors.mm += model * model;
            errors.mr += model * r;
            errors.values += 1;
        }
    return errors;
}

std::vector<Parameter> gains_of(const std::vector<GainLayer>& layers,
                                const LayerFitSettings& settings) {
    if (!(settings.lower < settings.upper))
        throw UsageError("--bounds", "the lower bound is not below the upper", "give LOW,HIGH");
    std::vector<Parameter> gains;
    for (const GainLayer& one : layers)
        gains.push_back({one.name, 1, settings.lower, settings.upper, true, 1});
    return gains;
}

}  // namespace

FitResult fit_layers(const std::vector<GainLayer>& layers, const Image& reference,
                     const LayerFitSettings& settings) {
    const Passes passes = passes_of(layers, reference, settings);
    const Lattice lattice(reference.width(), reference.height());
    std::vector<std::uint32_t> pixels;
    for (std::uint32_t i : passes.pixels)
        if (lattice.fitted(i)) pixels.push_back(i);
    if (pixels.empty())
        throw FitError(reference.source, "no pixel is finite in the reference and all layers",
                       "there is nothing to fit to");
    const Observed observed = observed_of(passes, pixels, lattice);
    const GainPrediction prediction(layers_at(passes, pixels));
    const std::vector<Parameter> gains = gains_of(layers, settings);
    const auto judge_at = [&](const std::vector<double>& at, double misfit_variance) {
        return judge(whitened(prediction, observed, misfit_variance, settings.loss, at), observed,
                     gains, at, Together::Add);
    };
    const std::vector<double> ones(layers.size(), 1.0);
    const Solution solution = solve(prediction, observed, gains, judge_at(ones, 0).redundant,
                                    settings.loss, settings.watch);
    const Identifiability verdict = judge_at(solution.parameters, solution.misfit_variance);

    FitResult result{};
    result.model = "layers";
    result.scenes = {reference.source};
    for (std::size_t k = 0; k < gains.size(); ++k) {
        result.constants.push_back({gains[k].name, solution.parameters[k],
                                    verdict.standard_error[k], verdict.identifiable[k], "",
                                    verdict.standard_error_covariance[k],
                                    verdict.standard_error_bootstrap[k]});
    }
    const Errors before = errors_at(passes, ones);
    result.rmse_before = before.rmse();
    result.rmse_after = errors_at(passes, solution.parameters).rmse();
    result.gain = before.mr / before.mm;
    result.gain_standard_error = std::numeric_limits<double>::quiet_NaN();
    result.rmse_gain = errors_at(passes, std::vector<double>(layers.size(), result.gain)).rmse();
    result.reduced_chi_square =
        passes.variance
            ? solution.chi_square / (double(observed.values.size()) - double(verdict.known))
            : std::numeric_limits<double>::quiet_NaN();
    result.notes = verdict.notes;
    if (!passes.variance)
        result.notes.push_back("the reference has no variances: its noise counts as misfit");
    add_bound_notes(gains, solution.parameters, result.notes);
    result.combinations = verdict.combinations;
    result.misfit = std::sqrt(solution.misfit_variance);
    result.steps = solution.steps;
    result.converged = solution.converged;
    return result;
}

}  // namespace plumbline::compare
