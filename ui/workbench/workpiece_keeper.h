// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/mill_controller.h"

#include <QTimer>

#include <map>
#include <optional>

namespace burin {

/// Stores the workpiece in the project as its recordings left it when the hand has been at rest, so that opening the
/// project need not cut again. Its hash is computed at the same time. In the background; failing to store it is no
/// error.
class WorkpieceKeeper final : public Controller {
    Q_OBJECT
public:
    WorkpieceKeeper(const Desk& desk, WorkpieceController& workpiece, SessionRunner& session, MillController& mill,
                    QObject* parent);
    /// The project or setup has changed.
    void forget();
    /// Hash of the present workpiece (core/volume/operations/fingerprint.h); empty if not known yet.
    const std::optional<std::uint64_t>& hash() const noexcept { return hash_; }

private:
    void wait();
    void keep();
    /// The project's information about the present workpiece.
    struct Requested {
        RecordedState state;
        bool keeps = false; ///< not stored yet, and may be stored
    };
    void look(const Requested& wanted, std::map<std::int64_t, std::size_t> strokes, VolumeSnapshot workpiece);
    void store(const RecordedState& state, KeptWorkpiece kept);

    WorkpieceController& workpiece_;
    SessionRunner& session_;
    MillController& mill_;
    QTimer rest_;
    quint64 generation_ = 0; ///< counts changes of the workpiece
    std::optional<std::uint64_t> hash_;
};

} // namespace burin
