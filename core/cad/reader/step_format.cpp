// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/cad_model.h"
#include "core/cad/reader/file_format.h"
#include "core/cad/reader/file_text.h"

#include <algorithm>
#include <cctype>

namespace burin {

using file_text::contains;

FormatMatch matchFormat(StepFormat, std::string_view content) {
    if (!file_text::withoutLead(content).starts_with("ISO-10303-21")) return {};
    return {true, std::string(contains(content, "END-ISO-10303-21") ? "" : file_text::endIsMissing)};
}

Result<Model> readFormat(StepFormat, ModelSource& source) {
    return modelOf(readStepFile(source.request.file, source.content, source.report), source);
}

std::string stepProtocol(std::string_view content) {
    const std::size_t schema = content.find("FILE_SCHEMA");
    if (schema == std::string_view::npos) return "STEP";
    const std::size_t end = content.find(';', schema);
    std::string names(content.substr(schema, end == std::string_view::npos ? 400 : end - schema));
    std::transform(names.begin(), names.end(), names.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    if (contains(names, "AP242")) return "STEP AP242";
    if (contains(names, "AUTOMOTIVE_DESIGN")) return "STEP AP214";
    if (contains(names, "CONFIG_CONTROL_DESIGN") || contains(names, "AP203")) return "STEP AP203";
    return "STEP";
}

} // namespace burin
