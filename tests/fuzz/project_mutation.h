// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace burin::fuzz {

/// As libFuzzer's LLVMFuzzerCustomMutator: changes a project file. Mostly one value of one row in a database that stays
/// sound, with no digest that would tell of it: what a changed byte anywhere breaks is found before any row is read.
/// Else bytes. @return the new size, at most `most`.
std::size_t mutateProject(std::uint8_t* bytes, std::size_t count, std::size_t most, unsigned seed);

} // namespace burin::fuzz
