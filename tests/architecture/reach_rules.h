// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace burin::architecture {

/// Sources and headers of core that no program of Burin reaches, sorted, relative to `root`: those that only tests and
/// benchmarks use.
///
/// All of app, ui and plugins counts as reached, including the import program. A reached file reaches
/// - the headers that it includes;
/// - for a reached header, the source of the same name in its folder;
/// - any other source that defines something declared by a reached header of its room, if a reached file other than
/// that header mentions its name.
/// The text is examined, not the linker's choice. So a function that nobody calls is missed if its neighbours in the
/// same file are called.
std::vector<std::string> unreachedSources(const std::filesystem::path& root);

/// The reasons for keeping code that no program reaches, by its path without the ending: the table of a page whose
/// columns are called "source" and "waits for".
std::map<std::string, std::string> reasonsToStay(const std::filesystem::path& page);

/// Inconsistencies between the two, one sentence each: an unreached source without a reason, a reason that is no longer
/// needed, or an empty one.
std::vector<std::string> faultsOfReasons(const std::vector<std::string>& unreached,
                                         const std::map<std::string, std::string>& reasons);

} // namespace burin::architecture
