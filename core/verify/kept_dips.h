// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/part_guard.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace burin {

/// Where moves come nearest to bodies, by the numbers of the moves (KnownMoves): it depends on nothing else, as long as
/// tools, bodies and tolerances are the same.
class KeptDips {
public:
    /// The answers for one body and one section of the tools.
    class List {
    public:
        /// False: not known yet.
        bool find(std::uint32_t number, std::optional<PartGuard::Dip>& dip) const {
            if (number >= dips_.size() || !dips_[number].known) return false;
            dip = dips_[number].dip;
            return true;
        }
        void keep(std::uint32_t number, const std::optional<PartGuard::Dip>& dip) {
            if (number >= dips_.size()) dips_.resize(std::size_t{number} + 1);
            dips_[number] = {true, dip};
        }
        std::size_t bytes() const noexcept { return dips_.capacity() * sizeof(Known); }

    private:
        struct Known {
            bool known = false;
            std::optional<PartGuard::Dip> dip;
        };
        std::vector<Known> dips_; ///< by number
    };

    /// @param question any number that stands for a body and a section
    List& of(std::size_t question) { return lists_[question]; }
    std::size_t bytes() const noexcept {
        std::size_t bytes = 0;
        for (const auto& [question, list] : lists_) bytes += list.bytes();
        return bytes;
    }

private:
    std::map<std::size_t, List> lists_;
};

} // namespace burin
