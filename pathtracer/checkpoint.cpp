// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/checkpoint.h"

#include <fmt/core.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "pathtracer/digest.h"
#include "scenes/errors.h"
#include "scenes/number_pair.h"

namespace plumbline::pathtracer {
namespace {

namespace fs = std::filesystem;

const std::string format_line = "plumbline checkpoint 2";

// Written and read as bytes, by one program on one kind of machine (see provenance).
static_assert(std::is_trivially_copyable_v<PixelEstimate>);

glm::ivec2 size_in(const Provenance& provenance) {
    return parsed_pair(provenance.at("plumbline:size"), 'x').value();
}

/// Calls visit(span) for the pixels of each row of each tile of the shard that `provenance` names.
template <typename Pixels, typename Visit>
void for_each_row(const Provenance& provenance, Pixels& pixels, const Visit& visit) {
    const glm::ivec2 size = size_in(provenance);
    const auto shard = provenance.find("plumbline:shard");
    const Tiles tiles(size.x, size.y);
    for (const int tile :
         tiles.of(shard == provenance.end() ? Shard{} : parsed_shard("shard", shard->second))) {
        const Tiles::Bounds bounds = tiles.bounds(tile);
        for (int y = bounds.top; y < bounds.bottom; ++y) {
            const auto row = std::size_t(y) * std::size_t(size.x) + std::size_t(bounds.left);
            visit(std::span(pixels).subspan(row, std::size_t(bounds.right - bounds.left)));
        }
    }
}

std::string digest_of(const Provenance& provenance, const Gathered& gathered) {
    Digest digest;
    for_each_row(provenance, gathered.pixels,
                 [&](std::span<const PixelEstimate> row) { digest.add(row); });
    digest.add(std::span<const std::uint64_t>(gathered.rays));
    digest.add(std::span<const double>(gathered.allocation.shares));
    return fmt::format("{:016x}", digest.value());
}

nlohmann::json head_of(const Checkpoint& checkpoint, const Provenance& provenance) {
    const auto& [pixels, non_finite, rays, samples, allocation] = checkpoint.gathered;
    nlohmann::json head = {{"provenance", provenance},
                           {"pixels", pixels.size()},
                           {"pixel_bytes", sizeof(PixelEstimate)},
                           {"seconds", checkpoint.seconds},
                           {"rays", rays},
                           {"samples", samples},
                           {"pilot", allocation.pilot},
                           {"shares", allocation.shares},
                           {"non_finite", non_finite.samples},
                           {"digest", digest_of(provenance, checkpoint.gathered)}};
    if (non_finite.first) head["first_non_finite"] = {non_finite.first->x, non_finite.first->y};
    return head;
}

/// One name for all processes, unlike write_whole()'s: kills leave one such file at most.
fs::path fresh_beside(const fs::path& file) { return file.string() + ".new"; }

ImageError damaged(const fs::path& file) {
    return {file.string(), "is not a whole checkpoint", "delete it to start the render again"};
}

Checkpoint read_after_head(std::istream& stream, const nlohmann::json& head, const fs::path& file,
                           const Provenance& provenance) {
    Checkpoint checkpoint;
    auto& [pixels, non_finite, rays, samples, allocation] = checkpoint.gathered;
    const glm::ivec2 size = size_in(provenance);
    const std::size_t area = std::size_t(size.x) * std::size_t(size.y);
    if (head.at("pixel_bytes") != sizeof(PixelEstimate) || head.at("pixels") != area)
        throw damaged(file);
    pixels.resize(area);
    rays = head.at("rays").get<std::vector<std::uint64_t>>();
    samples = head.at("samples");
    allocation.pilot = head.at("pilot");
    allocation.shares = head.at("shares").get<std::vector<double>>();
    non_finite.samples = head.at("non_finite");
    if (head.contains("first_non_finite")) {
        const auto& first = head["first_non_finite"];
        non_finite.first = glm::ivec2(int(first.at(0)), int(first.at(1)));
    }
    checkpoint.seconds = head.at("seconds");
    for_each_row(provenance, pixels, [&](std::span<PixelEstimate> row) {
        stream.read(reinterpret_cast<char*>(row.data()),
                    static_cast<std::streamsize>(row.size_bytes()));
    });
    if (!stream || digest_of(provenance, checkpoint.gathered) != head.at("digest"))
        throw damaged(file);
    return checkpoint;
}

}  // namespace

void write_checkpoint(const fs::path& file, const Checkpoint& checkpoint,
                      const Provenance& provenance) {
    const fs::path fresh = fresh_beside(file);
    std::error_code error;
    if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
    std::ofstream stream(fresh, std::ios::binary);
    stream << format_line << '\n' << head_of(checkpoint, provenance).dump() << '\n';
    for_each_row(provenance, checkpoint.gathered.pixels, [&](std::span<const PixelEstimate> row) {
        stream.write(reinterpret_cast<const char*>(row.data()),
                     static_cast<std::streamsize>(row.size_bytes()));
    });
    stream.close();
    if (stream) fs::rename(fresh, file, error);
    if (!stream || error) {
        fs::remove(fresh, error);
        throw ImageError(file.string(), "the checkpoint cannot be written",
                         "check that the folder may be written to and has room");
    }
}

Checkpoint read_checkpoint(const fs::path& file, const Provenance& provenance) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw ImageError(file.string(), "cannot be read", "check its permissions");
    std::string format, head_line;
    std::getline(stream, format);
    std::getline(stream, head_line);
    const nlohmann::json head = nlohmann::json::parse(head_line, nullptr, false);
    if (format != format_line || !head.is_object()) throw damaged(file);
    try {
        const Provenance its = head.at("provenance");
        const auto shard_of = [](const Provenance& p) {
            const auto found = p.find("plumbline:shard");
            return found == p.end() ? std::string("1/1") : found->second;
        };
        std::optional<std::string> other = difference(its, provenance);
        if (!other && shard_of(its) != shard_of(provenance)) {
            other = fmt::format("its shard is '{}', not '{}'", shard_of(its), shard_of(provenance));
        }
        if (other) {
            throw ImageError(file.string(), *other,
                             "give the scene and options of the interrupted render, or delete it");
        }
        return read_after_head(stream, head, file, provenance);
    } catch (const nlohmann::json::exception&) {
        throw damaged(file);
    }
}

void remove_checkpoint(const fs::path& file) {
    std::error_code not_there;
    fs::remove(file, not_there);
    fs::remove(fresh_beside(file), not_there);
}

}  // namespace plumbline::pathtracer
