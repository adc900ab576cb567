// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/import_formats.h"
#include "core/cad/reader/reader.h"

#include <string>
#include <string_view>

namespace burin {

/// A file that is read, with what was asked for. Borrows all of it.
struct ModelSource {
    const ReadRequest& request;
    const ReaderReports& report;
    std::string& content; ///< of the whole file; a reader may empty it once it needs it no more
};

/// A row of ImportFormats as this program uses it.
struct ReaderFormat {
    std::string_view name;
    FormatMatch (*match)(std::string_view content);
    Result<Model> (*read)(ModelSource& source);
};

/// What a file's content is, whatever its name. Errors, with an empty subject: fileEmpty; fileFormatUnknown;
/// fileDamaged, where the format is plain but the file is not complete.
Result<ReaderFormat> detectFormat(std::string_view content);

/// "STEP AP203", "STEP AP214", "STEP AP242", or "STEP" for another application protocol: from the file's header.
std::string stepProtocol(std::string_view content);

} // namespace burin
