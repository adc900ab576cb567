// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/file_format.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

/// The check of a STEP, IGES or BREP file before OpenCASCADE reads it: whether it is complete. A file that is accepted
/// is still accepted with blank lines at its end, and a file that contains only padding is not accepted.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    using namespace burin;
    const std::string content(reinterpret_cast<const char*>(bytes), count);
    const auto format = detectFormat(content);
    if (stepProtocol(content).empty()) std::abort();
    if (!format || format->name == StlFormat::name) return 0;
    const auto padded = detectFormat(content + "\r\n \r\n");
    // Additional bytes may turn a file into an STL file, which is recognised by its length.
    if (!padded || (padded->name != format->name && padded->name != StlFormat::name)) std::abort();
    return 0;
}
