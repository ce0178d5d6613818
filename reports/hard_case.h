// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ddgi/model.h"
#include "ddgi/render.h"
#include "pathtracer/render.h"

namespace plumbline::reports {

/// One claim about one renderer, measured: it holds if `lowest` <= `measured` <= `highest`.
struct Finding {
    std::string renderer;  ///< "pathtracer", a probe model's name, or "inspect"
    std::string claim;
    double measured;
    double lowest;
    double highest;
    bool holds() const { return measured >= lowest && measured <= highest; }  // false for NaN
};

/// Renders for a hard case and gathers what was found.
class Trial {
 public:
    static constexpr const char* pathtracer = "pathtracer";

    /// The truth; a claim that all its values are finite and none negative comes by itself.
    pathtracer::RenderResult truth(const Scene& scene, int frame = 0,
                                   const pathtracer::RenderOptions& options = {});
    /// What a probe model shows, with the same claim.
    ddgi::DdgiResult probes(const Scene& scene, const std::string& model, int frame = 0,
                            ddgi::DdgiOptions options = {});

    void near(const std::string& renderer, const std::string& claim, double measured,
              double expected, double tolerance);
    void within(const std::string& renderer, const std::string& claim, double measured,
                double lowest, double highest);
    void claim(const std::string& renderer, const std::string& what, bool holds);

    const std::vector<Finding>& findings() const { return findings_; }

 private:
    void all_finite(const std::string& renderer, const Image& image);

    std::vector<Finding> findings_;
};

/// A case that breaks renderers, and the law that it must meet all the same.
struct HardCase {
    std::string group;  ///< of related cases, one word
    std::string name;
    std::string law;  ///< what must hold, and where the tolerance comes from
    std::function<void(Trial&)> run;
};

/// All cases, group by group.
std::vector<HardCase> hard_cases();

/// The cases of each group, appended.
void add_scale_cases(std::vector<HardCase>& cases);
void add_light_cases(std::vector<HardCase>& cases);
void add_geometry_cases(std::vector<HardCase>& cases);
void add_energy_cases(std::vector<HardCase>& cases);
void add_probe_cases(std::vector<HardCase>& cases);
void add_motion_cases(std::vector<HardCase>& cases);
void add_statistics_cases(std::vector<HardCase>& cases);

/// Mean radiance over pixels and channels.
double mean_radiance(const Image& image);
/// The standard error of mean_radiance(), from the variance layer.
double mean_error(const Image& image);
/// The largest deviation of any radiance value from `expected`.
double largest_deviation(const Image& image, double expected);
/// Whether both hold the same channels with the same bytes.
bool same_pixels(const Image& a, const Image& b);

}  // namespace plumbline::reports
