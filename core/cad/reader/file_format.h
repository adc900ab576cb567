// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/import_formats.h"
#include "core/cad/reader/reader.h"

#include <string>
#include <string_view>

namespace burin {

/// A file being read, with its request. Holds references only.
struct ModelSource {
    const ReadRequest& request;
    const ReaderReports& report;
    std::string& content; ///< of the whole file; a reader may clear it once it is no longer needed
};

/// A row of ImportFormats as used by the import program.
struct ReaderFormat {
    std::string_view name;
    FormatMatch (*match)(std::string_view content);
    Result<Model> (*read)(ModelSource& source);
};

/// Returns the format of a file's content, regardless of its name. Errors, with an empty subject: fileEmpty;
/// fileFormatUnknown; fileDamaged, if the format is recognised but the file is not complete.
Result<ReaderFormat> detectFormat(std::string_view content);

/// Returns "STEP AP203", "STEP AP214", "STEP AP242", or "STEP" for another application protocol, from the file's
/// header.
std::string stepProtocol(std::string_view content);

} // namespace burin
