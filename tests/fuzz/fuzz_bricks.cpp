// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/checksum.h"
#include "core/base/compression.h"
#include "core/volume/packed/packed_tile.h"
#include "core/volume/packed/volume_file.h"
#include "core/volume/packed/volume_file_records.h"
#include "tests/fuzz/sound_volume.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <string_view>

using namespace burin;

// What fuzz_volume cannot reach: a volume's file wraps packed bricks in frames with checksums of their own, so that no
// change of its bytes reaches the bricks. Here the input is the bricks themselves, in an otherwise valid file: the
// number of properties besides air, a choice of line length, packed bricks.

namespace {

constexpr std::size_t reserve = std::size_t{1} << 20;
constexpr std::int32_t linesU = 19, linesV = 12; ///< 3 × 2 bricks, those at the end incomplete
constexpr std::uint32_t bricks = 6;
constexpr std::array<std::int32_t, 4> lineLengths{4, 6, 64, 32768};

/// Header of a file; cached, as property lists take long to make.
const std::string& headerOf(int properties, std::int32_t voxels) {
    static std::map<std::pair<int, std::int32_t>, std::string> known;
    std::string& header = known[{properties, voxels}];
    if (!header.empty()) return header;
    PropertyList list;
    for (int i = 1; i <= properties; ++i) {
        Property property;
        property.id = property.name = std::to_string(i);
        property.machinability = Machinability::isProtected;
        if (!list.add(property)) std::abort();
    }
    const Grid grid = *Grid::make(glm::dvec3(0.0), 1.0, {linesU, linesV, voxels});
    return header = *volume_file::headerRecord({grid, list, 0});
}

std::string fileOf(const std::string& header, std::string_view packed) {
    const std::string frame = compress(packed);
    volume_file::BlockHead head;
    head.bricks = bricks;
    head.plainBytes = static_cast<std::uint32_t>(packed.size());
    head.packedBytes = static_cast<std::uint32_t>(frame.size());
    head.packedChecksum = checksum(frame);
    return header + head.record() + frame + header;
}

Result<VolumeFileContent> contentOf(const std::string& file) {
    std::istringstream stream(file);
    Progress progress;
    return readVolume(stream, "fuzz", progress, reserve);
}

bool sameLines(const RunVolume& a, const RunVolume& b) {
    for (LineIndex line; line.v < linesV; ++line.v)
        for (line.u = 0; line.u < linesU; ++line.u)
            if (!std::ranges::equal(a.line(line), b.line(line))) return false;
    return true;
}

/// Writes a volume that was read and reads it again: the lines must be the same.
void comesBack(RunVolume& volume) {
    std::ostringstream stream;
    Progress progress;
    if (!writeVolume(stream, "fuzz", volume.snapshot(), progress)) std::abort();
    const Result<VolumeFileContent> again = contentOf(stream.str());
    // Read all at once it may need more memory than when it was read gradually.
    if (!again && again.error().code == ErrorCode::volumeOutOfMemory) return;
    if (!again || !again->lost.empty() || !sameLines(volume, again->volume)) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    if (count < 2) return 0;
    const int properties = std::max<int>(bytes[0], 1);
    const std::int32_t voxels = lineLengths[bytes[1] % lineLengths.size()];
    const std::string_view packed(reinterpret_cast<const char*>(bytes) + 2, count - 2);
    const PackedTileFrame frame{static_cast<RunPosition>(voxels) * unitsPerVoxel,
                                static_cast<std::uint32_t>(properties) + 1};
    BrickLines tile(frame.lineEnd);
    if (!unpackTile(packed, frame, tile)) return 0; // the file would contain only air: nothing new, and slow
    RunAmounts sum;
    for (int line = 0; line < linesPerTile; ++line)
        fuzz::checkLine(tile.line(line), frame.lineEnd, properties + 1, sum);
    Result<VolumeFileContent> content = contentOf(fileOf(headerOf(properties, voxels), packed));
    if (!content) {
        if (content.error().code != ErrorCode::volumeOutOfMemory) std::abort();
        return 0;
    }
    fuzz::checkVolume(content->volume);
    comesBack(content->volume);
    return 0;
}
