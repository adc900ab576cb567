// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Built instead of openvdb_*.cpp if OpenVDB was not found.
#include "tests/benchmarks/peers/openvdb.h"

namespace burin::benchmarks {

bool hasOpenVdb() noexcept {
    return false;
}
std::optional<std::uint64_t> openVdbBytes(const VolumeSnapshot&) {
    return std::nullopt;
}
std::unique_ptr<CuttingPeer> openVdbCutter(const VolumeSnapshot&, const EndMill&) {
    return nullptr;
}
std::optional<std::vector<double>> csgDifferenceTimes(double, double, const std::vector<glm::dvec3>&) {
    return std::nullopt;
}
std::optional<double> meshToLevelSetSeconds(const TriangleMesh&, float) {
    return std::nullopt;
}
std::optional<std::array<double, 3>> levelSetBooleanTimes(const Box&, const Box&, int) {
    return std::nullopt;
}
std::optional<double> levelSetQueryNanoseconds(const TriangleMesh&, const std::vector<glm::dvec3>&) {
    return std::nullopt;
}

} // namespace burin::benchmarks
