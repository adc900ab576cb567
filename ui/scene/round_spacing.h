// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin {

/// A round length (1, 2 or 5 times a power of ten, mm) of about a tenth of `length`.
double roundSpacing(double length);

} // namespace burin
