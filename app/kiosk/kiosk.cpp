// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/kiosk.h"

#include <fmt/format.h>
// Only to wake the window.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <exception>
#include <optional>

#include "analysis/store/address.h"
#include "analysis/store/store.h"
#include "analysis/store/withdraw.h"
#include "app/kiosk/clock.h"
#include "app/kiosk/machine.h"
#include "app/kiosk/machine_lines.h"
#include "app/kiosk/operators_page.h"
#include "app/kiosk/pin.h"
#include "app/kiosk/recording.h"
#include "app/kiosk/screen_saver.h"
#include "app/kiosk/session_runner.h"
#include "app/kiosk/start_checks.h"
#include "app/kiosk/stimulus_view.h"
#include "app/kiosk/store_lock.h"
#include "app/kiosk/timing.h"
#include "renderer/base/error.h"
#include "renderer/base/log.h"
#include "renderer/base/version.h"
#include "stimuli/manifest.h"

namespace obscura::app::kiosk {
namespace {

using analysis::Kind;
using End = SessionRunner::End;

/// A machine that was busy just then is not one whose swaps do not wait.
[[nodiscard]] Pace steady_pace(Window& window, int grey_level) {
    constexpr int kTries = 4;
    Pace pace = measure_pace(window, grey_level);
    for (int i = 1; i < kTries && !pace.locked; ++i) pace = measure_pace(window, grey_level);
    return pace;
}

/// The last self-test counts only for the monitor and GPU that it was made on.
[[nodiscard]] std::string timing_of(const KioskOptions& options, const stimuli::Study& study,
                                    const Window& window, const Pace& pace) {
    std::optional<SelfTest> last = last_self_test(options.data);
    if (last &&
        (last->display != window.display() || last->gpu_renderer != window.gpu_renderer())) {
        base::log::warn(
            "the last self-test was made on {}, {}: make one here with obscura run "
            "--selftest",
            last->display, last->gpu_renderer);
        last.reset();
    }
    const DisplayFacts facts = known_displays(options.data).facts[window.monitor_name()];
    const Extent monitor = window.monitor_size();
    return session_timing(
        window.time_source(), pace.measured_s * 1000.0, pace.locked, last,
        screen_json(facts, {monitor.width, monitor.height}, {study.width, study.height}));
}

/// The monitor is the next start's too, and what was said of it holds until something else is.
void remember(const KioskOptions& options, const Window& window) {
    KnownDisplays displays = known_displays(options.data);
    DisplayFacts& facts = displays.facts[window.monitor_name()];
    facts = facts.with(options.facts);
    displays.monitor = window.monitor_name();
    keep(options.data, displays);
}

[[nodiscard]] bool is_file(const std::string& store_url) {
    return store_url.starts_with("sqlite3://");
}

[[nodiscard]] std::string saved_note(const stimuli::Words& words, const std::string& store_url) {
    if (!is_file(store_url)) return words("all_saved");
    return words("all_saved_in", {{"file", std::filesystem::path(store_url).filename().string()}});
}

constexpr std::size_t kBackupsKept = 20;

/// One kiosk in its window.
class Kiosk {
  public:
    Kiosk(const stimuli::Study& study, const stimuli::Manifest& manifest, analysis::Store& store,
          Stage& stage, const KioskOptions& options, std::optional<Spool> spool)
        : study_(study),
          manifest_(manifest),
          store_(store),
          stage_(stage),
          options_(options),
          operators_(stage, hooks()),
          spool_(std::move(spool)) {
        machine_ = {
            base::program_version(),     operating_system(),
            stage.window.gpu_renderer(), stage.window.display(),
            stage.window.refresh_hz(),   timing_of(options, study, stage.window, stage.pace)};
    }

    void run() {
        if (spool_ && spool_->waits()) {
            const auto delivered = with_store("deliver what was kept on this machine", [&] {
                spool_->deliver(store_);
                return true;
            });
            if (!delivered) return;
        }
        const auto cut_off =
            with_store("find the sessions that were cut off", [&] { return cut_off_sessions(); });
        if (!cut_off) return;
        End end = End::kDone;
        for (std::size_t i = 0; i < cut_off->size() && end == End::kDone; ++i) {
            end = settle(cut_off->at(i));
        }
        while (end == End::kDone) {
            end = run_new_session();
            back_up();
        }
    }

