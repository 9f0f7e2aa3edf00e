# Writes build_info.hpp: version, compiler, flags and the revision of the source. Called at every build; touches the file
# only where something changed.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12
  OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(revision "unknown")
endif()
file(WRITE ${OUTPUT}.new "#pragma once
#define SHMOO_VERSION \"${VERSION}\"
#define SHMOO_COMPILER \"${COMPILER}\"
#define SHMOO_FLAGS \"${FLAGS}\"
#define SHMOO_ARCHITECTURE \"${ARCHITECTURE}\"
#define SHMOO_REVISION \"${revision}\"
")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
