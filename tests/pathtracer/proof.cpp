// SPDX-License-Identifier: Apache-2.0
// The tables of `plumbline prove`.
#include "pathtracer/proof.h"

#include <catch2/catch.hpp>

#include "pathtracer/statistics.h"

namespace plumbline::pathtracer {

TEST_CASE("closed forms are met within their standard errors by every kernel",
          "[pathtracer][analytic]") {
    const std::vector<ClosedForm> forms = closed_forms();
    for (const ClosedForm& form : forms) {
        INFO(form.name << ", " << form.formula << ", " << form.source);
        const Measured found = measure(form, 800);
        CHECK(std::abs(found.z) < sidak_limit(int(forms.size())));
        // So that two percent more or less would be found out.
        CHECK(found.standard_error < .004 * form.expected);
        CHECK(found.kernels > 0);
        CHECK(found.same_bits);
    }
}

TEST_CASE("techniques and roulette agree in every pixel and samplers follow their densities",
          "[pathtracer][statistics]") {
    for (const auto& findings : {agreements(), distributions()}) {
        for (const Finding& finding : findings) {
            INFO(finding.name << ": " << finding.z << " of " << finding.limit);
            CHECK(finding.holds());
        }
    }
}

}  // namespace plumbline::pathtracer
