// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace burin::fuzz {

/// Changes a project file like libFuzzer's LLVMFuzzerCustomMutator. Mostly it changes one value of one row in a
/// database that remains valid, with no digest to reveal it, as arbitrary changed bytes are detected before any row is
/// read. Otherwise it changes bytes. @return  the new size, at most `most`.
std::size_t mutateProject(std::uint8_t* bytes, std::size_t count, std::size_t most, unsigned seed);

} // namespace burin::fuzz
