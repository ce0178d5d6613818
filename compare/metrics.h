// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "compare/layer_pair.h"

namespace plumbline::compare {

/// Error of a test layer t against a reference layer r, d = t - r.
///
/// Means run over all finite pixels and the three channels, on linear values, unless said
/// otherwise; the field's tools give one name to several formulas, so these are:
struct Metrics {
    double bias = 0;     ///< mean d; the sign says too bright (+) or too dark (-)
    double mae = 0;      ///< mean |d|
    double rmse = 0;     ///< sqrt(mean d^2)
    double relmse = 0;   ///< mean d^2 / (r^2 + relmse_epsilon) [Rousselle et al. 2011]
    double smape = 0;    ///< mean |d| / (|r| + |t| + smape_epsilon), in [0,1) [Vogels et al. 2018]
    double psnr_db = 0;  ///< 10 log10(peak^2 / mean d^2), peak = largest r; infinite if d = 0
    std::optional<double> ssim;  ///< see ssim.h; none if smaller than its window
    std::optional<double> flip;  ///< see flip.h; none if the reference has no light
};

/// Keeps relmse finite on black reference pixels [Rousselle et al. 2011].
inline constexpr double relmse_epsilon = 0.01;
/// Keeps smape finite where both are black [Vogels et al. 2018].
inline constexpr double smape_epsilon = 0.01;

/// Sums over values from which the metrics follow, so that any part of a picture has its own.
struct ErrorSums {
    double values = 0;  ///< how many were added
    double signed_error = 0, absolute = 0, square = 0, relative = 0, symmetric = 0;
    double peak = 0;  ///< the largest reference value, at least 0

    void add(double r, double t);
    void add(const ErrorSums& other);
    /// All of Metrics but ssim and flip.
    Metrics metrics() const;
};

/// The sums of each channel.
std::array<ErrorSums, 3> channel_errors(const LayerPair& pair);

/// All of Metrics but ssim and flip.
Metrics pixel_metrics(const LayerPair& pair);

/// A metric by its name in the JSON, with its formula in plain text for tables and pages.
struct MetricDescription {
    std::string name;
    std::string formula;
    std::optional<double> (*value)(const Metrics&);
};

/// Every metric, in the order of Metrics.
const std::vector<MetricDescription>& metric_descriptions();

}  // namespace plumbline::compare
