// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"

#include "tests/long_run.h"

#include <QMetaMethod>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace burin {
namespace {

std::vector<RegisteredTest>& registeredTests() {
    static std::vector<RegisteredTest> tests;
    return tests;
}

std::string nameOf(const RegisteredTest& test) {
    constexpr std::size_t prefix = std::string_view("tst_").size();
    return std::filesystem::path(test.file).stem().string().substr(prefix);
}

/// Whether QtTest runs a method of a test as one of its functions.
bool isTestFunction(const QMetaMethod& method) {
    static constexpr std::array others = {"initTestCase", "cleanupTestCase", "init", "cleanup"};
    const QByteArray name = method.name();
    return method.access() == QMetaMethod::Private && method.methodType() == QMetaMethod::Slot &&
           method.parameterCount() == 0 && method.returnType() == QMetaType::Void && !name.endsWith("_data") &&
           std::find(others.begin(), others.end(), name) == others.end();
}

/// Returns the functions of a test, all or without those of the long run.
std::vector<QByteArray> functionsOf(const QMetaObject& test, bool all) {
    std::vector<QByteArray> names;
    for (int i = test.methodOffset(); i < test.methodCount(); ++i) {
        const QMetaMethod method = test.method(i);
        if (isTestFunction(method) && (all || qstrcmp(method.tag(), "BURIN_ONLY_IN_LONG_RUNS") != 0))
            names.push_back(method.name());
    }
    return names;
}

bool namesAFunction(const QMetaObject& test, const std::vector<QByteArray>& arguments) {
    const std::vector<QByteArray> functions = functionsOf(test, true);
    return std::any_of(arguments.begin(), arguments.end(), [&](const QByteArray& argument) {
        const QByteArray name = argument.split(':').front(); // FUNCTION:ROW
        return std::find(functions.begin(), functions.end(), name) != functions.end();
    });
}

} // namespace

std::vector<QByteArray> withFunctions(const QMetaObject& test, std::vector<QByteArray> arguments) {
    if (testing::longRun() || namesAFunction(test, arguments)) return arguments;
    const std::vector<QByteArray> usual = functionsOf(test, false);
    if (usual.empty()) qFatal("All functions of this test are for long runs: set BURIN_LONG_RUN, or name one.");
    arguments.insert(arguments.end(), usual.begin(), usual.end());
    return arguments;
}

bool registerTest(const RegisteredTest& test) {
    registeredTests().push_back(test);
    return true;
}

} // namespace burin

int main(int argc, char* argv[]) {
    const std::string wanted = argc > 1 ? argv[1] : "";
    for (const burin::RegisteredTest& test : burin::registeredTests()) {
        if (burin::nameOf(test) != wanted) continue;
        // Applications name their files after the program: each test gets its own name.
        std::string program = std::string(argv[0]) + '_' + wanted;
        argv[1] = program.data();
        return test.run(argc - 1, argv + 1);
    }
    std::fprintf(stderr, "Usage: %s TEST [options of QtTest], where TEST is one of:\n", argv[0]);
    for (const burin::RegisteredTest& test : burin::registeredTests())
        std::fprintf(stderr, "  %s\n", burin::nameOf(test).c_str());
    return 2;
}
