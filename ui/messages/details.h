// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string>

namespace burin {

/// What core records as place or detail of an error ("line 5, column 3", "has to be above 0"), in the user's language;
/// text that Burin does not know stays as it is. Thread: that of `Messages`.
QString detailText(const std::string& detail);

} // namespace burin
