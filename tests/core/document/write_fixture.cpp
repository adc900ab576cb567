// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/document/sample_project.h"

#include <cstdio>

/// Writes the project of tests/fixtures/projects/v<version>; run once for each released format, never again.
int main(int count, char** arguments) {
    if (count == 2 && burin::fixture::fillProject(arguments[1])) return 0;
    std::fputs("usage: burin_write_project_fixture FILE\n", stderr);
    return 2;
}
