// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/stock_volume.h"

#include "core/base/checksum.h"
#include "core/volume/packed/volume_file.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace burin {

namespace {

Result<RunVolume> unpacked(const std::string& content, const std::string& name, Progress& progress) {
    std::istringstream stream(content);
    Result<VolumeFileContent> file = readVolume(stream, name, progress);
    if (!file) return std::move(file).error();
    // Lost data would become air where there is material: the tool would move through it at full feed.
    if (std::optional<Error> damage = file->damage()) return std::move(*damage);
    return std::move(file->volume);
}

bool isAir(const RunVolume& volume) {
    const auto& units = volume.amounts().units;
    return std::all_of(units.begin() + 1, units.end(), [](std::uint64_t length) { return length == 0; });
}

} // namespace

StockVolume::StockVolume(std::string content, std::string name, const RunVolume& volume)
    : content_(std::move(content))
    , name_(std::move(name))
    , grid_(volume.grid())
    , materials_(volume.properties())
    , amounts_(volume.amounts())
    , checksum_(burin::checksum(content_)) {}

Result<StockVolume::Shared> StockVolume::of(const VolumeSnapshot& volume, const std::string& name, Progress& progress) {
    std::ostringstream stream;
    if (Result<void> written = writeVolume(stream, name, volume, progress); !written) return std::move(written).error();
    return read(std::move(stream).str(), name, progress);
}

Result<StockVolume::Shared> StockVolume::read(std::string content, const std::string& name, Progress& progress) {
    const Result<RunVolume> volume = unpacked(content, name, progress);
    if (!volume) return volume.error();
    if (isAir(*volume)) return Error{ErrorCode::stockInvalid, name, {}, "a volume that is not air all over"};
    return Shared(new StockVolume(std::move(content), name, *volume));
}

PropertyIndex StockVolume::mainMaterial() const noexcept {
    const auto& units = amounts_.units;
    return static_cast<PropertyIndex>(std::max_element(units.begin() + 1, units.end()) - units.begin());
}

Result<RunVolume> StockVolume::unpack(Progress& progress) const {
    return unpacked(content_, name_, progress);
}

} // namespace burin
