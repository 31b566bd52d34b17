// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/kiosk.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "analysis/store/store.h"
#include "app/kiosk/clock.h"
#include "app/kiosk/machine.h"
#include "app/kiosk/recording.h"
#include "app/kiosk/session_runner.h"
#include "renderer/base/error.h"
#include "renderer/base/log.h"
#include "stimuli/manifest.h"

namespace obscura::app::kiosk {
namespace {

using analysis::Kind;
using End = SessionRunner::End;

void refuse_incomplete_stimuli(const stimuli::Study& study, const std::filesystem::path& folder) {
    const std::vector<std::string> problems = stimuli::problems_of_stimuli(study, folder);
    if (problems.empty()) return;
    throw base::bad_input("the stimuli of {} are not ready:\n  {}\nmake them with: obscura render",
                          study.name, fmt::join(problems, "\n  "));
}

/// One kiosk in its window.
class Kiosk {
  public:
    Kiosk(const stimuli::Study& study, const stimuli::Manifest& manifest, analysis::Store& store,
          Stage& stage)
        : study_(study), manifest_(manifest), store_(store), stage_(stage) {
        machine_ = {software_version(), operating_system(), stage.window.gpu_renderer(),
                    stage.window.display(), stage.window.refresh_hz()};
    }

    void run() {
        for (const analysis::SessionRecord& session :
             store_.open_sessions(study_.name, Kind::kParticipant)) {
            if (settle(session) == End::kLeft) return;
        }
        while (run_new_session() == End::kDone) {
        }
    }

  private:
    End run_new_session() {
        Procedure procedure(study_, new_plan());
        return play(procedure, {});
    }

    [[nodiscard]] SessionPlan new_plan() {
        SessionPlan plan;
        plan.participant_id = unique_id("p");
        plan.session_id = unique_id("s");
        plan.images = images_of(study_, manifest_);
        plan.machine = machine_;
        const auto taken = store_.taken_slots(study_.name, study_.seed, Kind::kParticipant);
        plan.order = stimuli::session_order(study_.order, static_cast<int>(plan.images.size()),
                                            study_.seed, stimuli::next_slot(taken));
        return plan;
    }

    End play(Procedure& procedure, std::vector<Row> rows) {
        Journal journal = journal_to(store_);
        journal.add(std::move(rows));
        return SessionRunner(stage_, procedure, journal).run();
    }

    /// Asks the operator about a session that was cut off, and does what was chosen.
    End settle(const analysis::SessionRecord& session) {
        const auto trials = store_.trials_of(session.session_id);
        CutOffSession shown{session.session_id, session.started_utc,
                            static_cast<int>(trials.size()), session.condition_count, ""};
        SessionPlan plan;
        try {
            plan = plan_to_resume(study_, manifest_, session, trials, store_.events());
        } catch (const base::Error& error) {
            shown.refusal = error.what();
            spdlog::warn("session {} cannot be continued: {}", session.session_id, error.what());
        }
        const std::optional<CutOffChoice> choice = ask_about_cut_off(stage_, shown);
        if (!choice) return End::kLeft;
        if (*choice == CutOffChoice::kAbandon) {
            store_.abandon_session(session.session_id, utc_now(), "closed by the operator");
            return End::kDone;
        }
        return resume(session, trials, std::move(plan));
    }

    End resume(const analysis::SessionRecord& session,
               const std::vector<analysis::TrialRecord>& trials, SessionPlan plan) {
        plan.machine = machine_;
        const Moment now = moment_now();
        double elapsed_s = std::max(0.0, seconds_between(session.started_utc, now.utc));
        if (!trials.empty()) {
            // Onsets keep growing even where the wall clock was set back.
            elapsed_s =
                std::max(elapsed_s, trials.back().question_onset_s + trials.back().response_time_s);
        }
        Procedure procedure(study_, std::move(plan));
        return play(procedure, procedure.resume(trials, elapsed_s, now));
    }

    const stimuli::Study& study_;
    const stimuli::Manifest& manifest_;
    analysis::Store& store_;
    Stage& stage_;
    Machine machine_;
};

}  // namespace

void run_kiosk(const stimuli::Study& study, const KioskOptions& options) {
    refuse_incomplete_stimuli(study, options.folder);
    const stimuli::Manifest manifest = stimuli::load_manifest(options.folder / "manifest.json");
    analysis::Store store(options.store_url, analysis::Store::Access::kReadWrite);
    Window window({options.monitor, options.windowed, {study.width, study.height}});
    std::vector<std::string> texts = fixed_texts();
    texts.insert(texts.end(), {study.question, study.instructions, study.thanks});
    Ui ui(window, texts, study.grey_level);
    Stage stage{window, ui, study, options.folder, measure_pace(window, study.grey_level)};
    spdlog::info("kiosk on {}, {}, {}", window.display(), window.gpu_renderer(),
                 stage.pace.locked ? "presenting waits for the refresh"
                                   : "presenting does not wait for the refresh");
    spdlog::info("the operator leaves with Ctrl+Shift+Q");
    Kiosk(study, manifest, store, stage).run();
}

}  // namespace obscura::app::kiosk