    /// Rows that the operator gave up.
    [[nodiscard]] std::size_t unsaved() const { return unsaved_; }

  private:
    /// What `work` gives; nothing: the store failed and the operator left. A full-screen kiosk
    /// stays on the screen whatever the store does between sessions.
    template <typename Work>
    [[nodiscard]] auto with_store(const char* purpose, const Work& work)
        -> std::optional<decltype(work())> {
        while (true) {
            try {
                bool page_shown = false;
                return done_aside(stage_, page_shown, work);
            } catch (const std::exception& error) {
                base::log::error("cannot {}: {}", purpose, error.what());
                const Trouble trouble{study_.words("store_silent"),
                                      fmt::format("cannot {}: {}", purpose, error.what()),
                                      study_.words("store_silent_text")};
                if (ask_about_trouble(stage_, trouble) == TroubleChoice::kLeave) {
                    return std::nullopt;
                }
            }
        }
    }

    /// Open sessions that nobody is at. On a server one of another kiosk is taken to be under way
    /// until nothing has come from it for a while.
    [[nodiscard]] std::vector<analysis::SessionRecord> cut_off_sessions() {
        constexpr double kLongestSilence_s = 3600.0;
        auto sessions = store_.open_sessions(study_.name, Kind::kParticipant);
        if (!spool_) return sessions;
        const std::string now = utc_now();
        std::erase_if(sessions, [&](const analysis::SessionRecord& session) {
            if (spool_->is_own(session.session_id)) return false;
            std::string latest = session.started_utc;
            for (const auto& trial : store_.trials_of(session.session_id)) {
                latest = std::max(latest, trial.answered_utc);
            }
            for (const auto& event : store_.events_of(session.session_id)) {
                latest = std::max(latest, event.time_utc);
            }
            return seconds_between(latest, now) < kLongestSilence_s;
        });
        return sessions;
    }

    /// After each session; that it cannot be is said, and keeps nobody from taking part.
    void back_up() {
        try {
            const auto file = store_.back_up(options_.backups, utc_now(), kBackupsKept);
            if (file) base::log::info("the answers are copied to {}", file->string());
        } catch (const std::exception& error) {
            base::log::warn("the answers are saved, but not copied: {}", error.what());
        }
    }

    [[nodiscard]] OperatorHooks hooks() {
        OperatorHooks hooks;
        hooks.report = [this] { return operator_report(store_, study_); };
        hooks.back_up = [this] {
            const auto file = store_.back_up(options_.backups, utc_now(), kBackupsKept);
            return file ? study_.words("op_backed_up", {{"file", file->filename().string()}})
                        : study_.words("op_server_backs_up");
        };
        hooks.withdraw = [this](const analysis::SessionRecord& session) {
            (void)analysis::withdraw_participant(options_.store_url, session.participant_id,
                                                 utc_now());
            return study_.words("op_withdrawn", {{"folder", options_.backups.string()}});
        };
        hooks.machine_lines = [this] {
            auto lines = machine_lines(study_.words, options_.data, machine_.timing);
            if (!options_.windowed && !stage_.window.has_all_keys()) {
                lines.push_back(study_.words("op_keys_free"));
            }
            return lines;
        };
        hooks.pin = pin_file(options_.data);
        return hooks;
    }

    End run_new_session() {
        struct Known {
            std::vector<std::uint64_t> slots;
            std::vector<std::string> codes;
        };
        const auto taken = with_store("find the next order of the pairs", [&] {
            return Known{store_.taken_slots(study_.name, study_.seed, Kind::kParticipant),
                         store_.codes_of(study_.name)};
        });
        if (!taken) return End::kLeft;
        SessionPlan plan = new_plan(taken->slots);
        plan.known_codes = taken->codes;
        Procedure procedure(study_, std::move(plan));
        return play(procedure, {});
    }

    [[nodiscard]] SessionPlan new_plan(const std::vector<std::uint64_t>& taken) const {
        SessionPlan plan;
        plan.participant_id = unique_id("p");
        plan.session_id = unique_id("s");
        plan.images = images_of(study_, manifest_);
        plan.questions = options_.questions;
        plan.machine = machine_;
        plan.override_reason = options_.override_reason;
        plan.order = study_.session_order(stimuli::next_slot(taken));
        return plan;
    }

