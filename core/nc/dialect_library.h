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
    std::vector<Error> faults;             ///< of files that cannot be read: resourceInvalid, pluginInvalid
};

/// All dialects: those defined by data (resources/dialects and those of the user, which replace ours of the same id),
/// and plugins below `folder` (default: dialects in pluginDirectory(), which may be missing), described without running
/// their code. If a folder is given, only its plugins are listed. If an id exists as data and as a plugin, the data is
/// used. A plugin folder with an error in it provides no dialect.
DialectList dialects(const std::filesystem::path& folder = {});

/// The control that reads the programs of a dialect: for data the one that it names, for a plugin the one with the
/// plugin's own id; LinuxCNC's if there is none.
/// @param axes of the machine, see withRotaryAxes
const Control& controlOfDialect(const std::string& id, AxisSet axes = linearAxes);

/// A post-processor, from data or from a plugin, which stays loaded until Burin ends. If a folder is given, only its
/// plugins are considered. Errors: dialectNotFound, resourceInvalid (data), pluginIncompatible (interface version),
/// pluginInvalid (does not load, no entry point).
Result<std::shared_ptr<const PostProcessor>> loadDialect(const std::string& id,
                                                         const std::filesystem::path& folder = {});

/// The text of a program with comments at its head, in the form of its dialect: after a tape mark and a program number.
/// Everything else is unchanged, only that many lines further down. In the dialect of a plugin, comments are enclosed
/// in ( and ).
/// @param lineLength largest length of a line, characters. Errors: resourceInvalid.
Result<std::string> withHeaderComments(std::string_view text, const std::vector<std::string>& comments,
                                       const std::string& dialect, int lineLength);

} // namespace burin
