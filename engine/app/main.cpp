#include <iostream>

#include "engine/app/command_line.h"

int main(int argc, char** argv) { return dda::run_command_line(argc, argv, std::cout, std::cerr); }
