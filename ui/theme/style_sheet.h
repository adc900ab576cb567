// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/theme.h"

namespace burin {

/// The application's style sheet in a palette's colours. Widgets select a special look with the dynamic property
/// "look": "primary" (the main action of a panel), "record", "recording", "flat", "choice" (one of several buttons side
/// by side), "quiet", "title", "section", "card", "inOrder", "force", "accent".
QString styleSheet(const Palette& palette);

} // namespace burin
