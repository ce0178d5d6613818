// SPDX-License-Identifier: Apache-2.0
#include "tests/reports/page_parts.h"

#include <Imath/half.h>
#include <zlib.h>

#include <catch2/catch.hpp>
#include <cmath>

namespace plumbline::reports {

std::string without_scripts(const std::string& html) {
    std::string rest;
    std::size_t at = 0;
    for (std::size_t open; (open = html.find("<script", at)) != std::string::npos;) {
        rest += html.substr(at, html.find('>', open) + 1 - at);
        at = html.find("</script>", open);
    }
    return rest + html.substr(at);
}

std::string script_text(const std::string& html, const std::string& id) {
    const std::size_t element = html.find("id=\"" + id + "\"");
    REQUIRE(element != std::string::npos);
    const std::size_t begin = html.find('>', element) + 1;
    return html.substr(begin, html.find("</script>", begin) - begin);
}

nlohmann::json page_json(const std::string& html) {
    return nlohmann::json::parse(script_text(html, "report-data"));
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

std::vector<unsigned char> bytes_from_base64(const std::string& text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<unsigned char> bytes;
    unsigned bits = 0;
    int held = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6 | static_cast<unsigned>(digits.find(c));
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes.push_back(static_cast<unsigned char>(bits >> held & 0xff));
    }
    return bytes;
}

std::vector<float> unpacked(const std::string& base64, int width, int exponent) {
    const std::vector<unsigned char> packed = bytes_from_base64(base64);
    constexpr uLongf room = 1 << 20;
    std::vector<unsigned char> bytes(room);
    uLongf size = room;
    REQUIRE(uncompress(bytes.data(), &size, packed.data(), packed.size()) == Z_OK);
    const std::size_t values = size / 2;
    std::vector<float> floats;
    for (std::size_t i = 0; i < values; ++i) {
        half h;
        unsigned sum = 0;
        for (std::size_t k = i - i % static_cast<std::size_t>(width); k <= i; ++k)
            sum += static_cast<unsigned>(bytes[k] << 8 | bytes[values + k]);
        h.setBits(static_cast<unsigned short>(sum & 0xffff));
        floats.push_back(std::ldexp(static_cast<float>(h), exponent));
    }
    return floats;
}

}  // namespace plumbline::reports
