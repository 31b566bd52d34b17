// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/formats.h"
#include "analysis/text/embedded.h"

namespace obscura::analysis {

void add_scripts(const ExportJob& job, const std::string& folder) {
    for (const std::string name : {"main_tests.R", "main_tests.py"}) {
        job.folder.add(folder + name, embedded("export/" + name));
    }
}

}  // namespace obscura::analysis