    End play(Procedure& procedure, std::vector<Row> rows) {
        Journal journal = spool_ ? journal_to(store_, study_, procedure, *spool_)
                                 : journal_to(store_, study_, procedure);
        journal.add(std::move(rows));
        const End end = SessionRunner(stage_, procedure, journal, operators_).run();
        unsaved_ += journal.waiting().size();
        return end;
    }

    /// Asks the operator about a session that was cut off, and does what was chosen.
    End settle(const analysis::SessionRecord& session) {
        struct SoFar {
            std::vector<analysis::TrialRecord> trials;
            std::vector<analysis::EventRecord> events;
        };
        const auto so_far = with_store("read a session that was cut off", [&] {
            return SoFar{store_.trials_of(session.session_id), store_.events()};
        });
        if (!so_far) return End::kLeft;
        const auto& trials = so_far->trials;
        CutOffSession shown;
        SessionPlan plan;
        try {
            plan = plan_to_resume(study_, manifest_, session, trials, so_far->events);
            plan.questions = options_.questions;
            shown = cut_off_session(study_, plan, session, trials, so_far->events);
        } catch (const base::Error& error) {
            const auto counted = std::count_if(trials.begin(), trials.end(), [](const auto& trial) {
                return trial.kind != Kind::kPractice;
            });
            shown = {session.session_id, session.started_utc, static_cast<int>(counted),
                     session.condition_count, error.what()};
            base::log::warn("session {} cannot be continued: {}", session.session_id, error.what());
        }
        const std::optional<CutOffChoice> choice = decide(shown);
        if (!choice) return End::kLeft;
        if (*choice == CutOffChoice::kAbandon) {
            const auto closed = with_store("close a session that was cut off",
                                           [&] { return close(session.session_id); });
            return closed ? End::kDone : End::kLeft;
        }
        const bool instructions_read =
            std::any_of(so_far->events.begin(), so_far->events.end(), [&](const auto& event) {
                return event.session_id == session.session_id &&
                       event.name == kInstructionsReadEvent;
            });
        return resume(session, trials, so_far->events, instructions_read, std::move(plan));
    }

    /// Closing a session for good is asked about twice.
    [[nodiscard]] std::optional<CutOffChoice> decide(const CutOffSession& session) {
        while (true) {
            const std::optional<CutOffChoice> choice = ask_about_cut_off(stage_, session);
            if (choice != CutOffChoice::kAbandon) return choice;
            const std::optional<bool> sure = ask_whether_to_abandon(stage_, session);
            if (!sure) return std::nullopt;
            if (*sure) return choice;
        }
    }

    /// True; also where an earlier try has closed it already.
    bool close(const std::string& session_id) {
        const auto open = store_.open_sessions(study_.name, Kind::kParticipant);
        const bool is_open = std::any_of(open.begin(), open.end(), [&](const auto& session) {
            return session.session_id == session_id;
        });
        if (is_open) store_.abandon_session(session_id, utc_now(), "closed by the operator");
        return true;
    }

    End resume(const analysis::SessionRecord& session,
               const std::vector<analysis::TrialRecord>& trials,
               const std::vector<analysis::EventRecord>& events, bool instructions_read,
               SessionPlan plan) {
        plan.machine = machine_;
        plan.override_reason = options_.override_reason;
        const Moment now = moment_now();
        double elapsed_s = std::max(0.0, seconds_between(session.started_utc, now.utc));
        if (!trials.empty()) {
            // Onsets keep growing even where the wall clock was set back.
            elapsed_s =
                std::max(elapsed_s, trials.back().question_onset_s + trials.back().response_time_s);
        }
        if (spool_) follow(session, trials);
        Procedure procedure(study_, std::move(plan));
        return play(procedure, procedure.resume(trials, instructions_read, elapsed_s, now, events));
    }

