// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtGlobal>

namespace burin::testing {

/// Whether every case is asked for (`tests/run --long`). The usual run takes a share of them that still shows each
/// fact.
inline bool longRun() {
    return qEnvironmentVariableIsSet("BURIN_LONG_RUN");
}

/// @return `all` in a long run, `share` otherwise
template <class T>
T inLongRun(T all, T share) {
    return longRun() ? all : share;
}

} // namespace burin::testing
