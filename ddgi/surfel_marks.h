// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace plumbline::ddgi {

/// What is to be done to a surfel, or was done: a bit of a set.
struct Mark {
    enum Bit : std::uint8_t {
        Placed = 1,   ///< its ray is traced; the others follow
        Lit = 2,      ///< light is measured at it
        Seen = 4,     ///< it looks which probes around it can be seen
        Sourced = 8,  ///< it shows the light of another surfel than before
    };
};

constexpr std::uint8_t any_mark = 0xff;
/// What a surfel calls for that is placed.
constexpr std::uint8_t all_marks = Mark::Placed | Mark::Lit | Mark::Seen;

/// A set of Mark for each surfel and, so that what nothing touches is passed over, their union for
/// each probe. Threads may work on different probes.
class SurfelMarks {
 public:
    /// `per_probe` is a multiple of 8.
    SurfelMarks(std::size_t probes, std::size_t per_probe)
        : per_probe_(per_probe), marks_(probes * per_probe), probe_marks_(probes) {}

    std::size_t probes() const { return probe_marks_.size(); }
    std::size_t per_probe() const { return per_probe_; }

    std::uint8_t of(std::size_t surfel) const { return marks_[surfel]; }
    std::uint8_t of_probe(std::size_t probe) const { return probe_marks_[probe]; }
    /// Those of a probe's surfels, to be changed: join() it then.
    std::span<std::uint8_t> rays_of(std::size_t probe) {
        return {&marks_[probe * per_probe_], per_probe_};
    }
    void add(std::size_t surfel, std::uint8_t marks) { add(surfel / per_probe_, surfel, marks); }
    /// ... of a surfel that is known to be of this probe.
    void add(std::size_t probe, std::size_t surfel, std::uint8_t marks) {
        marks_[surfel] |= marks;
        probe_marks_[probe] |= marks;
    }
    void drop(std::size_t surfel, Mark::Bit mark) {
        marks_[surfel] = static_cast<std::uint8_t>(marks_[surfel] & ~mark);
    }
    /// Brings the union of a probe up to date.
    void join(std::size_t probe);
    /// ... and of all that are marked.
    void join();

    void set_all();
    void clear();

    /// Calls body(first, last) for ranges of probes, from first on and before last, in parallel:
    /// all that have marks, with some hundred marked surfels or more at a time.
    template <typename Body>
    void for_marked(const Body& body) const {
        constexpr std::size_t enough = 256;
        const tbb::blocked_range<std::size_t> all(0, probes());
        tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
            std::size_t first = range.begin();
            std::size_t marked = 0;
            for (std::size_t probe = first; probe < range.end(); ++probe) {
                if (probe_marks_[probe] != 0) marked += count(probe);
                if (marked < enough) continue;
                body(first, probe + 1);
                first = probe + 1;
                marked = 0;
            }
            if (marked > 0) body(first, range.end());
        });
    }
    /// Calls f(surfel) for those of a probe that have one of these marks.
    template <typename Function>
    void for_rays(std::size_t probe, std::uint8_t marks, const Function& f) const {
        if ((probe_marks_[probe] & marks) == 0) return;
        const std::uint64_t all = marks * 0x0101010101010101u;
        for (std::size_t i = probe * per_probe_; i < (probe + 1) * per_probe_; i += sizeof all) {
            std::uint64_t eight = 0;
            std::memcpy(&eight, &marks_[i], sizeof eight);
            if ((eight & all) == 0) continue;
            for (std::size_t k = i; k < i + sizeof eight; ++k) {
                if ((marks_[k] & marks) != 0) f(k);
            }
        }
    }
    /// Of the probes from `first` on and before `last`, the surfels that have this mark.
    void find(std::size_t first, std::size_t last, Mark::Bit mark,
              std::vector<std::size_t>& surfels) const;

 private:
    std::size_t count(std::size_t probe) const;

    std::size_t per_probe_;
    std::vector<std::uint8_t> marks_;
    std::vector<std::uint8_t> probe_marks_;
};

/// Calls body(probe) for each probe, in parallel.
template <typename Body>
void for_probes(std::size_t probes, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, probes),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                          for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
                      });
}

}  // namespace plumbline::ddgi
