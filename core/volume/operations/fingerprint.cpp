// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/fingerprint.h"

#include "core/base/checksum.h"
#include "core/base/parallel.h"

#include <array>
#include <bit>
#include <charconv>
#include <vector>

namespace burin {

namespace {

/// Lowest byte first on every machine.
template <class Number>
void append(std::string& bytes, Number number) {
    for (std::size_t i = 0; i < sizeof number; ++i)
        bytes.push_back(static_cast<char>((static_cast<std::uint64_t>(number) >> (8 * i)) & 0xff));
}

/// Grid and material ids, which define the meaning of the runs' numbers.
std::string headOf(const Grid& grid, const PropertyList& properties) {
    std::string head;
    for (int axis = 0; axis < 3; ++axis) append(head, std::bit_cast<std::uint64_t>(grid.low()[axis]));
    append(head, std::bit_cast<std::uint64_t>(grid.edge()));
    for (int axis = 0; axis < 3; ++axis) append(head, static_cast<std::uint32_t>(grid.count()[axis]));
    append(head, static_cast<std::uint32_t>(grid.axisOfRuns()));
    for (int i = 1; i < properties.size(); ++i) {
        head += properties[static_cast<PropertyIndex>(i)].id;
        head.push_back('\0');
    }
    return head;
}

} // namespace

std::uint64_t fingerprint(const VolumeSnapshot& volume) {
    const Grid& grid = volume.grid();
    std::vector<std::uint64_t> rows(static_cast<std::size_t>(grid.lineCountV()));
    parallelFor(std::int32_t{0}, grid.lineCountV(), [&](std::int32_t v) {
        std::string bytes;
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
            const std::span<const Segment> line = volume.line({u, v});
            append(bytes, static_cast<std::uint32_t>(line.size()));
            for (const Segment segment : line) append(bytes, segment.end() << 8 | segment.property());
        }
        rows[static_cast<std::size_t>(v)] = checksum(bytes);
    });
    std::string whole = headOf(grid, volume.properties());
    for (const std::uint64_t row : rows) append(whole, row);
    return checksum(whole);
}

std::string fingerprintText(std::uint64_t fingerprint) {
    std::array<char, 16> digits{};
    const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), fingerprint, 16).ptr;
    const auto count = static_cast<std::size_t>(end - digits.data());
    return std::string(digits.size() - count, '0').append(digits.data(), count);
}

} // namespace burin
