// SPDX-License-Identifier: Apache-2.0
#include "compare/shared_samples.h"

#include <fmt/format.h>

#include "scenes/errors.h"

namespace plumbline::compare {
namespace {

std::string entry(const Image& image, const std::string& name) {
    const auto found = image.metadata.find("plumbline:" + name);
    return found == image.metadata.end() ? "" : found->second;
}

}  // namespace

bool share_samples(const Image& a, const Image& b) {
    if (entry(a, "renderer") != "pathtracer") return false;
    for (const char* name : {"renderer", "digest", "frame", "size", "seed"})
        if (entry(a, name) != entry(b, name)) return false;
    return true;
}

void check_independent(const Image& reference, const Image& test, const Halves& halves) {
    const auto check = [](const Image* picture, const Image& other) {
        if (!picture || !share_samples(*picture, other)) return;
        throw ImageError(picture->source,
                         fmt::format("its noise is that of {}: both are of seed {}", other.source,
                                     entry(other, "seed")),
                         "with halves, give each picture a --seed of its own");
    };
    check(&test, reference);
    for (const Image* half : {halves.reference, halves.test}) {
        check(half, reference);
        check(half, test);
    }
    if (halves.test) check(halves.reference, *halves.test);
}

bool variances_overstate(const Image& image) {
    return entry(image, "variance").find("conservative") != std::string::npos;
}

}  // namespace plumbline::compare
