// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QTest>

#include <type_traits>

namespace burin {

/// Stands where a test needs no application object.
struct NoApplication {
    NoApplication(int& /*argc*/, char** /*argv*/) {}
};

/// One test class of a folder's program.
struct RegisteredTest {
    const char* file; ///< its source, by whose name main() finds it
    int (*run)(int argc, char** argv);
};

/// Makes `test` known to main() (tests/test_program.cpp). Before main() alone.
bool registerTest(const RegisteredTest& test);

/// Runs every function of Test that the arguments, those of QtTest, ask for; returns QtTest's status.
template <typename Test, typename Application>
int runTest(int argc, char** argv) {
    Application application(argc, argv);
    if constexpr (std::is_base_of_v<QCoreApplication, Application>) application.setAttribute(Qt::AA_Use96Dpi);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace burin

/// Ends the namespace of a test's source, in place of QTEST_MAIN: the tests of a folder share a program.
#define BURIN_TEST(Test, Application)                                                                                  \
    [[maybe_unused]] static const bool registered##Test =                                                              \
        burin::registerTest({__FILE__, &burin::runTest<Test, Application>});
