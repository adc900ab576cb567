// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
extern "C" [[gnu::visibility("default")]] int somethingElse() {
    return 0;
}
