// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

namespace plumbline::ddgi {

/// Where the model `irradiance` departs from the light that its probes measured: by default
/// nowhere. The names are what `--set` takes; a switch is 0 or 1.
struct IrradianceSettings {
    /// The share of its last value that a texel keeps at an update; it averages the noise of rays
    /// that turn, and lags behind what moves. At least 0, below 1.
    double hysteresis = 0.;
    /// Every update traces the same spherical Fibonacci rays at every probe, turned at random, and
    /// no ray is kept. Otherwise each probe keeps its own rays, and the cache what they met.
    double turnedRays = 0.;
    /// Texels hold E^(1/g), are blended over time and over the map as such, and their roots between
    /// probes: dark transitions look smoother and come out too dark. 1 or more.
    double perceptualGamma = 1.;
    /// A point is looked for in the distance maps this far off itself, along its normal and towards
    /// who sees it, in spacings. At least 0.
    double normalBias = 0.;
    double viewBias = 0.;
    /// Probes behind a surface fade by ((cos + 1) / 2)^2 + 0.2. Otherwise they do not count.
    double wrapShading = 0.;
    /// Weights w below this count w^3 / t^2. 0 for never; at most 1.
    double crushThreshold = 0.;
    /// Visibility by the moments of distance. Otherwise probes in front of a surface count alike.
    double chebyshev = 1.;
    /// Its exponent: more raises the contrast. 1 or more.
    double visibilityPower = 1.;
    /// No probe counts less than this for what hides it. 0 to 1.
    double leastVisibility = 0.;
    /// How narrow a cone of rays a texel of distances takes: cos^s, s a whole number from 1.
    double depthSharpness = 50.;
    /// Surfels take in this share of the probes' light. 0 to 1.
    double energyPreservation = 1.;
    /// Rays that meet the back of a one-sided surface bring no light, and count with a fifth of
    /// their distance. Otherwise they pass it, as camera rays do.
    double blackBacks = 0.;
    /// Probes a quarter or more of whose rays meet backs do not count: they stand in something.
    double skipInside = 0.;
};

/// The values of [Majercik et al. 2019] and its reference code, and for the biases, the exponent of
/// 5, backs and probes in walls, those of [Majercik et al. 2021].
IrradianceSettings published_irradiance_settings();

/// What `set` asks for; `published` at 1 starts from the published values. Throws UsageError for a
/// name that is not there or a value out of range.
IrradianceSettings irradiance_settings(const std::map<std::string, double>& set);

/// All settings by name.
std::map<std::string, double> named(const IrradianceSettings& settings);

}  // namespace plumbline::ddgi
