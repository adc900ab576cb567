// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace burin {

/// Error::detail of ErrorCode::cancelled for a change that was refused because an undo or redo is under way; its
/// subject is the title of the change.
inline constexpr std::string_view undoUnderWayDetail = "an undo or redo is under way";

} // namespace burin
