// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/wording.h"

#include "core/base/filled.h"
#include "ui/messages/messages.h"

namespace burin {

std::string worded(TextId text, std::initializer_list<std::string> values) {
    return filled(Messages::text(text).toStdString(), std::span(values.begin(), values.size()));
}

std::string worded(std::size_t count, TextId one, TextId many, std::initializer_list<std::string> values) {
    std::vector<std::string> all{std::to_string(count)};
    all.insert(all.end(), values);
    return filled(Messages::text(count == 1 ? one : many).toStdString(), all);
}

std::string resourceName(const std::string& name) {
    return Messages::resourceName(name).toStdString();
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

Error wrongArgument(const char* option, const std::string& text, TextId allowed) {
    return {ErrorCode::argumentInvalid, option, text, worded(allowed)};
}

} // namespace burin
