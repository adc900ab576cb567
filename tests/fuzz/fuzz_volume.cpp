// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/checksum.h"
#include "core/volume/packed/packed_tile.h"
#include "core/volume/packed/volume_file.h"
#include "tests/fuzz/sound_volume.h"

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

using namespace burin;

namespace {

constexpr std::size_t reserve = std::size_t{8} << 20;

/// Gives every record the right checksums for its bytes, so that the code after the check is tested as well.
void makeSumsRight(std::string& bytes) {
    const auto put = [&](std::size_t at, std::uint64_t sum) {
        for (std::size_t i = 0; i < 8; ++i) bytes[at + i] = static_cast<char>((sum >> (8 * i)) & 0xff);
    };
    const auto word = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
        return std::size_t{value};
    };
    const std::string_view view(bytes);
    for (std::size_t at = view.find("BurinVol"); at != std::string_view::npos; at = view.find("BurinVol", at + 1)) {
        if (bytes.size() - at < 16) break;
        const std::size_t end = at + 16 + word(at + 12);
        if (end + 8 <= bytes.size()) put(end, checksum(view.substr(at, end - at)));
    }
    for (std::size_t at = view.find("BurinBlk"); at != std::string_view::npos; at = view.find("BurinBlk", at + 1)) {
        if (bytes.size() - at < 44) break;
        const std::size_t length = word(at + 24);
        if (length <= bytes.size() - at - 44) put(at + 28, checksum(view.substr(at + 44, length)));
        put(at + 36, checksum(view.substr(at, 36)));
    }
}

void readAll(const std::string& bytes) {
    std::istringstream stream(bytes);
    Progress progress;
    const Result<VolumeFileContent> content = readVolume(stream, "fuzz", progress, reserve);
    if (content) fuzz::checkVolume(content->volume);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    std::string input(reinterpret_cast<const char*>(bytes), count);
    BrickLines tile(1U << 14);
    static_cast<void>(unpackTile(input, {1U << 14, 4}, tile));
    readAll(input);
    makeSumsRight(input);
    readAll(input);
    return 0;
}
