# cmake "-DCOMPILER=compiler;and;its;flags" -DCASE=file.cpp -DHEADER=file.h -P check_case.cmake
# HEADER comes before the case; it should have been compiled with the same flags.

file(STRINGS ${CASE} expectations REGEX "^// says: ")
list(LENGTH expectations count)
if(NOT count EQUAL 1)
  message(FATAL_ERROR "${CASE} needs one line '// says: REGEX', has ${count}")
endif()
string(REGEX REPLACE "^// says: " "" expected "${expectations}")

set(command ${COMPILER} -fsyntax-only -include ${HEADER})

execute_process(COMMAND ${command} ${CASE} RESULT_VARIABLE result ERROR_VARIABLE text)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "Without RAMBLA_WRONG it must compile:\n${text}")
endif()

execute_process(COMMAND ${command} -DRAMBLA_WRONG ${CASE} RESULT_VARIABLE result ERROR_VARIABLE text)
if(result EQUAL 0)
  message(FATAL_ERROR "With RAMBLA_WRONG it must not compile, but does")
endif()
if(NOT text MATCHES "${expected}")
  message(FATAL_ERROR "The compiler does not say \"${expected}\":\n${text}")
endif()
