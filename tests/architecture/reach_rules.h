// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace burin::architecture {

/// Sources and headers of core that no program of Burin reaches, sorted, relative to `root`: what only tests and
/// benchmarks use.
///
/// All of app, ui and plugins is reached, the import program among it. What is reached reaches
/// - the headers that it includes;
/// - of a reached header the source of the same name beside it;
/// - any other source that defines what a reached header of its room declares, where something reached, other than that
///   header, mentions the name of it.
/// The text is looked at, not the linker's choice. So a function that nobody calls is missed where its neighbours in
/// the same file are called.
std::vector<std::string> unreachedSources(const std::filesystem::path& root);

/// Why code stays that no program reaches, by its path without the ending: the table of a page, whose columns are
/// called "source" and "waits for".
std::map<std::string, std::string> reasonsToStay(const std::filesystem::path& page);

/// What is wrong between the two, one sentence each: an unreached source without a reason, a reason that is no longer
/// needed, or empty.
std::vector<std::string> faultsOfReasons(const std::vector<std::string>& unreached,
                                         const std::map<std::string, std::string>& reasons);

} // namespace burin::architecture
