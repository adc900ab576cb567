// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/file_format.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

/// What is looked at before OpenCASCADE sees a STEP, IGES or BREP file: whether it is complete. What is taken for one
/// is still one with blank lines behind it, and a file of nothing but padding is none.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    using namespace burin;
    const std::string content(reinterpret_cast<const char*>(bytes), count);
    const auto format = detectFormat(content);
    if (stepProtocol(content).empty()) std::abort();
    if (!format || format->name == StlFormat::name) return 0;
    const auto padded = detectFormat(content + "\r\n \r\n");
    // Bytes more or less may turn one into an STL file, whose length tells what it is.
    if (!padded || (padded->name != format->name && padded->name != StlFormat::name)) std::abort();
    return 0;
}
