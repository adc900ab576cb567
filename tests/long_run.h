// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtGlobal>

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

/// Placed before a test function that the usual run leaves out, because it takes long and other tests cover what it has
/// in common with them. moc keeps it as the tag of the function, by which runTest (tests/test_program.h) finds it, so
/// that `init` prepares nothing for it. A function that is named on the command line is run in any case.
#ifndef Q_MOC_RUN
#define BURIN_ONLY_IN_LONG_RUNS
#endif
