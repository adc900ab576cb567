// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"

namespace burin {

/// A tool holder: segments from its face upwards. A tool in this holder has a copy of them.
struct Holder {
    std::string id, name;                ///< "er16-collet-chuck"; English
    std::string source;                  ///< where the dimensions come from
    std::vector<HolderSegment> segments; ///< at least one
};

/// Loads a holder that is shipped with Burin or was added by the user: holders/<id>.json. Errors: nameUnknown,
/// resourceInvalid.
Result<Holder> loadHolder(std::string_view id);
/// Returns the ids of all holders, sorted.
std::vector<std::string> holderIds();
/// @param origin file name for messages. Errors: resourceInvalid.
Result<Holder> holderFromJson(std::string_view text, const std::string& origin);

} // namespace burin
