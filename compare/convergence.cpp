// SPDX-License-Identifier: Apache-2.0
#include "compare/convergence.h"

#include <cmath>

#include "scenes/errors.h"

namespace plumbline::compare {

namespace {

constexpr double threshold = 1e-10;
constexpr int most_iterations = 20000;

}  // namespace

double Convergence::larger(double a, double b) {
    const double size = std::abs(b);
    return size <= a ? a : size;
}

bool Convergence::settled(std::span<const double> change, std::span<const double> size) const {
    bool all = true;
    for (std::size_t k = 0; k < change.size(); ++k) {
        if (!std::isfinite(size[k]) || !std::isfinite(change[k]))
            throw FitError("thesis",
                           "the probes' light is not finite at constants tried by the fit",
                           "start from a falloffRegulator below 2 spacing^2");
        all = all && change[k] <= threshold * size[k];
    }
    if (!all && iterations_ >= most_iterations)
        throw FitError("thesis", "the probes did not converge at constants tried by the fit",
                       "start from a falloffRegulator below 2 spacing^2");
    return all;
}

}  // namespace plumbline::compare
