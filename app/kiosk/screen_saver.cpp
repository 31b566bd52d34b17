// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/screen_saver.h"

#include <gio/gio.h>
// After GLib: Xlib defines words as macros.
#include <X11/Xlib.h>
#include <X11/extensions/scrnsaver.h>

namespace obscura::app::kiosk {
namespace {

constexpr const char* kName = "org.freedesktop.ScreenSaver";
constexpr const char* kPath = "/org/freedesktop/ScreenSaver";
constexpr int kWait_ms = 2000;

/// Calls a method of the desktop's screen saver; nullptr: it does not answer.
[[nodiscard]] GVariant* call(GDBusConnection* bus, const char* method, GVariant* values,
                             const char* reply) {
    return g_dbus_connection_call_sync(bus, kName, kPath, kName, method, values,
                                       reply == nullptr ? nullptr : G_VARIANT_TYPE(reply),
                                       G_DBUS_CALL_FLAGS_NO_AUTO_START, kWait_ms, nullptr, nullptr);
}

}  // namespace

ScreenSaverHold::ScreenSaverHold() {
    if (ask_desktop()) {
        by_ = kName;
    } else if (ask_server()) {
        by_ = "the X server";
    }
}

bool ScreenSaverHold::ask_desktop() {
    GDBusConnection* const bus = g_bus_get_sync(G_BUS_TYPE_SESSION, nullptr, nullptr);
    if (bus == nullptr) return false;
    // A bus that ends is no reason for this program to end.
    g_dbus_connection_set_exit_on_close(bus, FALSE);
    GVariant* const reply = call(
        bus, "Inhibit", g_variant_new("(ss)", "obscura", "a participant looks at images"), "(u)");
    if (reply == nullptr) {
        g_object_unref(bus);
        return false;
    }
    g_variant_get(reply, "(u)", &cookie_);
    g_variant_unref(reply);
    bus_ = bus;
    return true;
}

bool ScreenSaverHold::ask_server() {
    Display* const display = XOpenDisplay(nullptr);
    if (display == nullptr) return false;
    int event = 0;
    int error = 0;
    int major = 0;
    int minor = 0;
    // Suspending came with version 1.1.
    if (XScreenSaverQueryExtension(display, &event, &error) == 0 ||
        XScreenSaverQueryVersion(display, &major, &minor) == 0 || (major == 1 && minor < 1) ||
        major < 1) {
        XCloseDisplay(display);
        return false;
    }
    XScreenSaverSuspend(display, True);
    XSync(display, False);
    display_ = display;
    return true;
}

ScreenSaverHold::~ScreenSaverHold() {
    if (bus_ != nullptr) {
        auto* const bus = static_cast<GDBusConnection*>(bus_);
        GVariant* const reply = call(bus, "UnInhibit", g_variant_new("(u)", cookie_), nullptr);
        if (reply != nullptr) g_variant_unref(reply);
        g_object_unref(bus);
    }
    if (display_ != nullptr) {
        auto* const display = static_cast<Display*>(display_);
        XScreenSaverSuspend(display, False);
        XCloseDisplay(display);
    }
}

}  // namespace obscura::app::kiosk
