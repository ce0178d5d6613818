// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <string>

#include "pathtracer/provenance.h"
#include "pathtracer/tiles.h"
#include "scenes/errors.h"

namespace plumbline::pathtracer {
namespace {

/// Puts shards together as they come.
class Merger {
 public:
    void add(const std::filesystem::path& file) {
        Image part = read_image(file);
        const Shard shard = shard_of(part);
        if (!whole_) {
            whole_.emplace(part.width(), part.height());
            whole_->source = part.source;
            for (const std::string& name : part.channel_names()) whole_->channel(name);
            std::copy_if(part.metadata.begin(), part.metadata.end(),
                         std::inserter(whole_->metadata, whole_->metadata.end()),
                         [](const auto& entry) { return entry.first.starts_with("plumbline:"); });
            whole_->metadata.erase("plumbline:shard");
            sources_.resize(std::size_t(shard.count));
        }
        check_same_render(part, shard);
        std::string& source = sources_[std::size_t(shard.index - 1)];
        if (!source.empty()) {
            throw ImageError(part.source,
                             fmt::format("is shard {}, as is {}", shard_text(shard), source),
                             "give every shard once");
        }
        source = part.source;
        copy_tiles(part, shard);
        seconds_ += std::strtod(part.metadata.at("plumbline:seconds").c_str(), nullptr);
    }

    Image finished() && {
        std::vector<std::size_t> missing;
        for (std::size_t i = 0; i < sources_.size(); ++i) {
            if (sources_[i].empty()) missing.push_back(i + 1);
        }
        if (!missing.empty()) {
            throw UsageError("merge",
                             fmt::format("of {} shards these are missing: {}", sources_.size(),
                                         fmt::join(missing, ", ")),
                             "render and give them too");
        }
        whole_->metadata["plumbline:seconds"] = fmt::format("{:.3f}", seconds_);
        return std::move(*whole_);
    }

 private:
    static Shard shard_of(const Image& part) {
        const auto text = part.metadata.find("plumbline:shard");
        if (text != part.metadata.end() && part.metadata.contains("plumbline:seconds")) {
            const Shard shard = parsed_shard(part.source, text->second);
            if (shard.count <= Tiles(part.width(), part.height()).count()) return shard;
        }
        throw ImageError(part.source, "is not a shard of a render",
                         "give files that 'plumbline render --shard I/N' wrote");
    }

    void check_same_render(const Image& part, const Shard& shard) const {
        std::optional<std::string> other = difference(part.metadata, whole_->metadata);
        if (!other && std::size_t(shard.count) != sources_.size()) {
            other = fmt::format("it is one of {} shards, not of {}", shard.count, sources_.size());
        }
        const bool fits = part.width() == whole_->width() && part.height() == whole_->height() &&
                          part.channel_names() == whole_->channel_names();
        if (!other && !fits) other = "its size or channels are others";
        if (!other) return;
        throw ImageError(part.source, fmt::format("{}, as in {}", *other, whole_->source),
                         "give the shards of one render");
    }

    void copy_tiles(const Image& part, const Shard& shard) {
        const Tiles tiles(part.width(), part.height());
        const std::vector<int> own = tiles.of(shard);
        const auto width = static_cast<std::size_t>(part.width());
        for (const std::string& name : part.channel_names()) {
            const std::span<const float> from = part.channel(name);
            const std::span<float> to = whole_->channel(name);
            for (const int tile : own) {
                const Tiles::Bounds bounds = tiles.bounds(tile);
                for (int y = bounds.top; y < bounds.bottom; ++y) {
                    const auto row = std::size_t(y) * width + std::size_t(bounds.left);
                    const auto length = std::size_t(bounds.right - bounds.left);
                    std::copy_n(&from[row], length, &to[row]);
                }
            }
        }
    }

    std::optional<Image> whole_;
    std::vector<std::string> sources_;  // of shard i + 1; empty while it is missing
    double seconds_ = 0.;
};

}  // namespace

Image merge(const std::vector<std::filesystem::path>& files) {
    Merger merger;
    for (const std::filesystem::path& file : files) merger.add(file);
    return std::move(merger).finished();
}

}  // namespace plumbline::pathtracer
