#include <malloc.h>

#include "run/command_line.hpp"

int main(int argc, char** argv) {
  // Large blocks go back to the system when they are freed. Left to itself the allocator keeps ever larger ones, and
  // what a long run holds depends on the order of its requests.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  return shmoo::run::command_line(argc, argv);
}
