// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"

namespace burin {

/// What tools are held in: segments from its face upwards. A tool that is put into it has a copy of them.
struct Holder {
    std::string id, name;                ///< "er16-collet-chuck"; English
    std::string source;                  ///< where the dimensions come from
    std::vector<HolderSegment> segments; ///< one at least
};

/// Holders that Burin is shipped with or the user added: holders/<id>.json. Errors: nameUnknown, resourceInvalid.
Result<Holder> loadHolder(std::string_view id);
/// Ids of all holders there are, sorted.
std::vector<std::string> holderIds();
/// @param origin file name for messages. Errors: resourceInvalid.
Result<Holder> holderFromJson(std::string_view text, const std::string& origin);

} // namespace burin
