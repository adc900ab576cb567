// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtGlobal>
#include <QtTest>

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

/// First in a test function that the usual run leaves out: it takes long, and others show what it has in common with
/// them.
#define BURIN_ONLY_IN_LONG_RUNS                                                                                        \
    if (!burin::testing::longRun()) QSKIP("in tests/run --long")
