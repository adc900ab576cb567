// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/resource_folder.h"
#include "core/base/result.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// State of one of the user's files in a library of tools, machines or materials: its item, or empty if the file does
/// not exist. An entry of the undo stack switches between two such states. The files are a few kilobytes and are
/// written before the change is shown.
template <class Item>
struct OwnFile {
    std::string id;
    std::optional<Item> item;
};

/// @param save takes an item and whether to replace one of the same id @param remove takes an id
template <class Item, class Save, class Remove>
Result<void> write(const OwnFile<Item>& own, Save save, Remove remove) {
    if (!own.item) return remove(own.id);
    const auto file = save(*own.item, true);
    return file ? Result<void>() : Result<void>(file.error());
}

/// The item with the given id, if `items` contains one.
template <class Item>
std::optional<Item> itemOf(const std::vector<Item>& items, const std::string& id) {
    const auto found = std::ranges::find(items, id, &Item::id);
    return found == items.end() ? std::nullopt : std::optional(*found);
}

/// Returns `wanted`, with a number appended if one of `items` has that id already.
template <class Item>
std::string freeId(const std::vector<Item>& items, const std::string& wanted) {
    return freeResourceId(
        wanted, [&](const std::string& id) { return std::ranges::find(items, id, &Item::id) != items.end(); });
}

} // namespace burin
