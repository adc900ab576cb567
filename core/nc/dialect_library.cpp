// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/dialect_library.h"

#include "core/base/plugin_library.h"

#include <array>

namespace burin {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 1> furtherKeys{"file_suffix"};
constexpr PluginKind dialectPlugin{"dialect", "dialects", PostProcessor::interfaceVersion, furtherKeys};

DialectDescription dialectOf(const PluginDescription& plugin) {
    return {plugin.id,     plugin.name, plugin.version, plugin.interfaceVersion, plugin.further.at("file_suffix"),
            plugin.library};
}

Error invalid(const PluginDescription& plugin, std::string detail) {
    return Error{ErrorCode::pluginInvalid, plugin.library.string(), "", std::move(detail)};
}

Result<std::shared_ptr<const PostProcessor>> create(const PluginDescription& plugin) {
    const Result<void*> symbol = loadPlugin(dialectPlugin, plugin, dialectEntryPoint);
    if (!symbol) return symbol.error();
    const auto function = reinterpret_cast<CreatePostProcessor>(*symbol); // POSIX: dlsym gives functions as void*
    std::shared_ptr<const PostProcessor> post;
    try {
        post.reset(function());
    } catch (...) { // a fault of foreign code must not pass our border
        return invalid(plugin, "its entry point threw");
    }
    if (!post) return invalid(plugin, "its entry point gave nothing");
    return post;
}

} // namespace

Result<std::vector<DialectDescription>> dialects(const fs::path& folder) {
    const auto plugins = findPlugins(dialectPlugin, folder);
    if (!plugins) return plugins.error();
    std::vector<DialectDescription> found;
    for (const PluginDescription& plugin : *plugins) found.push_back(dialectOf(plugin));
    return found;
}

Result<std::shared_ptr<const PostProcessor>> loadDialect(const std::string& id, const fs::path& folder) {
    const auto plugins = findPlugins(dialectPlugin, folder);
    if (!plugins) return plugins.error();
    std::string ids;
    for (const PluginDescription& plugin : *plugins) {
        if (plugin.id == id) return create(plugin);
        ids += (ids.empty() ? "" : " ") + plugin.id;
    }
    return Error{ErrorCode::dialectNotFound, id, "", ids};
}

} // namespace burin