    /// Makes a session that goes on whole for the spool, as far as the server had it.
    void follow(const analysis::SessionRecord& session,
                const std::vector<analysis::TrialRecord>& trials) {
        for (const auto& participant : store_.participants()) {
            if (participant.participant_id != session.participant_id) continue;
            spool_->follow(BeginSession{participant, session, {}});
        }
        for (const analysis::TrialRecord& trial : trials) spool_->follow(trial);
    }

    const stimuli::Study& study_;
    const stimuli::Manifest& manifest_;
    analysis::Store& store_;
    Stage& stage_;
    const KioskOptions& options_;
    OperatorsPage operators_;
    std::optional<Spool> spool_;  ///< of a store on a server
    Machine machine_;
    std::size_t unsaved_ = 0;
};

}  // namespace

WindowOptions window_options(const stimuli::Study& study, const KioskOptions& options) {
    const Extent image{study.width, study.height};
    const bool beside = study.presentation.layout == stimuli::Layout::kSideBySide;
    WindowOptions wanted{0, options.windowed, beside ? room_beside(image) : image};
    wanted.patch = options.photodiode;
    const std::string monitor =
        options.monitor.empty() ? known_displays(options.data).monitor : options.monitor;
    const bool is_number =
        !monitor.empty() && monitor.size() <= 2 &&
        std::all_of(monitor.begin(), monitor.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (is_number) {
        wanted.monitor = std::stoi(monitor);
    } else {
        wanted.monitor_name = monitor;
    }
    return wanted;
}

void run_kiosk(const stimuli::Study& study, const KioskOptions& options) {
    refuse_incomplete_stimuli(study, options.folder, options.remedy);
    const stimuli::Manifest manifest = stimuli::load_manifest(options.folder / "manifest.json");
    refuse_alike_pairs(study, manifest, options.folder);
    // The monitor is refused before the store is touched.
    Window window(window_options(study, options));
    remember(options, window);
    const ScreenSaverHold awake;
    base::log::info(
        "{}", awake.by().empty()
                  ? std::string("nothing holds off screen saver and power saving: "
                                "switch them off")
                  : fmt::format("screen saver and power saving are held off by {}", awake.by()));
    std::optional<ResponseBox> box;
    if (!options.response_box.device.empty()) {
        box.emplace(options.response_box, [] { glfwPostEmptyEvent(); });
        window.listen_to(&*box);
    }
    // Opened once to refuse what is no store before a lock is made beside it, and again under the
    // lock: `obscura demo` may have replaced the file in between.
    (void)analysis::Store(options.store_url, analysis::Store::Access::kReadWrite);
    const StoreLock lock(options.store_url);
    analysis::Store store(options.store_url, analysis::Store::Access::kReadWrite);
    const Pace pace = steady_pace(window, study.presentation.grey_level);
    unless_overridden(options.override_reason, [&] { refuse_full_disk(options.store_url); });
    unless_overridden(options.override_reason, [&] { refuse_clock_that_ran_backwards(store); });
    if (!options.windowed)
        unless_overridden(options.override_reason, [&] { refuse_loose_pace(pace, window); });
    Ui ui(window, study.words, study.presentation.grey_level);
    Stage stage{window,         ui,   study,
                options.folder, pace, saved_note(study.words, options.store_url)};
    base::log::info("kiosk on {}, {}, {}", window.display(), window.gpu_renderer(),
                    stage.pace.locked ? "presenting waits for the refresh"
                                      : "presenting does not wait for the refresh");
    base::log::info("answers go to {}", analysis::without_password(options.store_url));
    if (is_file(options.store_url)) {
        base::log::info(
            "that one file has every answer whenever a page is shown: copy it as it is");
    }
    base::log::info("{}", stimuli::Words()("operators_key"));
    std::optional<Spool> spool;
    if (!is_file(options.store_url))
        spool.emplace(options.backups.parent_path(), options.store_url);
    Kiosk kiosk(study, manifest, store, stage, options, std::move(spool));
    kiosk.run();
    if (kiosk.unsaved() > 0) {
        throw base::failure(
            "{} could not be saved in {}: what was answered stands above",
            kiosk.unsaved() == 1 ? "1 row" : fmt::format("{} rows", kiosk.unsaved()),
            analysis::without_password(options.store_url));
    }
    store.require_in_place();
}

}  // namespace obscura::app::kiosk
