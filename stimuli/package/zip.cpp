// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/package/zip.h"

#include <sys/stat.h>
#include <zip.h>

#include <algorithm>
#include <set>

#include "renderer/base/error.h"

namespace obscura::stimuli {
namespace {

constexpr std::uint64_t kMega = 1'000'000;

std::string reason_of(int code) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    std::string reason = zip_error_strerror(&error);
    zip_error_fini(&error);
    return reason;
}

/// Closes without writing, unless it was closed before.
struct Discard {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
using OpenArchive = std::unique_ptr<zip_t, Discard>;

void add(zip_t* archive, const ArchivedFile& file, const std::filesystem::path& where) {
    zip_source_t* const source =
        zip_source_buffer(archive, file.bytes.data(), file.bytes.size(), 0);
    if (source == nullptr) throw base::failure("cannot write {}: out of memory", where.string());
    const zip_int64_t added =
        zip_file_add(archive, file.name.c_str(), source, ZIP_FL_ENC_UTF_8 | ZIP_FL_OVERWRITE);
    if (added < 0) {
        zip_source_free(source);
        throw base::failure("cannot write {}: {}", where.string(), zip_strerror(archive));
    }
    const auto index = static_cast<zip_uint64_t>(added);
    const bool is_packed_already = file.name.ends_with(".png");
    zip_set_file_compression(archive, index, is_packed_already ? ZIP_CM_STORE : ZIP_CM_DEFLATE, 0);
    constexpr zip_uint16_t kFirstDay = (1U << 5U) | 1U;  // 1980-01-01, the first there is
    zip_file_set_dostime(archive, index, 0, kFirstDay, 0);
    zip_file_set_external_attributes(archive, index, 0, ZIP_OPSYS_UNIX,
                                     static_cast<zip_uint32_t>(S_IFREG | 0644U) << 16U);
}

bool is_plain_file(zip_t* archive, zip_uint64_t index) {
    zip_uint8_t system = 0;
    zip_uint32_t attributes = 0;
    zip_file_get_external_attributes(archive, index, 0, &system, &attributes);
    const zip_uint32_t kind = (attributes >> 16U) & S_IFMT;
    return system != ZIP_OPSYS_UNIX || kind == 0 || kind == S_IFREG;
}

}  // namespace

bool is_inside(const std::string& name) {
    if (name.empty() || name.front() == '/' || name.back() == '/') return false;
    const bool is_plain = std::all_of(name.begin(), name.end(), [](char letter) {
        return static_cast<unsigned char>(letter) >= 0x20U && letter != '\\' && letter != ':';
    });
    if (!is_plain) return false;
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find('/', begin), name.size());
        const std::string part = name.substr(begin, end - begin);
        if (part.empty() || part == "." || part == "..") return false;
        begin = end + 1;
    }
    return true;
}

void write_zip(const std::filesystem::path& file, const std::vector<ArchivedFile>& files) {
    std::uint64_t bytes = 0;
    for (const ArchivedFile& one : files) bytes += one.bytes.size();
    if (bytes > kMostArchiveBytes) {
        throw base::bad_input("{}: its files are {} MB together, allowed are {}", file.string(),
                              bytes / kMega, kMostArchiveBytes / kMega);
    }
    int code = 0;
    // libzip writes beside and renames when the archive is closed.
    OpenArchive archive(zip_open(file.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code));
    if (!archive) throw base::failure("cannot write {}: {}", file.string(), reason_of(code));
    for (const ArchivedFile& one : files) add(archive.get(), one, file);
    if (zip_close(archive.get()) != 0) {
        throw base::failure("cannot write {}: {}", file.string(), zip_strerror(archive.get()));
    }
    (void)archive.release();
}

ZipReader::ZipReader(const std::filesystem::path& file) : file_(file) {
    int code = 0;
    archive_ = zip_open(file.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code);
    if (archive_ == nullptr) {
        throw base::bad_input("{}: it cannot be read as a ZIP archive: {}", file.string(),
                              reason_of(code));
    }
    try {
        list_entries();
    } catch (...) {
        zip_discard(archive_);
        throw;
    }
}

ZipReader::~ZipReader() { zip_discard(archive_); }

void ZipReader::list_entries() {
    std::set<std::string> names;
    std::uint64_t bytes = 0;
    const zip_int64_t count = zip_get_num_entries(archive_, 0);
    for (zip_uint64_t index = 0; index < static_cast<zip_uint64_t>(std::max<zip_int64_t>(count, 0));
         ++index) {
        zip_stat_t facts;
        zip_stat_init(&facts);
        if (zip_stat_index(archive_, index, 0, &facts) != 0 || (facts.valid & ZIP_STAT_SIZE) == 0) {
            throw base::bad_input("{}: file {} of it: {}", file_.string(), index + 1,
                                  zip_strerror(archive_));
        }
        const std::string name = facts.name;
        if (!is_inside(name)) {
            throw base::bad_input(
                "{}: it holds a file \"{}\", which would not lie below the folder it is unpacked "
                "into; allowed are relative paths without ..",
                file_.string(), name);
        }
        if (!names.insert(name).second) {
            throw base::bad_input("{}: it holds {} twice", file_.string(), name);
        }
        if (!is_plain_file(archive_, index)) {
            throw base::bad_input("{}: {} is no plain file but a link or a device", file_.string(),
                                  name);
        }
        if (facts.encryption_method != ZIP_EM_NONE) {
            throw base::bad_input("{}: {} needs a password", file_.string(), name);
        }
        if (facts.size > kMostArchiveBytes || bytes + facts.size > kMostArchiveBytes) {
            throw base::bad_input("{}: its files are more than {} MB together, which is allowed",
                                  file_.string(), kMostArchiveBytes / kMega);
        }
        bytes += facts.size;
        entries_.push_back({name, index, facts.size});
    }
}

std::string ZipReader::read(const Entry& entry) const {
    const auto fail = [&](const std::string& why) {
        return base::bad_input("{}: {}: {}", file_.string(), entry.name, why);
    };
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> stream(
        zip_fopen_index(archive_, entry.index, 0), zip_fclose);
    if (!stream) throw fail(zip_strerror(archive_));
    std::string bytes(entry.bytes, '\0');
    std::uint64_t got = 0;
    while (got < entry.bytes) {
        const zip_int64_t more = zip_fread(stream.get(), bytes.data() + got, entry.bytes - got);
        if (more < 0) throw fail(zip_file_strerror(stream.get()));
        if (more == 0) throw fail("it is cut off");
        got += static_cast<std::uint64_t>(more);
    }
    char beyond = 0;
    const zip_int64_t rest = zip_fread(stream.get(), &beyond, 1);  // its end checks its sum
    if (rest < 0) throw fail(zip_file_strerror(stream.get()));
    if (rest > 0) throw fail("it holds more than it says");
    return bytes;
}

std::vector<ArchivedFile> ZipReader::read_all() const {
    std::vector<ArchivedFile> files;
    for (const Entry& entry : entries_) files.push_back({entry.name, read(entry)});
    return files;
}

}  // namespace obscura::stimuli
