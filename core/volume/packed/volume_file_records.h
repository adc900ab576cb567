// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/tile.h"
#include "core/volume/runs/volume_store.h"

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

/// The records that a volume's file consists of (volume_file.md), for its writer and its reader.
namespace burin::volume_file {

inline constexpr std::uint32_t version = 1;
inline constexpr std::string_view headerMark = "BurinVol", blockMark = "BurinBlk";
inline constexpr std::size_t markBytes = 8;
/// No header is longer; a stated length beyond is damage.
inline constexpr std::size_t longestHeader = std::size_t{16} << 20;
/// A block is closed when its bricks take more, and holds more only when a single brick does.
inline constexpr std::size_t fullBlock = std::size_t{4} << 20;
inline constexpr std::size_t largestBlock = std::size_t{1} << 30;

/// Bricks are written in groups of 16 × 16, the groups row by row, the bricks of a group row by row.
class BrickGroups {
public:
    explicit BrickGroups(const Grid& grid) noexcept : table_(grid) {}

    std::uint32_t groups() const noexcept { return static_cast<std::uint32_t>(table_.pageCount()); }
    std::uint32_t bricksIn(std::uint32_t group) const noexcept;
    /// The first scanline of a brick.
    LineIndex corner(std::uint32_t group, std::uint32_t brick) const noexcept;
    std::size_t bricks() const noexcept {
        return static_cast<std::size_t>(table_.tilesU) * static_cast<std::size_t>(table_.tilesV);
    }

private:
    std::int32_t widthOf(std::uint32_t group) const noexcept;
    TileTable table_;
};

/// What the header says beside mark, version, length and checksum.
struct Header {
    Grid grid;
    PropertyList properties;
    std::uint64_t segments = 0; ///< of bricks whose memory is not shared: what a reader has to make room for
};

/// A whole header record. Errors: argumentInvalid (a property that does not come back from its JSON form).
Result<std::string> headerRecord(const Header& header);
/// Content of a header record of this version. Nothing: it can't be.
std::optional<Header> headerOf(std::string_view content, const std::string& name);

/// What stands in front of a block's bytes.
struct BlockHead {
    static constexpr std::size_t bytes = markBytes + 5 * sizeof(std::uint32_t) + 2 * sizeof(std::uint64_t);
    std::uint32_t group = 0, firstBrick = 0, bricks = 0;
    std::uint32_t plainBytes = 0, packedBytes = 0;
    std::uint64_t packedChecksum = 0;

    std::string record() const;
    /// Nothing: damaged.
    static std::optional<BlockHead> of(std::string_view record);
};

/// Walks the records of a stream, and from damage on to the next record that is sound.
class RecordScanner {
public:
    explicit RecordScanner(std::istream& stream) noexcept : stream_(stream) {}

    struct Found {
        std::uint32_t version = 0; ///< of a header; 0: a block
        std::string content;       ///< of a header
        std::optional<BlockHead> block;
    };
    /// The next sound header or head of a block at or after the present place, which then is behind it. Nothing: none.
    /// A block's bytes follow its head. @throws std::bad_alloc
    std::optional<Found> next();
    /// So many bytes from the present place on, which stays. Fewer at the end of the stream.
    std::string peek(std::size_t count);
    void skip(std::uint64_t bytes) noexcept { at_ += bytes; }
    void rewind() noexcept { at_ = 0; }

private:
    std::optional<Found> soundRecordHere();
    bool findMark();

    std::istream& stream_;
    std::uint64_t at_ = 0;
};

} // namespace burin::volume_file
