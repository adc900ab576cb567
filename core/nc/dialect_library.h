// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/dialect.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace burin {

struct DialectDescription {
    std::string id;          ///< "linuxcnc"
    std::string name;        ///< "LinuxCNC"
    std::string version;
    int interfaceVersion = 0;
    std::string fileSuffix;  ///< "ngc"
    std::filesystem::path library;
};

/// Descriptions of all dialect plugins below `folder` (default: dialects in pluginDirectory()), read without running
/// their code, sorted by id. Invalid metadata is an error that names the file.
Result<std::vector<DialectDescription>> dialects(const std::filesystem::path& folder = {});

/// A post-processor out of a plugin; the plugin stays loaded as long as it lives.
/// Errors: dialectNotFound, pluginIncompatible (interface version), pluginInvalid (does not load, no entry point).
Result<std::shared_ptr<const PostProcessor>> loadDialect(const std::string& id,
                                                         const std::filesystem::path& folder = {});

} // namespace burin
