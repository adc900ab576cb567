// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace burin {

/// Has assistive programs read a visible widget at once, by its accessible name and description: for changes that the
/// user did not make and that would otherwise only be seen.
void announce(QWidget& widget);

} // namespace burin
