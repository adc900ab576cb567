// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/embedding_findings.h"

#include "ui/panels/embedding_labels.h"
#include "ui/panels/notice.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/texts.h"

#include <QStringList>

namespace burin {

EmbeddingFindings::EmbeddingFindings(QWidget* parent) : QWidget(parent), notice_(new Notice(this)) {
    setObjectName(QStringLiteral("embeddingFindings"));
    QVBoxLayout* column = makePanelLayout(this);
    column->addWidget(makeSectionTitle(tr("Findings of embedding"), this));
    notice_->setObjectName(QStringLiteral("findingsNotice"));
    column->addWidget(notice_);
    refresh();
}

void EmbeddingFindings::setUnit(LengthUnit unit) {
    unit_ = unit;
    refresh();
}

void EmbeddingFindings::setFindings(const std::vector<EmbeddingFinding>& findings) {
    findings_ = findings;
    refresh();
}

/// Only the first ones are shown in full; a broken model may have hundreds.
void EmbeddingFindings::refresh() {
    constexpr std::size_t most = 4;
    QStringList sentences;
    for (const EmbeddingFinding& finding : findings_) {
        if (static_cast<std::size_t>(sentences.size()) == most) break;
        sentences.append(embeddingText(finding, unit_));
    }
    if (findings_.size() > most)
        sentences.append(tr("And %1 more, which “burin embed” lists.").arg(countText(findings_.size() - most)));
    notice_->tell(Notice::Kind::warning, sentences.join(QLatin1Char('\n')));
    setVisible(!findings_.empty());
}

} // namespace burin
