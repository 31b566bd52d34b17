// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/export/contents.h"
#include "analysis/export/table_writer.h"
#include "renderer/base/files.h"
#include "tests/support/temporary_folder.h"

namespace obscura::tests {

/// The trials of the contents as an export to CSV writes them.
inline std::string trials_text(const analysis::StoreContents& contents) {
    const TemporaryFolder folder;
    analysis::OutputFile file(folder / "trials.csv");
    {
        analysis::TableWriter<analysis::TrialRow> writer(analysis::trials_export().columns,
                                                         analysis::Layout::kCsv, file);
        for (const analysis::TrialRecord& trial : contents.trials) {
            for (const analysis::SessionRecord& session : contents.sessions) {
                if (session.session_id == trial.session_id) writer.write({&trial, &session});
            }
        }
    }
    file.close();
    return base::read_file(folder / "trials.csv");
}

}  // namespace obscura::tests
