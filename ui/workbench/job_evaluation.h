// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/job_paths.h"
#include "ui/workbench/workpiece_controller.h"

#include <memory>
#include <optional>
#include <tuple>
#include <vector>

namespace burin {

/// What is recorded with a tool: of each take its id, samples, whether it is complete, and the number of the newest
/// stroke that stands. Equal where just the same is recorded, also after strokes were milled and taken back.
using RecordedKey = std::vector<std::tuple<std::int64_t, std::uint64_t, bool, std::uint64_t>>;

/// Evaluates the paths of a job in the background, one after the other, each on the stock as those before it leave it:
/// first what the one in force comes after and itself, then the others. A path is evaluated again where it, or one
/// before it, has changed; what stood before stays meanwhile.
class JobEvaluation final : public QObject {
    Q_OBJECT
public:
    JobEvaluation(const Desk& desk, WorkpieceController& workpiece, QObject* parent);

    /// What is to be evaluated. Paths that it knows by their ids keep what is known of them, also those that were not
    /// among the last ones.
    /// @param inOrder in which they are milled. @param inForce id; 0: none
    void setJob(const std::vector<StoredPath>& inOrder, std::int64_t inForce);
    /// Edits of a path are others, or what all paths were evaluated on is.
    void touch(std::int64_t path);
    void touchAll();
    /// What is recorded with its tool. Where it is other than before, what was read of it is of no use any more; where
    /// it is again what the path was evaluated with, the path is current again.
    void setRecorded(std::int64_t path, const RecordedKey& key);
    void forget();                            ///< another project: nothing stands of what was evaluated or read
    void start();                             ///< evaluates what is out of date
    void hold() noexcept { wanted_ = false; } ///< what comes out of date from now on waits for `start`

    /// Of the newest evaluation that went well; null: none yet.
    std::shared_ptr<const EvaluatedPath> evaluated(std::int64_t path) const;
    std::vector<std::shared_ptr<const EvaluatedPath>> allBut(std::int64_t path) const; ///< that there are, in order
    std::optional<Error> problem(std::int64_t path) const;                             ///< of the newest evaluation
    /// What should be milled before a path and can't be evaluated: the stock is taken as if it were not there.
    std::vector<std::int64_t> missingBefore(std::int64_t path) const;
    /// What is evaluated is as the path, and all before it, are now.
    bool isCurrent(std::int64_t path) const;
    /// It, or what it comes after, is being evaluated.
    bool busy(std::int64_t path) const;

signals:
    void evaluatedAnew(qint64 path);
    void changed();
    /// What was recorded since with its tool was added to a path.
    void recordingsAdded(const burin::StoredPath& path);

private:
    using Before = std::vector<std::shared_ptr<const EvaluatedPath>>;
    struct Recorded {
        std::vector<SourceStrokes> strokes;
        Tool tool;
    };
    /// What an evaluation stands on.
    struct Basis {
        quint64 revision = 0; ///< of the path
        RecordedKey key;
        Before before;
        bool operator==(const Basis&) const = default;
    };
    struct Entry {
        StoredPath path;
        quint64 revision = 1;
        RecordedKey key;
        std::shared_ptr<const Recorded> recorded; ///< null: to be read
        std::shared_ptr<const EvaluatedPath> evaluated;
        Tool tool; ///< that `evaluated` was made with
        Basis evaluatedOn, failedOn;
        std::optional<Error> problem;
    };
    struct Running {
        std::int64_t path = 0;
        Basis basis;
    };
    std::size_t placeOf(std::int64_t path) const; ///< the number of entries: none
    const Entry* find(std::int64_t path) const;
    Entry* find(std::int64_t path);
    static bool isImpossible(const Entry& entry);
    bool isCurrent(const Entry& entry, const Basis& basis) const;
    bool isSettled(const Entry& entry, const Basis& basis) const;
    bool isSettledUpTo(std::int64_t path) const;
    Basis basisOf(const Entry& entry) const;
    std::vector<MilledPath> milledBefore(const Entry& entry) const;
    Entry* next();
    void goOn();
    void read(const Entry& entry);
    void takeRecorded(std::int64_t id, const Basis& asked, Result<PathMatter> matter);
    void evaluate(const Entry& entry, const Basis& basis);
    void takeEvaluated(const Running& asked, const Tool& tool, Result<EvaluatedPath> outcome);
    void readersStop();

    Desk desk_;
    WorkpieceController& workpiece_;
    std::vector<Entry> entries_; ///< in the order in which they are milled
    std::vector<Entry> resting_; ///< of paths that are not milled now, and may be again
    std::int64_t inForce_ = 0;
    std::optional<Running> running_;
    quint64 loads_ = 0; ///< of projects
    bool wanted_ = false, reading_ = false;
    bool interrupted_ = false; ///< an evaluation was abandoned, as the workpiece changes
};

} // namespace burin
