#include "tests/support/run_all_tests.h"

int main(int argc, char** argv) { return alltact::test::run_all_tests(argc, argv); }
