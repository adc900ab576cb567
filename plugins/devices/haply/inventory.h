// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace burin::haply {

/// The device ids of the arms that the service's first message lists; none where it is no such message.
std::vector<std::string> armsOf(std::string_view message);

} // namespace burin::haply
