// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/line_count.h"

#include "core/base/vectorised.h"

#include <cstring>

namespace burin {

namespace {

constexpr std::uint32_t propertyBits = 8, properties = 0xff;
static_assert(linesPerBrick * (std::uint64_t{1} << (32 - propertyBits)) < std::uint64_t{1} << 32,
              "the ends of a brick's lines can be added up in 32 bits");

BURIN_INLINE Words wordsAt(const Segment* segments) noexcept {
    Words words;
    std::memcpy(&words, segments, sizeof words);
    return words;
}

/// Consecutive lines of a brick with the same properties: the ends of each segment are summed over all of them, eight
/// segments side by side.
class AlikeLines {
public:
    static constexpr std::uint32_t mostSegments = 2 * lanes;

    BURIN_INLINE void start(const Segment* line, std::uint32_t count) noexcept {
        const Words place{0, 1, 2, 3, 4, 5, 6, 7}, kept = Words{} + properties;
        count_ = count;
        for (std::uint32_t i = 0; i < 2; ++i) {
            example_[i] = wordsAt(line + i * lanes);
            compared_[i] = kept & reinterpret_cast<Words>(place + i * lanes < count);
            sums_[i] = Words{};
        }
    }
    BURIN_INLINE bool isLike(const Segment* line, std::uint32_t count) const noexcept {
        const Words unlike =
            ((wordsAt(line) ^ example_[0]) & compared_[0]) | ((wordsAt(line + lanes) ^ example_[1]) & compared_[1]);
        return count == count_ && !anyOf(reinterpret_cast<Integers>(unlike != 0));
    }
    BURIN_INLINE void add(const Segment* line) noexcept {
        sums_[0] += wordsAt(line) >> propertyBits;
        sums_[1] += wordsAt(line + lanes) >> propertyBits;
    }
    BURIN_INLINE void addTo(RunAmounts& amounts) const noexcept {
        std::uint32_t before = 0;
        for (std::uint32_t i = 0; i < count_; ++i) {
            const std::uint32_t sum = sums_[i / lanes][i % lanes];
            amounts.units[example_[i / lanes][i % lanes] & properties] += sum - before;
            before = sum;
        }
    }

private:
    Words example_[2], compared_[2], sums_[2];
    std::uint32_t count_ = 0;
};

} // namespace

void addLine(std::span<const Segment> line, RunAmounts& amounts) noexcept {
    RunPosition start = 0;
    for (const Segment segment : line) {
        amounts.units[segment.property()] += segment.end() - start;
        start = segment.end();
    }
}

BURIN_VECTORISED void addLines(std::span<const Segment> segments,
                               std::span<const std::uint32_t, linesPerBrick + 1> offsets,
                               RunAmounts& amounts) noexcept {
    const Segment* const first = segments.data();
    for (std::size_t line = 0; line < linesPerBrick;) {
        const auto countOf = [&](std::size_t i) { return offsets[i + 1] - offsets[i]; };
        const auto isInReach = [&](std::size_t i) { return offsets[i] + AlikeLines::mostSegments <= segments.size(); };
        if (countOf(line) > AlikeLines::mostSegments || !isInReach(line)) {
            addLine(segments.subspan(offsets[line], countOf(line)), amounts);
            ++line;
            continue;
        }
        AlikeLines alike;
        alike.start(first + offsets[line], countOf(line));
        do alike.add(first + offsets[line]);
        while (++line < linesPerBrick && isInReach(line) && alike.isLike(first + offsets[line], countOf(line)));
        alike.addTo(amounts);
    }
}

} // namespace burin
