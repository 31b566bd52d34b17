# cmake -DROOT=... -DFILE=... -P commit.cmake: writes FILE, the commit of the repository in ROOT; with
# a + where files were changed since. Empty where ROOT is none.
execute_process(COMMAND git describe --always --exclude * --abbrev=12 --dirty=+
    WORKING_DIRECTORY ${ROOT} OUTPUT_VARIABLE commit ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
file(WRITE "${FILE}.new" "#pragma once\n#define OBSCURA_COMMIT \"${commit}\"\n")
file(COPY_FILE "${FILE}.new" "${FILE}" ONLY_IF_DIFFERENT)
