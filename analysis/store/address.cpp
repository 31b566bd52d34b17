// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/store/address.h"

#include <fmt/format.h>
#include <libpq-fe.h>

#include <cctype>
#include <cstring>
#include <memory>
#include <regex>
#include <string_view>

#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

constexpr std::string_view kSqliteScheme = "sqlite3://";

struct FreeOptions {
    void operator()(PQconninfoOption* options) const { PQconninfoFree(options); }
};
using ConnectionOptions = std::unique_ptr<PQconninfoOption, FreeOptions>;

/// RFC 3986 percent-encoding of all but unreserved characters.
std::string encoded(std::string_view text) {
    std::string result;
    for (const char byte : text) {
        const auto code = static_cast<unsigned char>(byte);
        if (std::isalnum(code) != 0 || std::strchr("-._~", byte) != nullptr) {
            result += byte;
        } else {
            result += fmt::format("%{:02X}", code);
        }
    }
    return result;
}

bool is_postgresql(const std::string& url) {
    if (url.starts_with("postgresql://") || url.starts_with("postgres://")) return true;
    return url.find("://") == std::string::npos && url.find('=') != std::string::npos;
}

ConnectionOptions parsed(const std::string& url) {
    char* reason = nullptr;
    ConnectionOptions options(PQconninfoParse(url.c_str(), &reason));
    if (options) return options;
    // libpq's reason repeats the URL.
    std::string said = reason != nullptr ? reason : "no memory";
    PQfreemem(reason);
    const std::string shown = without_password(url);
    for (auto at = said.find(url); at != std::string::npos;
         at = said.find(url, at + shown.size())) {
        said.replace(at, url.size(), shown);
    }
    if (shown != url) said = said.substr(0, said.find(':'));
    while (!said.empty() && said.back() == '\n') said.pop_back();
    throw base::bad_input("the store '{}' is no address of a PostgreSQL server: {}", shown, said);
}

/// As one URI whose every part is a parameter: SOCI takes the text apart at blanks, keeps what has
/// an = in it, and adds one where there is none.
StoreAddress postgresql_address(const std::string& url) {
    StoreAddress address;
    address.connection = "postgresql://?fallback_application_name=obscura";
    std::string user;
    std::string host;
    std::string port;
    std::string database;
    bool has_timeout = false;
    const ConnectionOptions options = parsed(url);
    for (const PQconninfoOption* option = options.get(); option->keyword != nullptr; ++option) {
        if (option->val == nullptr || *option->val == '\0') continue;
        const std::string_view keyword = option->keyword;
        if (keyword == "user") user = option->val;
        if (keyword == "host" || (keyword == "hostaddr" && host.empty())) host = option->val;
        if (keyword == "port") port = option->val;
        if (keyword == "dbname") database = option->val;
        if (keyword == "service") database = "?service=" + std::string(option->val);
        if (keyword == "connect_timeout" || keyword == "tcp_user_timeout") has_timeout = true;
        if (keyword == "fallback_application_name") continue;
        address.connection += fmt::format("&{}={}", keyword, encoded(option->val));
    }
    // A server that does not answer is away, and nobody sits waiting before a page.
    if (!has_timeout) address.connection += "&connect_timeout=5&tcp_user_timeout=10000";
    address.shown = fmt::format("postgresql://{}{}{}{}/{}", user, user.empty() ? "" : "@", host,
                                port.empty() ? "" : ":" + port, database);
    return address;
}

}  // namespace

std::string without_password(const std::string& url) {
    if (!is_postgresql(url)) return url;
    // Of a URI's authority, and of what is given by name in either form.
    static const std::regex kOfUser("^([a-z]+://[^:/?@]*):[^/?]*@");
    static const std::regex kNamed(
        R"re(((?:^|[?&\s])(?:ssl)?password\s*=\s*)('(?:[^'\\]|\\.)*'?|[^&\s]*))re");
    std::string shown = std::regex_replace(url, kOfUser, "$1:***@");
    return std::regex_replace(shown, kNamed, "$1***");
}

StoreAddress store_address(const std::string& url) {
    if (url.starts_with(kSqliteScheme) && url.size() > kSqliteScheme.size()) {
        const std::string file = url.substr(kSqliteScheme.size());
        return {file, "", file};
    }
    if (is_postgresql(url)) return postgresql_address(url);
    throw base::bad_input("the store '{}' is no URL of a store, allowed are {}FILE and {}...", url,
                          kSqliteScheme, "postgresql://");
}

}  // namespace obscura::analysis
