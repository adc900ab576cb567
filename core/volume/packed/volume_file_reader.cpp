// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/checksum.h"
#include "core/base/compression.h"
#include "core/base/file.h"
#include "core/volume/packed/packed_blocks.h"
#include "core/volume/packed/volume_file.h"
#include "core/volume/packed/volume_file_records.h"
#include "core/volume/packed/volume_loss.h"

#include <cerrno>
#include <fstream>
#include <new>
#include <unordered_map>
#include <utility>

namespace burin {

using namespace volume_file;

namespace {

struct FoundHeader {
    Header header;
    bool wasDamaged = false; ///< whether the first copy was damaged
};

/// Returns the first readable copy of the header.
Result<FoundHeader> findHeader(RecordScanner& scanner, const std::string& name) {
    const bool ours = scanner.peek(markBytes) == headerMark;
    bool first = true, any = ours;
    while (const std::optional<RecordScanner::Found> found = scanner.next()) {
        any = true;
        if (found->version > version)
            return Error{ErrorCode::fileFromNewerBurin, name, {}, std::to_string(found->version)};
        if (found->version == version)
            if (std::optional<Header> header = headerOf(found->content, name))
                return FoundHeader{*std::move(header), !first};
        first = false;
    }
    if (!any) return Error{ErrorCode::fileFormatUnknown, name, {}, "no volume"};
    return Error{ErrorCode::fileDamaged, name, "both copies of the header", {}};
}

/// Fills a volume from blocks, each brick once.
class BrickReader {
public:
    BrickReader(RunVolume& volume, const Header& header)
        : volume_(volume)
        , groups_(header.grid)
        , frame_(packedFrame(header.grid, header.properties))
        , bricks_(header.grid)
        , lines_(frame_.lineEnd) {}

    /// Reads the content of the block in front of the scanner, if it is valid. Otherwise the scanner stays in place,
    /// because another record may begin within what should have been the block.
    /// Errors: volumeOutOfMemory.
    Result<void> read(const BlockHead& head, RecordScanner& scanner);
    const BrickMap& bricks() const noexcept { return bricks_; }

private:
    Result<void> put(const BlockHead& head, std::string_view plain);
    bool place(LineIndex corner, std::string_view packed);

    RunVolume& volume_;
    BrickGroups groups_;
    PackedTileFrame frame_;
    BrickMap bricks_;
    BrickLines lines_;
    std::unordered_map<std::string_view, LineIndex> known_; ///< for one block: equal bricks share memory
};

Result<void> BrickReader::read(const BlockHead& head, RecordScanner& scanner) {
    if (head.group >= groups_.groups() || head.plainBytes > largestBlock) return {};
    const std::uint32_t all = groups_.bricksIn(head.group);
    if (head.bricks > all || head.firstBrick > all - head.bricks) return {};
    const std::string packed = scanner.peek(head.packedBytes);
    if (packed.size() != head.packedBytes || checksum(packed) != head.packedChecksum) return {};
    scanner.skip(packed.size());
    const std::optional<std::string> plain = decompress(packed, head.plainBytes);
    if (!plain) return {};
    return put(head, *plain);
}

Result<void> BrickReader::put(const BlockHead& head, std::string_view plain) {
    known_.clear();
    for (std::uint32_t i = 0; i < head.bricks; ++i) {
        std::size_t length = 0;
        if (!unpackTile(plain, frame_, lines_, &length)) return {};
        const LineIndex corner = groups_.corner(head.group, head.firstBrick + i);
        if (!bricks_.has(corner)) {
            if (!place(corner, plain.substr(0, length)))
                return Error{ErrorCode::volumeOutOfMemory, std::to_string(volume_.reservedBytes()), {}, {}};
            bricks_.add(corner);
        }
        plain.remove_prefix(length);
    }
    return {};
}

bool BrickReader::place(LineIndex corner, std::string_view packed) {
    auto& writer = VolumeAccess::writer(volume_);
    const auto [equal, isNew] = known_.try_emplace(packed, corner);
    return isNew ? writer.setBrick(corner, lines_) : writer.shareBrick(corner, equal->second);
}

} // namespace

Result<VolumeFileContent> readVolume(std::istream& stream, const std::string& name, Progress& progress,
                                     std::size_t reservedBytes) try {
    RecordScanner scanner(stream);
    Result<FoundHeader> found = findHeader(scanner, name);
    if (!found) return std::move(found).error();
    if (found->wasDamaged) scanner.rewind();
    const Header& header = found->header;
    const std::size_t content = static_cast<std::size_t>(header.segments) * sizeof(Segment);
    // Twice the size of the segments, because editing continues afterwards.
    Result<RunVolume> volume =
        RunVolume::make(header.grid, header.properties,
                        reservedBytes != 0 ? reservedBytes : RunVolume::defaultReserve(header.grid) + 2 * content);
    if (!volume) return std::move(volume).error();
    BrickReader reader(*volume, header);
    const std::size_t all = reader.bricks().all();
    while (const std::optional<RecordScanner::Found> next = scanner.next()) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "reading the volume", {}, {}};
        if (!next->block) continue;
        if (Result<void> read = reader.read(*next->block, scanner); !read) return std::move(read).error();
        progress.report(static_cast<double>(reader.bricks().count()) / static_cast<double>(all));
    }
    std::vector<VolumeLoss> lost = reader.bricks().losses();
    return VolumeFileContent{*std::move(volume), std::move(lost), found->wasDamaged, name};
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, "reading the volume", {}, {}};
}

Result<VolumeFileContent> readVolumeFile(const std::filesystem::path& file, Progress& progress,
                                         std::size_t reservedBytes) {
    Result<std::ifstream> stream = openFileStream(file);
    if (!stream) return std::move(stream).error();
    if (stream->peek() == std::ifstream::traits_type::eof())
        return stream->bad() ? readError(file, errno) : Error{ErrorCode::fileEmpty, file.string(), {}, {}};
    return readVolume(*stream, file.string(), progress, reservedBytes);
}

} // namespace burin
