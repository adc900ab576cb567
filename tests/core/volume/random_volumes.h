// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/core/volume/volumes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace burin::test {

/// A copy of the segments of every scanline of a volume, u counting fastest.
class LineCopies {
public:
    LineCopies() = default;
    template <class Volume>
    explicit LineCopies(const Volume& volume) : width_(volume.grid().lineCountU()), depth_(volume.grid().lineCountV()) {
        for (LineIndex line; line.v < depth_; ++line.v)
            for (line.u = 0; line.u < width_; ++line.u) {
                const auto segments = volume.line(line);
                lines_.emplace_back(segments.begin(), segments.end());
            }
    }
    const std::vector<Segment>& at(LineIndex line) const {
        return lines_[static_cast<std::size_t>(line.v) * static_cast<std::size_t>(width_) +
                      static_cast<std::size_t>(line.u)];
    }
    /// Whether all lines are equal, except those for which `mayDiffer(line)` is true.
    template <class Volume, class MayDiffer>
    bool equalsBut(const Volume& volume, MayDiffer mayDiffer) const {
        for (LineIndex line; line.v < depth_; ++line.v)
            for (line.u = 0; line.u < width_; ++line.u)
                if (!mayDiffer(line) && !std::ranges::equal(at(line), volume.line(line))) return false;
        return true;
    }
    template <class Volume>
    bool equals(const Volume& volume) const {
        return equalsBut(volume, [](LineIndex) { return false; });
    }
    RunAmounts amounts() const {
        RunAmounts sum;
        for (const std::vector<Segment>& line : lines_) {
            RunPosition start = 0;
            for (const Segment segment : line) {
                sum.units[segment.property()] += segment.end() - start;
                start = segment.end();
            }
        }
        return sum;
    }

private:
    std::int32_t width_ = 0, depth_ = 0;
    std::vector<std::vector<Segment>> lines_;
};

/// Kinds of random volumes.
enum class Content : int { air, sheets, creases, lattice, noise, mixed };
inline constexpr int contentCount = 6;

/// Fills a volume from a seed.
class RandomContent {
public:
    RandomContent(std::uint32_t seed, Content content) : random_(seed), content_(content) {
        for (double& number : shape_) number = real(-1.0, 1.0);
    }

    void fill(RunVolume& volume) {
        const Grid& grid = volume.grid();
        for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
                (void)volume.setLine(line, segments(line, grid.lineEnd()));
    }
    std::vector<Segment> segments(LineIndex line, RunPosition end) {
        Content content = content_;
        if (content == Content::mixed) content = static_cast<Content>(line.u / 5 % 5);
        switch (content) {
        case Content::sheets:
            return sheets(line, end, 0.0);
        case Content::creases:
            return sheets(line, end, 0.2);
        case Content::lattice:
            return regular(end, 3 + static_cast<RunPosition>(line.u % 7) * 11);
        case Content::noise:
            return noise(end);
        default:
            return {Segment(end, airProperty)};
        }
    }

private:
    double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    std::uint32_t whole(std::uint32_t low, std::uint32_t high) {
        return std::uniform_int_distribution<std::uint32_t>(low, high)(random_);
    }

    /// Materials on top of each other with curved surfaces between; `crease` breaks the surfaces.
    std::vector<Segment> sheets(LineIndex line, RunPosition end, double crease) const {
        std::vector<Segment> segments;
        const double u = line.u / 16.0, v = line.v / 16.0;
        RunPosition before = 0;
        for (PropertyIndex property = 0; property < 4; ++property) {
            double height = (property + 1) / 5.0 + 0.1 * (shape_[property] * u + shape_[property + 4U] * v) +
                            0.03 * std::sin(shape_[property] * u * v + property);
            if (std::fmod(u + property * v + 8.0, 1.7) < 0.6) height += crease;
            const double units = std::clamp(height, 0.0, 1.0) * end;
            const auto at = static_cast<RunPosition>(units);
            if (at <= before || at >= end) continue;
            segments.emplace_back(at, property);
            before = at;
        }
        segments.emplace_back(end, airProperty);
        return segments;
    }
    static std::vector<Segment> regular(RunPosition end, RunPosition step) {
        std::vector<Segment> segments;
        PropertyIndex property = 0;
        for (RunPosition at = step; at < end; at += step, property = property == wax ? airProperty : wax)
            segments.emplace_back(at, property);
        segments.emplace_back(end, property);
        return segments;
    }
    std::vector<Segment> noise(RunPosition end) {
        std::vector<Segment> segments;
        const RunPosition most = whole(1, end);
        for (RunPosition at = 0; at < end;) {
            at = std::min(end, at + whole(1, most));
            segments.emplace_back(at, static_cast<PropertyIndex>(whole(0, 3)));
        }
        return segments;
    }

    std::mt19937 random_;
    Content content_;
    std::array<double, 8> shape_{};
};

/// Any small grid: each side 1 … `side` voxels, any run axis.
inline Grid randomGrid(std::uint32_t seed, std::int32_t side) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<std::int32_t> count(1, side), axis(0, 2);
    std::uniform_real_distribution<double> place(-100.0, 100.0);
    const glm::dvec3 low(place(random), place(random), place(random));
    return *Grid::make(low, 0.01 + std::abs(place(random)), {count(random), count(random), count(random)},
                       static_cast<RunAxis>(axis(random)));
}

} // namespace burin::test
