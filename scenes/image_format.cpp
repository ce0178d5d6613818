// SPDX-License-Identifier: Apache-2.0
#include "scenes/image_format.h"

#include <array>
#include <fstream>
#include <string_view>

namespace plumbline {
namespace {

using namespace std::string_view_literals;

struct Signature {
    std::string_view first_bytes;
    const char* format;
};

constexpr Signature signatures[] = {
    {"\x76\x2f\x31\x01"sv, "openexr"},
    {"#?RADIANCE"sv, "hdr"},
    {"#?RGBE"sv, "hdr"},
    {"\x89PNG\r\n\x1a\n"sv, "png"},
    {"\xff\xd8\xff"sv, "jpeg"},
    {"II*\0"sv, "tiff"},
    {"MM\0*"sv, "tiff"},
    {"II+\0"sv, "tiff"},
    {"MM\0+"sv, "tiff"},
    {"BM"sv, "bmp"},
};

bool is_netpbm(std::string_view head) {
    return head.size() > 2 && head[0] == 'P' && "123456fF"sv.find(head[1]) != head.npos &&
           " \t\r\n#"sv.find(head[2]) != head.npos;
}

bool is_webp(std::string_view head) {
    return head.starts_with("RIFF") && head.size() >= 12 && head.substr(8, 4) == "WEBP";
}

}  // namespace

std::string image_format(const std::filesystem::path& path) {
    std::array<char, 16> bytes;
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), bytes.size());
    const std::string_view head(bytes.data(), static_cast<std::size_t>(file.gcount()));
    for (const Signature& signature : signatures) {
        if (head.starts_with(signature.first_bytes)) return signature.format;
    }
    if (is_netpbm(head)) return "pnm";
    if (is_webp(head)) return "webp";
    return path.extension() == ".tga" ? "targa" : "";
}

}  // namespace plumbline
