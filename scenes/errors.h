// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace plumbline {

/// Bad input, told in one line: file, place in it, what is wrong, what would be right.
///
/// Thrown anywhere, caught once in plumbline.cpp, which prints the line and exits with 2.
class InputError : public std::runtime_error {
 public:
    /// `where` is a file, or a file and a place in it ("scene.json: /objects/3/material").
    InputError(const std::string& where, const std::string& problem, const std::string& cure);
    explicit InputError(const std::string& line) : std::runtime_error(line) {}
};

/// A scene that cannot be read, or that makes no sense.
class SceneError : public InputError {
    using InputError::InputError;
};

/// An image that cannot be read or written.
class ImageError : public InputError {
    using InputError::InputError;
};

/// A fit whose question has no answer (no pixels, constants that do not exist).
class FitError : public InputError {
    using InputError::InputError;
};

/// A command line that asks for something that does not exist.
class UsageError : public InputError {
    using InputError::InputError;
};

}  // namespace plumbline
