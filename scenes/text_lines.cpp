// SPDX-License-Identifier: Apache-2.0
#include "scenes/text_lines.h"

#include <charconv>
#include <cmath>

#include "scenes/errors.h"
#include "scenes/input_files.h"
#include "scenes/nearest_name.h"

namespace plumbline {

TextLines::TextLines(const std::filesystem::path& path)
    : source_(path.string()), text_(read_bytes(path)) {}

bool TextLines::next() {
    words_.clear();
    while (words_.empty() && at_ < text_.size()) {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        std::string_view line(text_.data() + at_, end - at_);
        line = line.substr(0, line.find('#'));
        at_ = end + 1;
        ++line_;
        constexpr std::string_view spaces = " \t\r";
        for (std::size_t from = line.find_first_not_of(spaces); from != line.npos;) {
            const std::size_t to = std::min(line.find_first_of(spaces, from), line.size());
            words_.push_back(line.substr(from, to - from));
            from = line.find_first_not_of(spaces, to);
        }
    }
    return !words_.empty();
}

std::string TextLines::rest() const {
    if (words_.size() < 2) fail("says no name", "write one behind the first word");
    const char* end = words_.back().data() + words_.back().size();
    return {words_[1].data(), end};
}

float TextLines::number(std::size_t i) const {
    if (i >= words_.size()) fail("has too few numbers", "write " + std::to_string(i) + " or more");
    const std::string_view word = words_[i];
    float value = 0.f;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
    if (read.ec != std::errc() || read.ptr != word.data() + word.size() || !std::isfinite(value)) {
        fail(in_quotes(word) + " is no finite number", "write one such as 0.5");
    }
    return value;
}

void TextLines::fail(const std::string& problem, const std::string& cure) const {
    throw SceneError(source_ + ":" + std::to_string(line_), problem, cure);
}

}  // namespace plumbline
