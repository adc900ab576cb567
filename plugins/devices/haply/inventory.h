// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace burin::haply {

/// The device ids of the arms listed in the service's first message; empty if it is not such a message.
std::vector<std::string> armsOf(std::string_view message);

} // namespace burin::haply
