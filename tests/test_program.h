// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QTest>

#include <type_traits>
#include <vector>

namespace burin {

/// Used by tests that need no application object.
struct NoApplication {
    NoApplication(int& /*argc*/, char** /*argv*/) {}
};

/// One test class of a folder's program.
struct RegisteredTest {
    const char* file; ///< its source file, by whose name main() finds it
    int (*run)(int argc, char** argv);
};

/// Registers `test` for main() (tests/test_program.cpp). To be called before main() only.
bool registerTest(const RegisteredTest& test);

/// Completes the arguments of a test, which are those of QtTest: unless they name functions of it, or the run is a long
/// one, with its functions that are not marked by BURIN_ONLY_IN_LONG_RUNS (tests/long_run.h).
std::vector<QByteArray> withFunctions(const QMetaObject& test, std::vector<QByteArray> arguments);

/// Runs the functions of Test that the arguments request; returns QtTest's status.
template <typename Test, typename Application>
int runTest(int argc, char** argv) {
    Application application(argc, argv);
    if constexpr (std::is_base_of_v<QCoreApplication, Application>) application.setAttribute(Qt::AA_Use96Dpi);
    Test test;
    std::vector<QByteArray> arguments = withFunctions(Test::staticMetaObject, {argv, argv + argc});
    std::vector<char*> values;
    for (QByteArray& argument : arguments) values.push_back(argument.data());
    return QTest::qExec(&test, static_cast<int>(values.size()), values.data());
}

} // namespace burin

/// Placed at the end of the namespace of a test's source instead of QTEST_MAIN, as the tests of a folder share a
/// program.
#define BURIN_TEST(Test, Application)                                                                                  \
    [[maybe_unused]] static const bool registered##Test =                                                              \
        burin::registerTest({__FILE__, &burin::runTest<Test, Application>});
