// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFont>

namespace burin {

/// Returns `base` if all of its digits have the same width, so that numbers don't jitter while they change; otherwise a
/// font of the same size and weight from a family with equally wide digits. (Qt 6.4 can't request a font's tabular
/// figures.)
QFont numberFont(const QFont& base);

} // namespace burin
