// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtGlobal>
#include <QtTest>

namespace burin::testing {

/// Whether all cases are requested (`tests/run --long`). The usual run uses a share of them that still demonstrates
/// each fact.
inline bool longRun() {
    return qEnvironmentVariableIsSet("BURIN_LONG_RUN");
}

/// @return `all` in a long run, `share` otherwise
template <class T>
T inLongRun(T all, T share) {
    return longRun() ? all : share;
}

} // namespace burin::testing

/// To be used first in a test function that the usual run skips, because it takes long and other tests cover what it
/// has in common with them.
#define BURIN_ONLY_IN_LONG_RUNS                                                                                        \
    if (!burin::testing::longRun()) QSKIP("in tests/run --long")
