// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace plumbline::ddgi {

/// A line that tells what names there are, led by the nearest to what was typed if it is a likely
/// slip: "did you mean 'thesis'? There are thesis, conserving".
std::string choices(const std::string& typed, const std::vector<std::string>& names);

}  // namespace plumbline::ddgi
