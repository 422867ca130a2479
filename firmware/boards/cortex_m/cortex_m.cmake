# SPDX-License-Identifier: MIT
# fixrad_cortex_m_board(): a board of which only the memories differ; the caller's folder holds memory.ld.
set(FIXRAD_CORTEX_M_DIR "${CMAKE_CURRENT_LIST_DIR}")
function(fixrad_cortex_m_board)
  fixrad_board(SOURCES "${FIXRAD_CORTEX_M_DIR}/startup.cpp" LINKER_SCRIPT memory.ld
    SCRIPT_PARTS "${FIXRAD_CORTEX_M_DIR}/sections.ld")
endfunction()
