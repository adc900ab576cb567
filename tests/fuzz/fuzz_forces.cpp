// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/calibration.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace {

using namespace burin;

bool isSound(const Confidence& value) {
    return std::isfinite(value.low) && std::isfinite(value.high) && value.low <= value.value &&
           value.value <= value.high;
}

void checkFit(const std::vector<ForceRecord>& records, const CalibrationOptions& options) {
    const auto fitted = calibrate(records, records.front().material, options, "fuzz");
    if (!fitted) return;
    if (!isSound(fitted->specificEnergy) || !(fitted->specificEnergy.low > 0.0)) std::abort();
    if (!isSound(fitted->radialRatio)) std::abort();
    if (options.law == ChipLaw::kienzle && !(isSound(fitted->kienzleForce) && isSound(fitted->kienzleExponent)))
        std::abort();
    if (options.law == ChipLaw::edge && !(isSound(fitted->edgeForce) && isSound(fitted->radialEdgeForce))) std::abort();
}

} // namespace

/// With any table, reading and fitting end, and their results are finite.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    const Result<std::vector<ForceRecord>> records = parseForceRecords(text, "fuzz");
    if (!records) return 0;
    for (const ChipLaw law : {ChipLaw::constant, ChipLaw::kienzle, ChipLaw::edge})
        for (const ForceProjection projection : {ForceProjection::feedAndAxis, ForceProjection::turningTeeth})
            for (const bool onWorkpiece : {false, true}) {
                CalibrationOptions options;
                options.law = law;
                options.projection = projection;
                options.forcesOnWorkpiece = onWorkpiece;
                checkFit(*records, options);
            }
    return 0;
}
