// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/dialect_library.h"

#include "core/base/plugin_library.h"
#include "core/base/resource_folder.h"
#include "core/nc/block_writer.h"
#include "core/nc/data_post.h"

#include <algorithm>
#include <array>

namespace burin {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 1> furtherKeys{"file_suffix"};
constexpr PluginKind dialectPlugin{"dialect", "dialects", PostProcessor::interfaceVersion, furtherKeys};

DialectDescription dialectOf(const PluginDescription& plugin) {
    return {plugin.id, plugin.name,   plugin.version, plugin.interfaceVersion, plugin.further.at("file_suffix"),
            plugin.id, plugin.library};
}

Result<DialectData> readData(const std::string& id) {
    const Result<ResourceText> file = findResource(dialectResource, id);
    if (!file) return file.error();
    Result<DialectData> dialect = dialectFromJson(file->text, file->file);
    if (dialect && dialect->id != id)
        return Error{ErrorCode::resourceInvalid, file->file, "id", "has to be the file's name"};
    return dialect;
}

/// The default folder of plugins may be missing.
Result<std::vector<PluginDescription>> pluginsBelow(const fs::path& folder) {
    auto plugins = findPlugins(dialectPlugin, folder);
    if (!plugins && folder.empty() && plugins.error().code == ErrorCode::fileNotFound)
        return std::vector<PluginDescription>();
    return plugins;
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
    } catch (...) { // exceptions of foreign code must not pass this boundary
        return invalid(plugin, "its entry point threw");
    }
    if (!post) return invalid(plugin, "its entry point gave nothing");
    return post;
}

class Lines final : public LineSink {
public:
    Result<void> line(std::string_view content) override {
        text += content;
        text += '\n';
        return {};
    }
    std::string text;
};

/// Number of characters in the lines that must stay at a program's head: a tape mark, a program number.
std::size_t frameLength(std::string_view text) {
    std::size_t length = 0;
    while (length < text.size() && (text[length] == '%' || text[length] == 'O')) {
        const std::size_t end = text.find('\n', length);
        if (end == std::string_view::npos) return length;
        length = end + 1;
    }
    return length;
}

} // namespace

DialectList dialects(const fs::path& folder) {
    DialectList found;
    std::vector<DialectDescription>& known = found.known;
    for (const std::string& id : folder.empty() ? resourceIds(dialectResource) : std::vector<std::string>()) {
        if (const Result<DialectData> data = readData(id))
            known.push_back({id, data->name, "", PostProcessor::interfaceVersion, data->fileSuffix, data->control, {}});
        else
            found.faults.push_back(data.error());
    }
    if (const auto plugins = pluginsBelow(folder)) {
        for (const PluginDescription& plugin : *plugins)
            if (std::ranges::find(known, plugin.id, &DialectDescription::id) == known.end())
                known.push_back(dialectOf(plugin));
    } else {
        found.faults.push_back(plugins.error());
    }
    std::ranges::sort(known, {}, &DialectDescription::id);
    return found;
}

const Control& controlOfDialect(const std::string& id, AxisSet axes) {
    const Result<DialectData> data = readData(id);
    const Control* control = findControl(data ? data->control : id);
    return withRotaryAxes(control != nullptr ? *control : defaultControl(), axes);
}

Result<std::shared_ptr<const PostProcessor>> loadDialect(const std::string& id, const fs::path& folder) {
    std::vector<std::string> known;
    if (folder.empty()) {
        known = resourceIds(dialectResource);
        if (std::ranges::find(known, id) != known.end()) {
            Result<DialectData> data = readData(id);
            if (!data) return std::move(data).error();
            return std::shared_ptr<const PostProcessor>(std::make_shared<DataPost>(std::move(*data)));
        }
    }
    const auto plugins = pluginsBelow(folder);
    if (!plugins) return plugins.error();
    for (const PluginDescription& plugin : *plugins) {
        if (plugin.id == id) return create(plugin);
        known.push_back(plugin.id);
    }
    std::ranges::sort(known);
    std::string ids;
    for (const std::string& one : known) ids += (ids.empty() ? "" : " ") + one;
    return Error{ErrorCode::dialectNotFound, id, "", ids};
}

Result<std::string> withHeaderComments(std::string_view text, const std::vector<std::string>& comments,
                                       const std::string& dialect, int lineLength) {
    DialectData words;
    words.commentOpen = "(";
    words.commentClose = ")";
    const std::vector<std::string> known = resourceIds(dialectResource);
    if (std::ranges::find(known, dialect) != known.end()) {
        Result<DialectData> data = readData(dialect);
        if (!data) return std::move(data).error();
        words = std::move(*data);
    }
    Lines head;
    BlockWriter writer(words, std::min(lineLength, words.lineLength), head);
    for (const std::string& comment : comments)
        if (Result<void> done = writer.comment(comment); !done) return done.error();
    const std::size_t frame = frameLength(text);
    return std::string(text.substr(0, frame)) + head.text + std::string(text.substr(frame));
}

} // namespace burin
