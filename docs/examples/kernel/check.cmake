# Runs an example and compares the numbers in its output with theory:
#   cmake -DPROGRAM=... "-DPATTERN=throughput ([0-9.]+)" -DLOW=0.82 -DHIGH=0.85 -P check.cmake
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE output RESULT_VARIABLE result)
message(STATUS "${output}")
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} failed: ${result}")
endif()
if(NOT output MATCHES "${PATTERN}")
  message(FATAL_ERROR "output does not match '${PATTERN}'")
endif()
if(CMAKE_MATCH_1 LESS "${LOW}" OR CMAKE_MATCH_1 GREATER "${HIGH}")
  message(FATAL_ERROR "${CMAKE_MATCH_1} is not between ${LOW} and ${HIGH}")
endif()
