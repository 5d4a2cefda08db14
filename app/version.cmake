# SPDX-License-Identifier: MIT
# Runs with every build: asks git which commit this is. configure_file leaves the file alone where nothing changed.
set(GIT "unknown")
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=10
  OUTPUT_VARIABLE described RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
# A tarball unpacked inside somebody else's checkout is not that checkout.
execute_process(COMMAND git -C ${SOURCE} rev-parse --show-prefix
  OUTPUT_VARIABLE prefix ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
if("${failed}" STREQUAL "0" AND "${prefix}" STREQUAL "")
  set(GIT ${described})
endif()
configure_file(${SOURCE}/app/version.cpp.in ${OUTPUT} @ONLY)
