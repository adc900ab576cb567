// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A kind of plugin: each plugin is a folder below `plugins/<folder>` with plugin.json and the library that it names.
struct PluginKind {
    std::string_view name;   ///< value of the key "kind"
    std::string_view folder; ///< below pluginDirectory()
    int interfaceVersion = 0;
    std::span<const std::string_view> furtherKeys; ///< texts that its metadata must have besides the common ones
};

/// Metadata of a plugin, read without running its code: plugin.json has exactly the keys "id", "kind", "name",
/// "version", "library", "interface_version" and those of its kind.
struct PluginDescription {
    std::string id, name, version;
    int interfaceVersion = 0;
    std::filesystem::path library;
    std::map<std::string, std::string, std::less<>> further; ///< texts of the keys of its kind
};

/// Folder of the user's own plugins of a kind: $XDG_DATA_HOME/burin/plugins/<folder>, or below ~/.local/share if that
/// is not set. Need not exist; empty if there is no home folder either.
std::filesystem::path userPluginDirectory(const PluginKind& kind);

/// Descriptions of all plugins of a kind below `folder` (default: the kind's folder in pluginDirectory()), sorted by
/// id. With `faults`, a plugin with invalid metadata is reported there and left out; otherwise it is the error. Errors:
/// fileNotFound (the folder), fileNotReadable, pluginInvalid (subject: plugin.json).
Result<std::vector<PluginDescription>> findPlugins(const PluginKind& kind, const std::filesystem::path& folder = {},
                                                   std::vector<Error>* faults = nullptr);

/// The function that a plugin exports as `entryPoint`. Once loaded, the code of a plugin stays loaded for the life of
/// the process, so that its objects may have any lifetime. Errors: pluginIncompatible (interface version),
/// pluginInvalid (cannot be loaded, has no entry point).
Result<void*> loadPlugin(const PluginKind& kind, const PluginDescription& description, const char* entryPoint);

} // namespace burin
