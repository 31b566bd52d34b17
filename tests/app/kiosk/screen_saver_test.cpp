// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Screen saver and power saving, by a desktop on a bus of the test's own and by the X server.
#include <gio/gio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "app/kiosk/screen_saver.h"
#include "tests/app/kiosk/virtual_display.h"

namespace obscura::app::kiosk {
namespace {

using testing::ElementsAre;

constexpr const char* kInterface =
    "<node><interface name='org.freedesktop.ScreenSaver'>"
    "<method name='Inhibit'><arg type='s' direction='in'/><arg type='s' direction='in'/>"
    "<arg type='u' direction='out'/></method>"
    "<method name='UnInhibit'><arg type='u' direction='in'/></method>"
    "</interface></node>";

/// A desktop that notes what it is asked, on a thread of its own.
class Desktop {
  public:
    explicit Desktop(const std::string& address)
        : context_(g_main_context_new()), loop_(g_main_loop_new(context_, FALSE)) {
        std::atomic<bool> ready{false};
        thread_ = std::thread([this, address, &ready] {
            g_main_context_push_thread_default(context_);
            const auto flags =
                static_cast<GDBusConnectionFlags>(G_DBUS_CONNECTION_FLAGS_AUTHENTICATION_CLIENT |
                                                  G_DBUS_CONNECTION_FLAGS_MESSAGE_BUS_CONNECTION);
            bus_ = g_dbus_connection_new_for_address_sync(address.c_str(), flags, nullptr, nullptr,
                                                          nullptr);
            GDBusNodeInfo* const node = g_dbus_node_info_new_for_xml(kInterface, nullptr);
            static const GDBusInterfaceVTable kTable{&Desktop::called, nullptr, nullptr, {}};
            g_dbus_connection_register_object(bus_, "/org/freedesktop/ScreenSaver",
                                              node->interfaces[0], &kTable, this, nullptr, nullptr);
            g_dbus_node_info_unref(node);
            GVariant* const named = g_dbus_connection_call_sync(
                bus_, "org.freedesktop.DBus", "/org/freedesktop/DBus", "org.freedesktop.DBus",
                "RequestName", g_variant_new("(su)", "org.freedesktop.ScreenSaver", 0U), nullptr,
                G_DBUS_CALL_FLAGS_NONE, -1, nullptr, nullptr);
            g_variant_unref(named);
            ready = true;
            g_main_loop_run(loop_);
            g_object_unref(bus_);
            g_main_context_pop_thread_default(context_);
        });
        while (!ready) std::this_thread::yield();
    }
    ~Desktop() {
        g_main_loop_quit(loop_);
        thread_.join();
        g_main_loop_unref(loop_);
        g_main_context_unref(context_);
    }
    [[nodiscard]] const std::vector<std::string>& asked() const { return asked_; }

  private:
    static void called(GDBusConnection*, const char*, const char*, const char*, const char* method,
                       GVariant* values, GDBusMethodInvocation* call, void* self) {
        auto& asked = static_cast<Desktop*>(self)->asked_;
        asked.emplace_back(method);
        if (asked.back() == "Inhibit") {
            g_dbus_method_invocation_return_value(call, g_variant_new("(u)", 77U));
            return;
        }
        unsigned cookie = 0;
        g_variant_get(values, "(u)", &cookie);
        asked.back() += ' ' + std::to_string(cookie);
        g_dbus_method_invocation_return_value(call, nullptr);
    }

    GMainContext* context_;
    GMainLoop* loop_;
    GDBusConnection* bus_ = nullptr;
    std::vector<std::string> asked_;  ///< read between the calls, which wait for their answer
    std::thread thread_;
};

TEST(ScreenSaver, OfADesktopIsHeldOffAndGivenBackAtTheEnd) {
    GTestDBus* const bus = g_test_dbus_new(G_TEST_DBUS_NONE);
    g_test_dbus_up(bus);
    {
        const Desktop desktop(g_test_dbus_get_bus_address(bus));
        {
            const ScreenSaverHold hold;
            EXPECT_EQ(hold.by(), "org.freedesktop.ScreenSaver");
            EXPECT_THAT(desktop.asked(), ElementsAre("Inhibit"));
        }
        EXPECT_THAT(desktop.asked(), ElementsAre("Inhibit", "UnInhibit 77"));
    }
    g_test_dbus_down(bus);
    g_object_unref(bus);
}

TEST(ScreenSaver, WithoutADesktopIsHeldOffByTheXServer) {
    g_test_dbus_unset();
    const VirtualDisplay display(640, 480);
    const ScreenSaverHold hold;
    EXPECT_EQ(hold.by(), "the X server");
}

TEST(ScreenSaver, WithNeitherNothingHoldsItOffAndThatIsSaid) {
    g_test_dbus_unset();
    const char* const before = std::getenv("DISPLAY");
    const std::string display = before == nullptr ? "" : before;
    ::unsetenv("DISPLAY");
    const ScreenSaverHold hold;
    EXPECT_EQ(hold.by(), "");
    if (!display.empty()) ::setenv("DISPLAY", display.c_str(), 1);
}

}  // namespace
}  // namespace obscura::app::kiosk
