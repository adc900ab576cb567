// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"

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

} // namespace

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
