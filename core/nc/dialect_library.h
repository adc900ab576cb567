// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/control.h"
#include "core/nc/dialect.h"

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

namespace burin {

struct DialectDescription {
    std::string id;      ///< "linuxcnc"
    std::string name;    ///< "LinuxCNC"
    std::string version; ///< of a plugin; empty for data
    int interfaceVersion = 0;
    std::string fileSuffix;        ///< "ngc"
    std::string control;           ///< of data: the id of the Control that reads it; of a plugin: its own id
    std::filesystem::path library; ///< of a plugin; empty for data
};

struct DialectList {
    std::vector<DialectDescription> known; ///< sorted by id
    std::vector<Error> faults;             ///< of what can't be read, with its file: resourceInvalid, pluginInvalid
};

/// All dialects: those that are data (resources/dialects and the user's own, which replace ours of the same id), and
/// plugins below `folder` (default: dialects in pluginDirectory(), which may be missing), described without running
/// their code. With a folder given only its plugins are listed. One id for both kinds: the data counts. A folder of
/// plugins with a fault in it gives none.
DialectList dialects(const std::filesystem::path& folder = {});

/// The control that reads a dialect's programs: of data the one that it names, of a plugin one of the plugin's own id;
/// LinuxCNC's where there is none.
const Control& controlOfDialect(const std::string& id);

/// A post-processor: data, or out of a plugin, which stays loaded as long as the program runs. With a folder given only
/// its plugins count. Errors: dialectNotFound, resourceInvalid (data), pluginIncompatible (interface version),
/// pluginInvalid (does not load, no entry point).
Result<std::shared_ptr<const PostProcessor>> loadDialect(const std::string& id,
                                                         const std::filesystem::path& folder = {});

/// A program's text with comments at its head, as its dialect words them: behind a tape mark and a program number.
/// Everything else stays as it is, so many lines further down. Comments of a plugin's dialect stand between ( and ).
/// @param lineLength characters that a line may have. Errors: resourceInvalid.
Result<std::string> withHeaderComments(std::string_view text, const std::vector<std::string>& comments,
                                       const std::string& dialect, int lineLength);

} // namespace burin
