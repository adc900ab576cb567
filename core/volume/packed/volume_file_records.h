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

/// The records of a volume file (volume_file.md), for its writer and its reader.
namespace burin::volume_file {

inline constexpr std::uint32_t version = 1;
inline constexpr std::string_view headerMark = "BurinVol", blockMark = "BurinBlk";
inline constexpr std::size_t markBytes = 8;
/// Maximum length of a header; a greater stated length is damage.
inline constexpr std::size_t longestHeader = std::size_t{16} << 20;
/// A block is closed when its bricks take more, and exceeds this only if a single brick does.
inline constexpr std::size_t fullBlock = std::size_t{4} << 20;
inline constexpr std::size_t largestBlock = std::size_t{1} << 30;

/// Bricks are written in groups of 16 × 16: the groups row by row, and the bricks within each group row by row.
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

/// Content of the header in addition to mark, version, length and checksum.
struct Header {
    Grid grid;
    PropertyList properties;
    std::uint64_t segments = 0; ///< of bricks whose memory is not shared: what a reader has to make room for
};

/// A complete header record. Errors: argumentInvalid (a property that its JSON form does not reproduce).
Result<std::string> headerRecord(const Header& header);
/// Parses the content of a header record of this version. Empty if it is invalid.
std::optional<Header> headerOf(std::string_view content, const std::string& name);

/// Header of a block, in front of its bytes.
struct BlockHead {
    static constexpr std::size_t bytes = markBytes + 5 * sizeof(std::uint32_t) + 2 * sizeof(std::uint64_t);
    std::uint32_t group = 0, firstBrick = 0, bricks = 0;
    std::uint32_t plainBytes = 0, packedBytes = 0;
    std::uint64_t packedChecksum = 0;

    std::string record() const;
    /// Empty if damaged.
    static std::optional<BlockHead> of(std::string_view record);
};

/// Reads the records of a stream one after the other, and skips damage up to the next valid record.
class RecordScanner {
public:
    explicit RecordScanner(std::istream& stream) noexcept : stream_(stream) {}

    struct Found {
        std::uint32_t version = 0; ///< of a header; 0: a block
        std::string content;       ///< of a header
        std::optional<BlockHead> block;
    };
    /// The next valid header or block head at or after the current position, which is then behind it. Empty if there is
    /// none. A block's bytes follow its head. @throws std::bad_alloc
    std::optional<Found> next();
    /// Returns `count` bytes from the current position, which does not move. Fewer at the end of the stream.
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
