// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/checksum.h"
#include "core/base/compression.h"
#include "core/base/file.h"
#include "core/volume/packed/packed_blocks.h"
#include "core/volume/packed/volume_file.h"
#include "core/volume/packed/volume_file_records.h"
#include "core/volume/runs/volume_memory.h"

#include <cerrno>
#include <fstream>
#include <new>
#include <system_error>

namespace burin {

using namespace volume_file;

namespace {

/// Writes the bricks of the groups one after the other.
class GroupWriter {
public:
    GroupWriter(std::ostream& stream, const VolumeSnapshot& volume)
        : stream_(stream), state_(VolumeAccess::state(volume)), groups_(volume.grid()) {}

    const BrickGroups& groups() const noexcept { return groups_; }
    /// False: a brick is too large for a block.
    bool write(std::uint32_t group);

private:
    bool close(BlockHead& head, std::string& plain);

    std::ostream& stream_;
    const VolumeState& state_;
    BrickGroups groups_;
};

bool GroupWriter::write(std::uint32_t group) {
    const std::uint32_t bricks = groups_.bricksIn(group);
    std::vector<BlockIndex> blocks;
    for (std::uint32_t brick = 0; brick < bricks; ++brick) {
        const LineIndex corner = groups_.corner(group, brick);
        blocks.push_back(VolumeAccess::tileAt(state_, corner.u / tileSide, corner.v / tileSide));
    }
    const PackedBlocks packed = packBlocks(*state_.store, blocks);
    BlockHead head;
    head.group = group;
    std::string plain;
    for (std::uint32_t brick = 0; brick < bricks; ++brick) {
        plain += packed.tile(brick);
        ++head.bricks;
        if (plain.size() >= fullBlock && !close(head, plain)) return false;
    }
    return plain.empty() || close(head, plain);
}

/// Writes the collected block and begins the next one after it.
bool GroupWriter::close(BlockHead& head, std::string& plain) {
    if (plain.size() > largestBlock) return false;
    const std::string content = compress(plain);
    head.plainBytes = static_cast<std::uint32_t>(plain.size());
    head.packedBytes = static_cast<std::uint32_t>(content.size());
    head.packedChecksum = checksum(content);
    stream_ << head.record() << content;
    head.firstBrick += head.bricks;
    head.bricks = 0;
    plain.clear();
    return true;
}

} // namespace

Result<void> writeVolume(std::ostream& stream, const std::string& name, const VolumeSnapshot& volume,
                         Progress& progress) try {
    const std::uint64_t segments = memoryOf(volume).segmentBytes / sizeof(Segment);
    const Result<std::string> header = headerRecord({volume.grid(), volume.properties(), segments});
    if (!header) return header.error();
    errno = 0;
    stream << *header;
    GroupWriter writer(stream, volume);
    for (std::uint32_t group = 0; group < writer.groups().groups(); ++group) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "saving the volume", {}, {}};
        if (!writer.write(group)) return Error{ErrorCode::outOfMemory, "saving the volume", {}, "a brick beyond 1 GiB"};
        if (!stream) return writeError(name, errno);
        progress.report(static_cast<double>(group + 1) / writer.groups().groups());
    }
    stream << *header;
    stream.flush();
    if (!stream) return writeError(name, errno);
    return {};
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, "saving the volume", {}, {}};
}

Result<void> writeVolumeFile(const std::filesystem::path& file, const VolumeSnapshot& volume, Progress& progress) {
    const std::filesystem::path beside = temporaryBeside(file);
    Result<void> written;
    {
        errno = 0;
        std::ofstream stream(beside, std::ios::binary);
        if (!stream) return writeError(file, errno);
        written = writeVolume(stream, file.string(), volume, progress);
    }
    if (written) return replaceFile(beside, file);
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    return written;
}

} // namespace burin
