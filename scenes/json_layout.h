// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace plumbline {

/// JSON as a person would write it: values that fit on a line stay on it, others get a line an
/// element, four spaces deeper.
std::string laid_out(const nlohmann::ordered_json& json, std::size_t indent = 0);

}  // namespace plumbline
