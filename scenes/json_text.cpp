// SPDX-License-Identifier: Apache-2.0
#include "scenes/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "scenes/errors.h"
#include "scenes/nearest_name.h"

namespace plumbline {
namespace {

// Nothing in a scene or a glTF file nests deeper; readers of nested values may then recurse.
constexpr int deepest = 64;

/// "file:line:column" of a byte of the text.
std::string line_and_column(const std::string& text, std::size_t byte, const std::string& source) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
    const auto line = 1 + std::count(text.begin(), end, '\n');
    const auto last_break = std::find(std::make_reverse_iterator(end), text.rend(), '\n');
    return fmt::format("{}:{}:{}", source, line, end - last_break.base() + 1);
}

/// Follows the parser and refuses what the JSON grammar allows but a reader cannot honour.
class Guard {
 public:
    explicit Guard(const std::string& source) : source_(source) {}

    bool operator()(int depth, Json::parse_event_t event, Json& parsed) {
        using Event = Json::parse_event_t;
        if (event == Event::object_start || event == Event::array_start) {
            if (depth >= deepest) {
                fail(fmt::format("is nested more than {} deep", deepest), "a scene needs less");
            }
            levels_.push_back({event == Event::array_start, 0, {}, {}});
        } else if (event == Event::key) {
            Level& level = levels_.back();
            level.key = parsed.get_ref<const std::string&>();
            if (!level.keys.insert(level.key).second) {
                fail("this key stands twice in one object", "keep one");
            }
        } else {
            if (event != Event::value) levels_.pop_back();
            if (!levels_.empty()) ++levels_.back().index;
        }
        return true;
    }

 private:
    struct Level {
        bool array;
        std::size_t index;
        std::string key;
        std::set<std::string> keys;
    };

    [[noreturn]] void fail(const std::string& problem, const std::string& cure) const {
        std::string pointer;
        for (const Level& level : levels_) {
            pointer += '/' + (level.array ? std::to_string(level.index) : level.key);
        }
        throw SceneError(source_ + ": " + pointer, problem, cure);
    }

    const std::string& source_;
    std::vector<Level> levels_;
};

/// What the parser says, without its own name, number and position.
std::string plain_reason(const Json::parse_error& error) {
    const std::string what = error.what();
    const std::size_t reason = what.find(": ", what.find("parse error at"));
    std::string plain = reason == std::string::npos ? what : what.substr(reason + 2);
    // What it last read may be anything; the message stays one line of plain text.
    const auto unprintable = [](char c) { return c < ' ' || c > '~'; };
    std::replace_if(plain.begin(), plain.end(), unprintable, '?');
    return plain;
}

}  // namespace

JsonDocument parse_json(const std::string& text, const std::string& source) {
    try {
        return {source, Json::parse(text, Guard(source))};
    } catch (const Json::parse_error& error) {
        // The parser counts the byte after the last one of the text as its end.
        const std::size_t byte = error.byte == 0 ? 0 : error.byte - 1;
        const std::string place = line_and_column(text, byte, source);
        if (byte >= text.size()) {
            throw SceneError(place, "the file ends in the middle of a value",
                             "it may have been cut off; restore its end");
        }
        throw SceneError(place, plain_reason(error), "correct the JSON here");
    } catch (const Json::out_of_range& error) {
        const std::string what = error.what();
        const std::size_t start = what.find('\'') + 1;
        const std::string number = what.substr(start, what.rfind('\'') - start);
        throw SceneError(line_and_column(text, text.find(number), source),
                         "the number " + in_quotes(number) + " is too large",
                         "it must be finite as a 32-bit float, so below 3.4e38");
    }
}

}  // namespace plumbline
