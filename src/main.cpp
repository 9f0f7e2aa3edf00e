#include "run/command_line.hpp"

int main(int argc, char** argv) { return shmoo::run::command_line(argc, argv); }
