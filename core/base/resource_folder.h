// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A kind of data file that Burin is shipped with and the user may add to: `<id>.json` in one folder.
struct ResourceKind {
    std::string_view name;   ///< "tool", the subject of nameUnknown
    std::string_view folder; ///< "tools", below the folders of resources
};
inline constexpr ResourceKind materialResource{"material", "materials"};
inline constexpr ResourceKind toolResource{"tool", "tools"};
inline constexpr ResourceKind holderResource{"holder", "holders"};
inline constexpr ResourceKind machineResource{"machine", "machines"};
inline constexpr ResourceKind dialectResource{"dialect", "dialects"};

/// A data file as it was read.
struct ResourceText {
    std::string text;
    std::string file; ///< path, for messages
};

/// Folder of the user's own files of a kind: $XDG_DATA_HOME/burin/<folder>, or ~/.local/share/burin/<folder> where
/// that is not set. Need not exist; empty when there is no home either.
std::filesystem::path userResourceDirectory(ResourceKind kind);

/// Folders that are searched, the user's first: it may replace what Burin is shipped with.
std::vector<std::filesystem::path> resourceSearchPath(ResourceKind kind);

/// Made of letters, digits, '-', '_' and '.', a letter or digit first, so that it can't lead out of a folder.
bool isResourceId(std::string_view id);

/// An id made of a name: "Aluminum (Soft Wrought Alloy)" becomes "aluminum-soft-wrought-alloy"; empty where it has
/// neither letters nor digits of ASCII.
std::string resourceIdFrom(std::string_view name);

/// `wanted`, or with the first number behind it, from 2 on, that is free. @param taken whether an id is not
template <class Taken>
std::string freeResourceId(const std::string& wanted, Taken taken) {
    std::string id = wanted;
    for (int i = 2; taken(id); ++i) id = wanted + "-" + std::to_string(i);
    return id;
}

/// The file of `id` from the first folder that has it.
/// Errors: nameUnknown (detail: ids that exist; of many, the most alike), those of readFile.
Result<ResourceText> findResource(ResourceKind kind, std::string_view id);

/// Ids of all files of a kind, sorted, each once.
std::vector<std::string> resourceIds(ResourceKind kind);

/// Burin is shipped with a file of this id; the user's own may stand before it.
bool isShipped(ResourceKind kind, std::string_view id);
/// The user has a file of this id.
bool isOfUser(ResourceKind kind, std::string_view id);

/// The user's own file of `id`, whether it is there or not. Errors: argumentInvalid (no id of a file),
/// fileNotWritable (there is no home folder).
Result<std::filesystem::path> userResourceFile(ResourceKind kind, const std::string& id);
/// Writes the user's own file of `id`, its folder too where that is missing; the old content stands until the new one
/// is complete. @return the file. Errors: those of userResourceFile and writeFileAtomically.
Result<std::filesystem::path> saveUserResource(ResourceKind kind, const std::string& id, std::string_view content);
/// Deletes the user's own file of `id`. Errors: those of userResourceFile, nameUnknown (the user has none; detail: the
/// ids of those that the user has), fileNotWritable.
Result<void> removeUserResource(ResourceKind kind, const std::string& id);

} // namespace burin
