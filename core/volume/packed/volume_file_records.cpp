// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/packed/volume_file_records.h"

#include "core/base/checksum.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace burin::volume_file {

namespace {

template <class Word>
void append(std::string& bytes, Word word) {
    for (std::size_t i = 0; i < sizeof word; ++i) bytes.push_back(static_cast<char>((word >> (8 * i)) & 0xff));
}
void append(std::string& bytes, double number) {
    append(bytes, std::bit_cast<std::uint64_t>(number));
}

/// Takes words from the front of a byte string, lowest byte first; zeros once there are too few bytes.
class Words {
public:
    explicit Words(std::string_view bytes) noexcept : bytes_(bytes) {}
    template <class Word>
    Word take() noexcept {
        const std::string_view part = takeBytes(sizeof(Word));
        Word word = 0;
        for (std::size_t i = 0; i < part.size(); ++i)
            word |= static_cast<Word>(static_cast<Word>(static_cast<unsigned char>(part[i])) << (8 * i));
        return word;
    }
    double takeNumber() noexcept { return std::bit_cast<double>(take<std::uint64_t>()); }
    /// Empty if there are fewer.
    std::string_view takeBytes(std::size_t count) noexcept {
        if (count > bytes_.size()) {
            good_ = false;
            return {};
        }
        const std::string_view part = bytes_.substr(0, count);
        bytes_.remove_prefix(count);
        return part;
    }
    bool allTaken() const noexcept { return good_ && bytes_.empty(); }
    bool good() const noexcept { return good_; }

private:
    std::string_view bytes_;
    bool good_ = true;
};

constexpr std::size_t headerFront = markBytes + 2 * sizeof(std::uint32_t);

} // namespace

std::int32_t BrickGroups::widthOf(std::uint32_t group) const noexcept {
    const std::int32_t first = static_cast<std::int32_t>(group) % table_.pagesU * TileTable::pageSide;
    return std::min(TileTable::pageSide, table_.tilesU - first);
}

std::uint32_t BrickGroups::bricksIn(std::uint32_t group) const noexcept {
    const std::int32_t first = static_cast<std::int32_t>(group) / table_.pagesU * TileTable::pageSide;
    return static_cast<std::uint32_t>(widthOf(group) * std::min(TileTable::pageSide, table_.tilesV - first));
}

LineIndex BrickGroups::corner(std::uint32_t group, std::uint32_t brick) const noexcept {
    const auto page = static_cast<std::int32_t>(group), place = static_cast<std::int32_t>(brick);
    const std::int32_t width = widthOf(group);
    return {(page % table_.pagesU * TileTable::pageSide + place % width) * tileSide,
            (page / table_.pagesU * TileTable::pageSide + place / width) * tileSide};
}

Result<std::string> headerRecord(const Header& header) {
    std::string content;
    for (int i = 0; i < 3; ++i) append(content, header.grid.low()[i]);
    append(content, header.grid.edge());
    for (int i = 0; i < 3; ++i) append(content, static_cast<std::uint32_t>(header.grid.count()[i]));
    append(content, static_cast<std::uint32_t>(header.grid.axis()));
    append(content, header.segments);
    append(content, static_cast<std::uint32_t>(header.properties.size() - 1));
    for (int i = 1; i < header.properties.size(); ++i) {
        const Property& property = header.properties[static_cast<PropertyIndex>(i)];
        const std::string json = toJson(property);
        if (const Result<Property> back = propertyFromJson(json, property.id); !back)
            return Error{ErrorCode::argumentInvalid, "property", property.id, back.error().detail};
        append(content, static_cast<std::uint32_t>(json.size()));
        content += json;
    }
    std::string record(headerMark);
    append(record, version);
    append(record, static_cast<std::uint32_t>(content.size()));
    record += content;
    append(record, checksum(record));
    return record;
}

