// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/job_paths.h"
#include "core/path/kept_edits.h"
#include "ui/workbench/workpiece_controller.h"

#include <memory>
#include <optional>
#include <tuple>
#include <vector>

namespace burin {

/// Identifies what is recorded with a tool: of each take its id, number of samples, whether it is complete, and the
/// number of the newest stroke in effect. Equal if exactly the same is recorded, also after strokes were milled and
/// undone.
using RecordedKey = std::vector<std::tuple<std::int64_t, std::uint64_t, bool, std::uint64_t>>;

/// Evaluates the paths of a job in the background, one after the other, each on the stock that the paths before it
/// leave: first the path in force with those before it, then the others. A path is evaluated again if it, or one before
/// it, has changed; the previous result stays available meanwhile.
class JobEvaluation final : public QObject {
    Q_OBJECT
public:
    JobEvaluation(const Desk& desk, WorkpieceController& workpiece, QObject* parent);

    /// Sets the paths to evaluate. Paths with a known id keep their results, also those that were not among the last
    /// ones.
    /// @param inOrder order of milling @param inForce id; 0: none
    void setJob(const std::vector<StoredPath>& inOrder, std::int64_t inForce);
    /// The edits of a path have changed, or (touchAll) what all paths were evaluated on.
    void touch(std::int64_t path);
    void touchAll();
    /// Sets what is recorded with the path's tool. If it has changed, recordings that were read before are discarded;
    /// if it is again what the path was evaluated with, the path is current again.
    void setRecorded(std::int64_t path, const RecordedKey& key);
    void forget();                            ///< for another project: discards everything evaluated or read
    void start();                             ///< evaluates all paths that are out of date
    void hold() noexcept { wanted_ = false; } ///< paths that become out of date from now on wait for `start`

    /// Result of the newest successful evaluation; null: none yet.
    std::shared_ptr<const EvaluatedPath> evaluated(std::int64_t path) const;
    /// All results that exist, in order
    std::vector<std::shared_ptr<const EvaluatedPath>> allBut(std::int64_t path) const;
    std::optional<Error> problem(std::int64_t path) const; ///< error of the newest evaluation
    /// Paths milled before a path that can't be evaluated: the stock is computed without them.
    std::vector<std::int64_t> missingBefore(std::int64_t path) const;
    /// Whether the result matches the present state of the path and all paths before it.
    bool isCurrent(std::int64_t path) const;
    /// Whether the path, or one before it, is being evaluated.
    bool busy(std::int64_t path) const;

signals:
    void evaluatedAnew(qint64 path);
    /// While a path that has a result is evaluated again: the path in force after the first changed edit, without those
    /// after it; if the evaluation fails or is cancelled, the last result again. For drawing only.
    void firstResult(const std::shared_ptr<const burin::EvaluatedPath>& path);
    void changed();
    /// Newer recordings with the path's tool were added to a path.
    void recordingsAdded(const burin::StoredPath& path);

private:
    using Before = std::vector<std::shared_ptr<const EvaluatedPath>>;
    struct Recorded {
        std::vector<SourceStrokes> strokes;
        Tool tool;
    };
    /// What an evaluation depends on.
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
        std::shared_ptr<const Recorded> recorded; ///< null: not read yet
        std::shared_ptr<const EvaluatedPath> evaluated;
        Tool tool; ///< with which `evaluated` was made
        Basis evaluatedOn, failedOn;
        std::shared_ptr<KeptEdits> kept; ///< of the states of `recorded`; null: none
        std::weak_ptr<MillingContext> keptOn;
        Before keptBehind; ///< the paths before it
        std::optional<Error> problem;
    };
    struct Running {
        std::int64_t path = 0;
        Basis basis;
    };
    std::size_t placeOf(std::int64_t path) const; ///< number of entries if there is none
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
    void evaluate(Entry& entry, const Basis& basis);
    std::shared_ptr<KeptEdits> keptOf(Entry& entry, const Before& before) const;
    static void forgetRecorded(Entry& entry);
    void takeFirst(const Running& asked, const std::shared_ptr<const EvaluatedPath>& path);
    void takeEvaluated(const Running& asked, const Tool& tool, Result<EvaluatedPath> outcome);
    void readersStop();

    Desk desk_;
    WorkpieceController& workpiece_;
    std::vector<Entry> entries_; ///< in the order of milling
    std::vector<Entry> resting_; ///< paths that are not milled now, but may be again
    std::int64_t inForce_ = 0;
    std::optional<Running> running_;
    quint64 loads_ = 0; ///< number of projects loaded
    bool wanted_ = false, reading_ = false;
    bool interrupted_ = false; ///< an evaluation was abandoned because the workpiece changes
};

} // namespace burin
