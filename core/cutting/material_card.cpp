// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/material_card.h"

#include "core/base/clean_text.h"
#include "core/base/numbers.h"
#include "core/base/trimmed.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>

namespace burin {

namespace {

constexpr std::size_t longest = 1'000'000; // characters
constexpr std::size_t mostEntries = 10'000;
constexpr std::size_t deepest = 8; // indentations and brackets; a real card has three levels

Error unknown(const std::string& origin) {
    return {ErrorCode::fileFormatUnknown, origin, {}, {}};
}

/// Whether there is "[FCMat]" or "[General]" on a separate line, with only comments before it.
bool hasSections(std::string_view text) {
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        const std::string_view content = trimmed(line);
        if (content.empty() || content.front() == ';' || content.front() == '#') continue;
        return content.front() == '[' && content.back() == ']';
    }
    return false;
}

Result<MaterialCard> readSections(std::string_view text, const std::string& origin) {
    MaterialCard card;
    std::istringstream lines{std::string(text)};
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const std::string_view content = trimmed(line);
        if (content.empty() || content.front() == ';' || content.front() == '#' || content.front() == '[') continue;
        const std::size_t equals = content.find('=');
        if (equals == std::string_view::npos)
            return Error{ErrorCode::resourceInvalid, origin, "line " + std::to_string(number), "has no ="};
        card.values.try_emplace(std::string(trimmed(content.substr(0, equals))),
                                cleanLine(trimmed(content.substr(equals + 1))));
    }
    return card;
}

/// Flow brackets may be nested arbitrarily deep, and the parser recurses with them, so such a text is rejected before
/// parsing.
bool nestsTooDeep(std::string_view text) {
    std::size_t depth = 0;
    for (const char character : text) {
        if (character == '[' || character == '{') ++depth;
        if ((character == ']' || character == '}') && depth > 0) --depth;
        if (depth > deepest) return true;
    }
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        const std::size_t indent = line.find_first_not_of(' ');
        if (indent != std::string::npos && indent > 120) return true;
        if (std::ranges::count(line, '-') > 200 || std::ranges::count(line, '?') > 200) return true;
    }
    return false;
}

/// Collects the entries of the deepest level; the first one of each name counts.
/// @param left number of entries still to be read, limited because aliases can make a short text arbitrarily long
void collect(const YAML::Node& node, MaterialCard& card, std::size_t depth, std::size_t& left) {
    if (!node.IsMap() || depth > deepest) return;
    for (const auto& entry : node) {
        if (left == 0) return;
        --left;
        if (!entry.first.IsScalar()) continue;
        if (entry.second.IsScalar())
            card.values.try_emplace(entry.first.Scalar(), cleanLine(trimmed(entry.second.Scalar())));
        else
            collect(entry.second, card, depth + 1, left);
    }
}

Result<MaterialCard> readYaml(std::string_view text, const std::string& origin) try {
    if (nestsTooDeep(text)) return unknown(origin);
    const YAML::Node whole = YAML::Load(std::string(text));
    if (!whole.IsMap() || !whole["General"]) return unknown(origin);
    MaterialCard card;
    std::size_t left = mostEntries;
    collect(whole["General"], card, 0, left);
    for (const char* part : {"Models", "AppearanceModels"})
        if (whole[part]) collect(whole[part], card, 0, left);
    return card;
} catch (const YAML::Exception& wrong) {
    const std::string place =
        wrong.mark.is_null() ? std::string("text") : "line " + std::to_string(wrong.mark.line + 1);
    return Error{ErrorCode::resourceInvalid, origin, place, wrong.msg};
}

} // namespace

Result<MaterialCard> readMaterialCard(std::string_view text, const std::string& origin) {
    if (text.size() > longest || text.find('\0') != std::string_view::npos) return unknown(origin);
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    return hasSections(text) ? readSections(text, origin) : readYaml(text, origin);
}

} // namespace burin