std::optional<Header> headerOf(std::string_view content, const std::string& name) {
    Words words(content);
    glm::dvec3 low;
    for (int i = 0; i < 3; ++i) low[i] = words.takeNumber();
    const double edge = words.takeNumber();
    glm::ivec3 count;
    for (int i = 0; i < 3; ++i) count[i] = static_cast<std::int32_t>(words.take<std::uint32_t>());
    const auto axis = words.take<std::uint32_t>();
    if (!words.good() || axis > 2) return std::nullopt;
    const Result<Grid> grid = Grid::make(low, edge, count, static_cast<RunAxis>(axis));
    if (!grid) return std::nullopt;
    Header header{*grid, {}, words.take<std::uint64_t>()};
    const auto properties = words.take<std::uint32_t>();
    for (std::uint32_t i = 0; i < properties; ++i) {
        const std::string_view json = words.takeBytes(words.take<std::uint32_t>());
        if (!words.good()) return std::nullopt;
        Result<Property> property = propertyFromJson(json, name);
        if (!property || !header.properties.add(*std::move(property))) return std::nullopt;
    }
    if (!words.allTaken()) return std::nullopt;
    return header;
}

std::string BlockHead::record() const {
    std::string record(blockMark);
    for (const std::uint32_t word : {group, firstBrick, bricks, plainBytes, packedBytes}) append(record, word);
    append(record, packedChecksum);
    append(record, checksum(record));
    return record;
}

std::optional<BlockHead> BlockHead::of(std::string_view record) {
    if (record.size() < bytes || !record.starts_with(blockMark)) return std::nullopt;
    const std::size_t stated = bytes - sizeof(std::uint64_t);
    Words words(record.substr(markBytes, bytes - markBytes));
    BlockHead head;
    head.group = words.take<std::uint32_t>();
    head.firstBrick = words.take<std::uint32_t>();
    head.bricks = words.take<std::uint32_t>();
    head.plainBytes = words.take<std::uint32_t>();
    head.packedBytes = words.take<std::uint32_t>();
    head.packedChecksum = words.take<std::uint64_t>();
    if (words.take<std::uint64_t>() != checksum(record.substr(0, stated))) return std::nullopt;
    return head;
}

std::string RecordScanner::peek(std::size_t count) {
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(at_));
    // In parts: a stated length may be far beyond the end of the stream.
    constexpr std::size_t part = std::size_t{1} << 20;
    std::string bytes;
    while (bytes.size() < count && stream_) {
        const std::size_t before = bytes.size();
        bytes.resize(before + std::min(part, count - before));
        stream_.read(bytes.data() + before, static_cast<std::streamsize>(bytes.size() - before));
        bytes.resize(before + static_cast<std::size_t>(stream_.gcount()));
    }
    return bytes;
}

/// Moves to the next mark. False if there is none.
bool RecordScanner::findMark() {
    constexpr std::size_t window = 65536;
    for (std::string bytes = peek(window); bytes.size() >= markBytes; bytes = peek(window)) {
        const std::size_t place = std::min(bytes.find(headerMark), bytes.find(blockMark));
        if (place != std::string::npos) {
            at_ += place;
            return true;
        }
        at_ += bytes.size() - (markBytes - 1); // a mark may begin in the last bytes
    }
    return false;
}

std::optional<RecordScanner::Found> RecordScanner::soundRecordHere() {
    const std::string front = peek(BlockHead::bytes);
    if (const std::optional<BlockHead> head = BlockHead::of(front)) {
        skip(BlockHead::bytes);
        return Found{0, {}, head};
    }
    if (!front.starts_with(headerMark) || front.size() < headerFront) return std::nullopt;
    Words words(std::string_view(front).substr(markBytes));
    const auto stated = words.take<std::uint32_t>();
    const std::size_t length = words.take<std::uint32_t>();
    if (stated == 0 || length > longestHeader) return std::nullopt;
    const std::size_t all = headerFront + length;
    const std::string record = peek(all + sizeof(std::uint64_t));
    if (record.size() < all + sizeof(std::uint64_t)) return std::nullopt;
    Words sum(std::string_view(record).substr(all));
    if (sum.take<std::uint64_t>() != checksum(std::string_view(record).substr(0, all))) return std::nullopt;
    skip(record.size());
    return Found{stated, record.substr(headerFront, length), {}};
}

std::optional<RecordScanner::Found> RecordScanner::next() {
    if (std::optional<Found> found = soundRecordHere()) return found;
    while (findMark()) {
        if (std::optional<Found> found = soundRecordHere()) return found;
        skip(1);
    }
    return std::nullopt;
}

} // namespace burin::volume_file
