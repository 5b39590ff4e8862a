# cmake -DINPUT=prelude.udcp -DOUTPUT=prelude.cpp -P embed.cmake: a text as a function that returns it.
file(READ "${INPUT}" text)
file(WRITE "${OUTPUT}"
  "#include \"interpreter/prelude.h\"\n\nstd::string udcp::prelude_text() {\n  return R\"udcp(${text})udcp\";\n}\n")
