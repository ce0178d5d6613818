// SPDX-License-Identifier: Apache-2.0
#include "compare/thesis_prediction.h"

#include <ceres/jet.h>

namespace plumbline::compare {

namespace {

constexpr int constant_count = int(constant_names.size());
using Jet = ceres::Jet<double, constant_count>;

}  // namespace

Constants<double> unit_factors(const Observations& from, const Observations& to) {
    const double area = to.picture().lossless_falloff() / from.picture().lossless_falloff();
    return {area, 1, area, area};
}

Constants<double> ThesisPrediction::constants(std::size_t k,
                                              const std::vector<double>& parameters) const {
    Constants<double> constants;
    for (std::size_t c = 0; c < constants.size(); ++c)
        constants[c] = parameters[places_[k][c]] * factors_[k][c];
    return constants;
}

void ThesisPrediction::add_derivatives(std::size_t k, const std::vector<double>& parameters,
                                       std::vector<double>& values, Jacobian& jacobian) const {
    const Constants<double> at = constants(k, parameters);
    Constants<Jet> jets;
    for (int c = 0; c < constant_count; ++c) jets[std::size_t(c)] = Jet(at[std::size_t(c)], c);
    for (std::size_t c = 0; c < jets.size(); ++c) jets[c].v *= factors_[k][c];
    for (const Jet& value :
         cases_[k].picture().indirect<Jet>(jets, cases_[k].pixels(), fits_feedback_)) {
        for (int c = 0; c < constant_count; ++c)
            jacobian(Eigen::Index(values.size()), Eigen::Index(places_[k][std::size_t(c)])) +=
                value.v[c];
        values.push_back(value.a);
    }
}

std::vector<double> ThesisPrediction::predict(const std::vector<double>& parameters,
                                              Jacobian* jacobian) const {
    std::size_t count = 0;
    for (const Observations& one : cases_) count += one.radiance().size();
    if (jacobian) jacobian->setZero(Eigen::Index(count), Eigen::Index(parameters.size()));
    std::vector<double> values;
    values.reserve(count);
    for (std::size_t k = 0; k < cases_.size(); ++k) {
        if (jacobian) {
            add_derivatives(k, parameters, values, *jacobian);
            continue;
        }
        const auto model =
            cases_[k].picture().indirect<double>(constants(k, parameters), cases_[k].pixels());
        values.insert(values.end(), model.begin(), model.end());
    }
    return values;
}

}  // namespace plumbline::compare
