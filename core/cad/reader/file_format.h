// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>

namespace burin {

enum class FileFormat { step, iges, brepText, brepBinary, stlText, stlBinary };

/// What a file's content is, whatever its name. Errors, with an empty subject: fileEmpty; fileFormatUnknown;
/// fileDamaged, where the format is plain but the file's end is missing.
Result<FileFormat> detectFormat(std::string_view content);

/// "STEP AP203", "STEP AP214", "STEP AP242", or "STEP" for another application protocol: from the file's header.
std::string stepProtocol(std::string_view content);

} // namespace burin
