// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace plumbline {

/// Spaces and whatever else may not stand in a URI [RFC 3986] as %20 and its like.
std::string percent_encoded(const std::string& text);
/// Undoes percent_encoded(); a % that two hexadecimal digits do not follow stays.
std::string percent_decoded(const std::string& uri);

}  // namespace plumbline
