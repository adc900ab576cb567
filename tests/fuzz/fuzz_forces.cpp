// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/calibration.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

/// Whatever stands in the table, reading and fitting it end, and what they give is finite.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    using namespace burin;
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    const Result<std::vector<ForceRecord>> records = parseForceRecords(text, "fuzz");
    if (!records) return 0;
    for (const ChipLaw law : {ChipLaw::constant, ChipLaw::kienzle})
        for (const ForceProjection projection : {ForceProjection::feedAndAxis, ForceProjection::turningTeeth}) {
            CalibrationOptions options;
            options.law = law;
            options.projection = projection;
            const auto fitted = calibrate(*records, records->front().material, options, "fuzz");
            if (fitted && !(fitted->specificEnergy.low > 0.0 && fitted->specificEnergy.high < 1e300)) std::abort();
        }
    return 0;
}
