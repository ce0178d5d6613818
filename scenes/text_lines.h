// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// Walks through a text file of lines of words, as OBJ and MTL are; # starts a comment.
class TextLines {
 public:
    /// Throws SceneError if the file cannot be read.
    explicit TextLines(const std::filesystem::path& path);

    /// Goes to the next line that has words; false at the end.
    bool next();
    /// The words of the line, the first of which says what it is.
    const std::vector<std::string_view>& words() const { return words_; }
    /// All of the line behind its first word: names may have spaces.
    std::string rest() const;
    /// Word `i` as a finite number.
    float number(std::size_t i) const;
    /// Throws SceneError that names file and line.
    [[noreturn]] void fail(const std::string& problem, const std::string& cure) const;

 private:
    std::string source_;
    std::string text_;
    std::size_t at_ = 0;
    int line_ = 0;
    std::vector<std::string_view> words_;
};

}  // namespace plumbline
