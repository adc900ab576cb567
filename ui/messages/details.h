// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string>

namespace burin {

/// Translates the place or detail of an error as recorded by core ("line 5, column 3", "has to be above 0") to the
/// user's language; unknown text is returned unchanged. Thread: that of `Messages`.
QString detailText(const std::string& detail);

} // namespace burin
