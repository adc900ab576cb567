// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFont>

namespace burin {

/// `base` if all of its digits are equally wide, so that numbers don't jitter while they change; otherwise the same
/// size and weight of a family whose digits are. (Qt 6.4 can't ask a font for its tabular figures.)
QFont numberFont(const QFont& base);

} // namespace burin
