// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/sample_chunk.h"
#include "core/document/stores.h"
#include "core/document/working_copy.h"

#include <algorithm>
#include <utility>

namespace burin {

/// The statement is destroyed before its connection, and the connection before the working copy.
class Project::TakeWriter::Impl {
public:
    std::shared_ptr<WorkingCopy> copy;
    Database database;
    std::int64_t take = 0;
    Statement insert;
    std::uint64_t kept = 0; ///< samples on the disk
};

namespace {

Result<std::int64_t> startTake(Database& database, const TakeInfo& info) {
    Result<Transaction> whole = Transaction::begin(database, Transaction::Kind::write);
    if (!whole) return std::move(whole).error();
    Result<std::int64_t> id = storeTake(database, info);
    if (!id) return id;
    if (Result<void> counted = countChange(database); !counted) return std::move(counted).error();
    if (Result<void> committed = whole->commit(); !committed) return std::move(committed).error();
    return id;
}

} // namespace

Project::TakeWriter::TakeWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Project::TakeWriter::~TakeWriter() = default;
Project::TakeWriter::TakeWriter(TakeWriter&&) noexcept = default;
Project::TakeWriter& Project::TakeWriter::operator=(TakeWriter&&) noexcept = default;

Result<Project::TakeWriter> Project::TakeWriter::begin(std::shared_ptr<WorkingCopy> copy, const TakeInfo& info) {
    Result<Database> database = copy->connect();
    if (!database) return std::move(database).error();
    const Result<std::int64_t> id = startTake(*database, info);
    if (!id) return id.error();
    Result<Statement> insert =
        Statement::prepare(*database, "INSERT INTO sample_chunk(take, first, count, samples) VALUES(?, ?, ?, ?)");
    if (!insert) return std::move(insert).error();
    return TakeWriter(std::make_unique<Impl>(Impl{std::move(copy), std::move(*database), *id, std::move(*insert), 0}));
}

std::int64_t Project::TakeWriter::id() const noexcept {
    return impl_->take;
}

Result<void> Project::TakeWriter::append(std::span<const Sample> samples) {
    if (samples.empty()) return {};
    Result<Transaction> whole = Transaction::begin(impl_->database, Transaction::Kind::write);
    if (!whole) return std::move(whole).error();
    std::uint64_t first = impl_->kept;
    for (std::span<const Sample> rest = samples; !rest.empty();) {
        const std::span<const Sample> chunk = rest.first(std::min(rest.size(), samplesPerChunk));
        const std::string packed = encodeSamples(chunk);
        if (Result<void> bound = impl_->insert.bind(impl_->take, first, chunk.size(), BlobView{packed}); !bound)
            return bound;
        if (Result<void> done = impl_->insert.run(); !done) return done;
        first += chunk.size();
        rest = rest.subspan(chunk.size());
    }
    if (Result<void> counted = countChange(impl_->database); !counted) return counted;
    if (Result<void> committed = whole->commit(); !committed) return committed;
    impl_->kept = first;
    return {};
}

Result<void> Project::TakeWriter::finish() {
    Result<Transaction> whole = Transaction::begin(impl_->database, Transaction::Kind::write);
    if (!whole) return std::move(whole).error();
    if (Result<void> done = run(impl_->database, "UPDATE take SET complete = 1 WHERE id = ?", impl_->take); !done)
        return done;
    if (Result<void> counted = countChange(impl_->database); !counted) return counted;
    return whole->commit();
}

} // namespace burin
